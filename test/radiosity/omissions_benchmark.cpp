/// What leaving out pays: processor time with one omission kept over the time with it left out, on the scenes that it
/// is for and on one that it does not concern; and how much of the whole the deciding takes.
/// Run: cob_benchmark_omissions
#include "arithmetic/process.hpp"
#include "cob/classify.hpp"
#include "cob/omissions.hpp"
#include "cob/solver.hpp"
#include "scenes.hpp"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace {

using cob::Omission;
using cob::OmissionSet;
using cob::Scene;
using Colour = std::array<double, 3>;

constexpr Colour black{}, grey{0.5, 0.5, 0.5}, brown{0.5, 0.4, 0.3}, light{10, 9, 8}, grey_light{10, 10, 10};

std::vector<cob::Point> plate(double x, double y, double z, double side) {
    return {{x, y, z}, {x + side, y, z}, {x + side, y + side, z}, {x, y + side, z}};
}

std::vector<cob::Point> lamp(double x, double y, double z, double side) {
    std::vector<cob::Point> loop = plate(x, y, z, side);
    std::reverse(loop.begin(), loop.end());
    return loop;
}

/// A convex room of 4 x 3 x 2.
Scene room(const Colour& reflectance, const Colour& ceiling) {
    std::array<Colour, 6> rho, e{};
    rho.fill(reflectance);
    e[5] = ceiling;
    return scenes::Builder().room({0, 0, 0}, {4, 3, 2}, rho, e).scene();
}

/// A floor of 100 plates under 32 x 32 lamps.
Scene many_lamps() {
    scenes::Builder b;
    for (int k = 0; k < 100; ++k) b.add(plate(k % 10, k / 10, 0, 1), brown);
    for (int k = 0; k < 1024; ++k) b.add(lamp(k % 32 * 0.3125, k / 32 * 0.3125, 5, 0.25), black, light);
    return b.scene();
}

/// 32 x 32 plates, none near another, under a lamp.
Scene far_apart(const Colour& reflectance) {
    scenes::Builder b;
    for (int k = 0; k < 1024; ++k) b.add(plate(k % 32 * 2, k / 32 * 2, k % 7 * 0.03125, 1), reflectance);
    return b.add(lamp(31, 31, 20, 4), black, light).scene();
}

/// One floor under 100 x 100 little sheets.
Scene floor_of_details() {
    scenes::Builder b;
    b.add(plate(0, 0, 0, 100), brown);
    for (int k = 0; k < 10000; ++k) b.add(plate(k % 100 + 0.25, k / 100 + 0.25, 0.0625, 0.25), grey);
    return b.add(lamp(45, 45, 40, 10), black, light).scene();
}

Scene shipped(const std::string& name) {
    return cob::read_obj(COB_DATA "/" + name + ".obj", cob::ReadOptions{});
}

/// Work on a scene with some omissions kept.
using Work = std::function<void(const Scene&, const OmissionSet&)>;

Work classify(cob::Meshing meshing) {
    return [meshing](const Scene& scene, const OmissionSet& keep) {
        const cob::Roots roots(scene);
        const cob::ElementList elements(scene, roots, meshing);
        cob::ClassifyOptions options;
        const cob::Omissions omissions(scene, roots, {keep, options.buffer.margin, options.buffer.height});
        omissions.apply_to(options.buffer);
        if (!omissions(Omission::levels)) options.levels = cob::BufferLevels::polygon;
        options.apart = omissions(Omission::buffers);
        options.relations = options.questions = false;
        const auto source = make_candidates(scene, omissions(Omission::tree) ? cob::Source::all : cob::Source::tree);
        cob::ElementClassifier classifier(elements, *source, options);
        cob::ClassifiedElement element;
        for (std::uint64_t k = 0; k < elements.size(); ++k) classifier(k, element);
    };
}

Work solve(cob::Refinement refinement, double edge, std::int64_t shots) {
    return [=](const Scene& scene, const OmissionSet& keep) {
        cob::RadiosityOptions options;
        options.refinement = refinement;
        options.patch_edge = edge;
        options.stop.shots = shots;
        options.stop.unshot = 0;
        options.threads = 1;
        options.keep = keep;
        cob::RadiositySolver solver(scene, options);
        while (solver.step()) {
        }
    };
}

