// Fuzz target: whatever the bytes are, reading them as OBJ and as MTL ends with a scene or with InputError.
//
// With clang's libFuzzer this is the target (option COB_FUZZ); without it, the main at the end changes the seeds
// below at random, which ctest runs and which fails unless scenes and refusals both occur often.
#include "cob/census.hpp"
#include "cob/error.hpp"
#include "scene/materials.hpp"
#include "scene/obj.hpp"

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

namespace {

struct Outcomes {
    long scenes = 0, polygons = 0, invalid = 0, refused = 0;
};

void require(bool condition, const char* what) {
    if (condition) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

void check(const cob::Scene& scene) {
    for (const cob::Piece& piece : scene.pieces()) {
        require(piece.corner_count >= 3, "a piece has three corners");
        require(cob::cut_into_triangles(scene, piece).size() <= piece.corner_count - 2, "not too many triangles");
    }
    std::size_t valid = 0;
    for (cob::PolygonId id = 0; id < scene.polygon_count(); ++id) {
        require(scene.polygon(id).valid == (scene.polygon(id).piece_count > 0), "valid polygons have pieces");
        valid += scene.polygon(id).valid ? 1 : 0;
    }
    require(valid + scene.invalid().size() == scene.polygons().size(), "every polygon is valid or invalid");
    const cob::Census census = cob::take_census(scene, {100});
    require(census.valid == valid, "the census counts all");
}

void read_both(std::string_view text, Outcomes& outcomes) {
    const cob::ReadOptions options{true, false};
    cob::ReadReport report;
    const std::string path = "/nowhere/fuzz.obj";
    try {
        const cob::Scene scene = cob::Scene::build(cob::parse_obj(text, path, options, report), {true});
        check(scene);
        ++outcomes.scenes;
        outcomes.polygons += scene.polygon_count();
        outcomes.invalid += static_cast<long>(scene.invalid().size());
    } catch (const cob::InputError& error) {
        require(error.what()[0] != '\0' && !error.where().file.empty(), "a refusal says what and where");
        ++outcomes.refused;
    }
    try {
        cob::MaterialLibrary library(path, options, report);
        library.read_text(text, "fuzz.mtl");
    } catch (const cob::InputError&) {
    }
}

}  // namespace

#ifdef COB_LIBFUZZER

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Outcomes outcomes;
    read_both({reinterpret_cast<const char*>(data), size}, outcomes);
    return 0;
}

#else

namespace {

const char* const seeds[] = {
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf -4 -3 -2\n",
    "mtllib a b.mtl\r\nv 0 0 0 1\r\nv 2 0 0 0.5 .25 1\r\nv 2 2 0x1p-3\r\nusemtl a\r\nf 1/1 2//2 3/3/3\r\n",
    ("# holes on bridges\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n"
     "f 1 2 3 4 1 5 6 7 8 5\nf 4 3 2 1\nf 1 2 7 6\n"),
    "v 1e300 -1e300 5e-324\nv 1e-300 0 -0\nv 3e307 1 1\nv 1e308 1e308 1e308\nf 1 2 3 \\\n 4\nf 4 3 2 1\n",
    "newmtl lamp\nKd .5 .5 .5\nKe 10 10 10\nnewmtl grey # name\nKd 1\nmap_Kd x.png\nTf 1 1 1\n",
    "v 0 0 0\nv 1 0 1\nv 1 1 0\nv 0 1 1\nv 2 2 2\nf 1 2 3 4\nf 1 3 2 4\nf 1 2 1 2\nf 1 1 1\nf 1 2\nf 1 2 3 4 5\n",
};
const char* const words[] = {"v ",          "f ",
                             "\n",          "-1 ",
                             "1e999",       "nan ",
                             "1e-400",      "/",
                             "//",          "\\\n",
                             "usemtl ",     "\r",
                             "mtllib",      "0 ",
                             "2 ",          "3 ",
                             "4 ",          "1e308 ",
                             "Kd ",         "Ke -1",
                             "#",           "99999999999999999999",
                             "\t",          "f 1 2 3\n",
                             "f 4 3 2 1\n", "newmtl ",
                             "v 0 0 1\n",   "v 1 1 1\n",
                             "0x",          ".",
                             "1 "};

std::string mutated(std::mt19937_64& engine) {
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(engine() % n); };
    std::string text = seeds[below(std::size(seeds))];
    for (std::size_t change = below(6); change > 0 && !text.empty(); --change) {
        const std::size_t at = below(text.size());
        switch (below(5)) {
            case 0:
                text[at] = static_cast<char>(engine());
                break;
            case 1:
                text.erase(at, 1 + below(8));
                break;
            case 2:
                text.insert(at, words[below(std::size(words))]);
                break;
            case 3:
                text.insert(at, text.substr(below(text.size()), below(40)));
                break;
            default:
                text += seeds[below(std::size(seeds))];
                break;
        }
    }
    if (below(8) == 0) text.resize(below(text.size() + 1));
    return text;
}

}  // namespace

int main(int argc, char** argv) {
    const long rounds = argc > 1 ? std::atol(argv[1]) : 20000;
    Outcomes outcomes;
    for (long round = 0; round < rounds; ++round) {
        std::mt19937_64 engine(static_cast<std::uint64_t>(round));
        read_both(mutated(engine), outcomes);
    }
    std::printf("%ld scenes with %ld polygons, %ld of them invalid; %ld refused\n", outcomes.scenes, outcomes.polygons,
                outcomes.invalid, outcomes.refused);
    const long least = rounds / 20;
    return outcomes.scenes > least && outcomes.refused > least && outcomes.invalid > least ? 0 : 1;
}

#endif
