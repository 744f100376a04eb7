// Scenes: any bytes as OBJ and as MTL.
#include "scene/obj.hpp"
#include "cob/census.hpp"
#include "cob/error.hpp"
#include "fuzz/target.hpp"
#include "scene/materials.hpp"

namespace cob::fuzz {
namespace {

void check(const Scene& scene) {
    for (const Piece& piece : scene.pieces()) {
        require(piece.corner_count >= 3, "a piece has three corners");
        require(cut_into_triangles(scene, piece).size() <= piece.corner_count - 2, "not too many triangles");
    }
    std::size_t valid = 0;
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        require(scene.polygon(id).valid == (scene.polygon(id).piece_count > 0), "valid polygons have pieces");
        valid += scene.polygon(id).valid ? 1 : 0;
    }
    require(valid + scene.invalid().size() == scene.polygons().size(), "every polygon is valid or invalid");
    const Census census = take_census(scene, {100});
    require(census.valid == valid, "the census counts all");
}

std::string read_both(std::string_view text) {
    const ReadOptions options{true, false};
    ReadReport report;
    const std::string path = "/nowhere/fuzz.obj";
    try {
        MaterialLibrary library(path, options, report);
        library.read_text(text, "fuzz.mtl");
    } catch (const InputError&) {
    }
    try {
        const Scene scene = Scene::build(parse_obj(text, path, options, report), {true});
        check(scene);
        return scene.invalid().empty() ? "valid scenes" : "scenes with invalid polygons";
    } catch (const InputError& error) {
        require(!error.where().file.empty(), "a refusal says where");
        throw;
    }
}

}  // namespace

Target target() {
    return {
        {"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf -4 -3 -2\n",
         "mtllib a b.mtl\r\nv 0 0 0 1\r\nv 2 0 0 0.5 .25 1\r\nv 2 2 0x1p-3\r\nusemtl a\r\nf 1/1 2//2 3/3/3\r\n",
         ("# holes on bridges\nv 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\n"
          "f 1 2 3 4 1 5 6 7 8 5\nf 4 3 2 1\nf 1 2 7 6\n"),
         "v 1e300 -1e300 5e-324\nv 1e-300 0 -0\nv 3e307 1 1\nv 1e308 1e308 1e308\nf 1 2 3 \\\n 4\nf 4 3 2 1\n",
         "newmtl lamp\nKd .5 .5 .5\nKe 10 10 10\nnewmtl grey # name\nKd 1\nmap_Kd x.png\nTf 1 1 1\n",
         "v 0 0 0\nv 1 0 1\nv 1 1 0\nv 0 1 1\nv 2 2 2\nf 1 2 3 4\nf 1 3 2 4\nf 1 2 1 2\nf 1 1 1\nf 1 2\nf 1 2 3 4 5\n"},
        {"v ",          "f ",
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
         "1 "},
        {"valid scenes", "scenes with invalid polygons", "refused"},
        20000,
        read_both};
}

}  // namespace cob::fuzz