/// Least processor time of some runs each, in turn.
std::array<double, 2> seconds(const Scene& scene, const Work& work, const OmissionSet& without,
                              const OmissionSet& with) {
    std::array<double, 2> least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const std::array<OmissionSet, 2> keep{without, with};
    double spent = 0;
    for (int run = 0; run < 3 || (run < 20 && spent < 2); ++run)
        for (std::size_t k = 0; k < 2; ++k) {
            const double begin = cob::processor_seconds();
            work(scene, keep[k]);
            const double end = cob::processor_seconds();
            least[k] = std::min(least[k], end - begin);
            spent += end - begin;
        }
    return least;
}

void row(const char* kept, const char* besides, const char* scene_name, const Scene& scene, const char* work_name,
         const Work& work) {
    const OmissionSet without = OmissionSet::parse(besides);
    const std::string both = *besides == 0 ? kept : std::string(besides) + "," + kept;
    const std::array<double, 2> time = seconds(scene, work, without, OmissionSet::parse(both));
    std::printf("| `%s` | %s | %s%s%s | %.4f | %.4f | %.2f |\n", kept, scene_name, work_name,
                *besides == 0 ? "" : ", also kept: ", besides, time[0], time[1], time[1] / time[0]);
    std::fflush(stdout);
}

}  // namespace

int main() {
    using cob::Refinement;
    const Scene cornell = shipped("cornell"), desk = shipped("desk"), figure4 = shipped("figure4");
    const Scene grey_room = room(grey, grey_light), brown_room = room(brown, light), lamps = many_lamps(),
                apart = far_apart(brown), black_floor = far_apart(black), details = floor_of_details();
    const Work solve_none = solve(Refinement::none, 0.1, 40), solve_desk = solve(Refinement::both, 0, 10);

    std::printf("| kept | scene | work | seconds left out | kept | ratio |\n| --- | --- | --- | --- | --- | --- |\n");
    row("convex", "shaft", "convex room", brown_room, "40 shots", solve_none);
    row("convex", "", "convex room", brown_room, "40 shots", solve_none);
    row("shaft", "", "cornell", cornell, "100 shots", solve(Refinement::none, 50, 100));
    row("shaft", "", "desk", desk, "10 shots", solve_desk);
    row("filter", "", "desk", desk, "2 shots, no refinement", solve(Refinement::none, 0.5, 2));
    row("filter", "", "desk", desk, "classify", classify({0, 1}));
    row("lights", "", "1024 lamps", lamps, "classify", classify({0, 2}));
    row("lights", "", "1024 lamps", lamps, "5 shots", solve(Refinement::buffer, 1, 5));
    row("buffers", "", "1024 plates apart", apart, "classify", classify({0, 3}));
    row("buffers", "", "1024 plates apart", apart, "5 shots", solve(Refinement::buffer, 1, 5));
    row("levels", "", "floor under 10,000 sheets", details, "classify", classify({1, 0}));
    row("levels", "", "floor under 10,000 sheets", details, "2 shots", solve(Refinement::buffer, 1, 2));
    row("grey", "", "grey room", grey_room, "40 shots", solve_none);
    row("black", "", "1024 black plates", black_floor, "100 shots", solve(Refinement::none, 1, 100));
    row("tree", "", "convex room", brown_room, "classify", classify({0, 6}));
    row("tree", "", "figure4", figure4, "classify", classify({0, 6}));
    row("tree", "shaft", "cornell", cornell, "5 shots", solve(Refinement::none, 50, 5));
    for (const Omission omission : cob::all_omissions)
        if (omission != Omission::filter && omission != Omission::shaft)
            row(to_text(omission), "", "desk", desk, "10 shots", solve_desk);

    std::printf("\n| scene | seconds to decide | of 10 shots |\n| --- | --- | --- |\n");
    for (const char* name : {"cornell", "desk", "office", "hall"}) {
        const Scene scene = shipped(name);
        const cob::Roots roots(scene);
        const Work decide = [&](const Scene& of, const OmissionSet& keep) {
            for (int k = 0; k < 100; ++k) cob::Omissions(of, roots, {keep, cob::Rational(1, 8), cob::Rational(1, 4)});
        };
        const double deciding = seconds(scene, decide, {}, {})[0] / 100;
        const double all = seconds(scene, solve_desk, {}, {})[0];
        std::printf("| %s | %.6f | %.3f %% |\n", name, deciding, 100 * deciding / all);
    }
}
