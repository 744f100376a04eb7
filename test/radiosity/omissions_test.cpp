/// Whatever a scene does not need is left out, and no byte of any result depends on it. Each omission alone and all
/// together, on every shipped scene and on random ones.
#include "cob/omissions.hpp"

#include "arithmetic/orientation.hpp"
#include "cob/classify.hpp"
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/solver.hpp"
#include "geometry/bounds.hpp"
#include "naive/dice.hpp"
#include "report/camera.hpp"
#include "report/classify_scene.hpp"
#include "report/picture.hpp"
#include "report/solution_files.hpp"
#include "scene/piece_plane.hpp"
#include "scenes.hpp"
#include "temporary_folder.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace {

using cob::Omission;
using cob::Omissions;
using cob::OmissionSet;
using cob::RadiosityOptions;
using cob::RadiositySolver;
using cob::Scene;

/// Everything that `cob render` writes but times and counters.
std::string rendered(const Scene& scene, RadiosityOptions options, const OmissionSet& keep) {
    options.keep = keep;
    RadiositySolver solver(scene, options);
    while (solver.step()) {
    }
    cob::report::PictureOptions picture;
    picture.width = 32;
    picture.height = 24;
    picture.antialiasing = 1;
    const cob::report::Pictures pictures =
        cob::report::render_pictures(solver, cob::report::default_camera(scene), picture);
    std::string bytes = cob::report::solution_csv(solver) + cob::report::solution_ply(solver, pictures.exposure) +
                        cob::report::solution_vtp(solver);
    for (const auto* image : {&pictures.plain, &pictures.mesh, &pictures.states})
        bytes += cob::report::encode_png(*image);
    const cob::EnergyBooks books = solver.books();
    for (const double x : {books.by_elements[0], books.by_patches[2], books.closure_mean, books.closure_least,
                           books.closure_most, books.moved, solver.unshot_share()})
        bytes += cob::to_text(x) + "\n";
    return bytes;
}

/// Everything that `cob classify` writes but its summary.
std::string classified(const Scene& scene, const OmissionSet& keep) {
    const cob::test::TemporaryFolder folder;
    const cob::Roots roots(scene);
    const cob::ElementList elements(scene, roots, {0, 1});
    const Omissions omissions(scene, roots, {keep, cob::Rational(1, 8), cob::Rational(1, 4)});
    cob::ClassifySceneOptions options;
    omissions.apply_to(options.classify.buffer);
    if (!omissions(Omission::levels)) options.classify.levels = cob::BufferLevels::polygon;
    options.classify.apart = omissions(Omission::buffers);
    const auto source = cob::make_candidates(scene, omissions(Omission::tree) ? cob::Source::all : cob::Source::tree);
    classify_scene(elements, *source, folder.path(), options);
    std::string bytes;
    for (const char* name : {"states.csv", "relations.csv", "boxes.csv", "elements.ply"})
        bytes += cob::read_file(folder.path() + "/" + name);
    return bytes;
}

RadiosityOptions cheap(std::int64_t shots, std::int64_t elements) {
    RadiosityOptions options;
    options.stop.shots = shots;
    options.stop.elements = elements;
    options.mixed_samples = 4;
    return options;
}

void expect_the_same(const Scene& scene, const RadiosityOptions& options) {
    const std::string bytes = rendered(scene, options, {}), answers = classified(scene, {});
    ASSERT_GT(bytes.size(), 1000u);
    for (const Omission omission : cob::all_omissions) {
        OmissionSet one;
        one.add(omission);
        EXPECT_EQ(rendered(scene, options, one), bytes) << scene.name() << " " << to_text(omission);
        EXPECT_EQ(classified(scene, one), answers) << scene.name() << " " << to_text(omission);
    }
    EXPECT_EQ(rendered(scene, options, OmissionSet::all()), bytes) << scene.name();
    EXPECT_EQ(classified(scene, OmissionSet::all()), answers) << scene.name();
}

TEST(LeavingOut, ChangesNoByteOnEveryShippedScene) {
    int scenes = 0;
    for (const auto& entry : std::filesystem::directory_iterator(COB_DATA)) {
        if (entry.path().extension() != ".obj") continue;
        ++scenes;
        SCOPED_TRACE(entry.path().filename().string());
        const Scene scene = cob::read_obj(entry.path().string(), cob::ReadOptions{});
        RadiosityOptions options = cheap(3, 600);
        options.samples = 1;
        if (scene.polygon_count() > 100) options.patch_edge = 1e9;  // roots
        expect_the_same(scene, options);
    }
    EXPECT_GE(scenes, 11);
}

/// Boxes of small plates over a floor or apart from all others, grey or not, black or not, under one or more lights.
Scene random_scene(std::uint64_t seed) {
    cob::naive::Dice dice(seed);
    scenes::Builder b;
    const bool grey = dice.one_in(2), closed = dice.one_in(3);
    const auto colour = [&]() -> std::array<double, 3> {
        if (dice.one_in(4)) return {0, 0, 0};
        const double r = dice.below(4) / 8.0 + 0.25;
        return grey ? std::array<double, 3>{r, r, r} : std::array<double, 3>{r, 0.5 * r, 0.25};
    };
    const std::array<double, 3> light = grey ? std::array<double, 3>{10, 10, 10} : std::array<double, 3>{10, 9, 8};
    if (closed) {
        std::array<std::array<double, 3>, 6> rho, e{};
        for (auto& r : rho) r = colour();
        e[5] = light;
        b.room({0, 0, 0}, {4, 3, 2}, rho, e);
    } else {
        b.add({{0, 0, 0}, {4, 0, 0}, {4, 3, 0}, {0, 3, 0}}, {0.5, 0.5, 0.5});
        b.add({{1, 1, 2}, {1, 2, 2}, {2, 2, 2}, {2, 1, 2}}, {0, 0, 0}, light);
    }
    for (int k = dice.below(closed ? 3 : 4); k > 0; --k) {
        const double x = dice.below(24) / 8.0, y = dice.below(16) / 8.0, z = dice.below(dice.one_in(2) ? 2 : 13) / 8.0;
        const double w = dice.between(1, 4) / 4.0;
        const bool shines = dice.one_in(5);
        switch (dice.below(3)) {
            case 0:
                b.add({{x, y, z}, {x + w, y, z}, {x + w, y, z + w}, {x, y, z + w}}, colour());
                break;
            case 1:
                b.add({{x, y, z}, {x, y + w, z}, {x + w, y + w, z}, {x + w, y, z}}, colour(),
                      shines ? light : std::array<double, 3>{});
                break;
            default:
                b.add({{x, y, z}, {x + w, y, z + w}, {x, y + w, z}}, colour());
        }
    }
    return b.scene();
}

TEST(LeavingOut, ChangesNoByteOnRandomScenes) {
    std::array<int, cob::all_omissions.size()> left_out{}, needed{};
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        const Scene scene = random_scene(seed);
        RadiosityOptions options = cheap(6, 300);
        options.patch_edge = 1;
        options.overshoot = seed % 5 == 0;
        options.receiving_points = seed % 3 == 0 ? 4 : 1;
        expect_the_same(scene, options);
        const Omissions omissions(scene, cob::Roots(scene), {});
        for (const Omission omission : cob::all_omissions)
            ++(omissions(omission) ? left_out : needed)[static_cast<std::size_t>(omission)];
    }
    // Each fact really holds of some of these and not of others.
    for (const Omission omission : {Omission::convex, Omission::buffers, Omission::grey, Omission::black}) {
        EXPECT_GT(left_out[static_cast<std::size_t>(omission)], 0) << to_text(omission);
        EXPECT_GT(needed[static_cast<std::size_t>(omission)], 0) << to_text(omission);
    }
}

/// A floor, and over it rows of `count` sheets, each `raised` higher than the one before; under a lamp.
Scene sheets_over_floor(int count, double raised) {
    scenes::Builder b;
    const double side = count;
    b.add({{0, 0, 0}, {side, 0, 0}, {side, side, 0}, {0, side, 0}}, {0.5, 0.5, 0.5});
    for (int k = 0; k < count * count; ++k) {
        const double x = k % count + 0.25, y = k / count + 0.25, z = (k + 1) * raised;
        b.add({{x, y, z}, {x + 0.5, y, z}, {x + 0.5, y + 0.5, z}, {x, y + 0.5, z}}, {0.5, 0.5, 0.5});
    }
    const double low = side / 2, high = low + 1, z = 2 * side;
    b.add({{low, low, z}, {low, high, z}, {high, high, z}, {high, low, z}}, {0, 0, 0}, {10, 10, 10});
    return b.scene();
}

// Where a list is so long that nothing is built from it, too.
TEST(LeavingOut, ChangesNoByteUnderManyDetails) {
    const Scene scene = sheets_over_floor(9, 0x1p-10);
    const cob::Roots roots(scene);
    const auto source = make_candidates(scene, cob::Source::tree);
    cob::BufferBuilder builder(scene, roots, *source, {});
    const cob::CloseObjectBuffer floor = builder.build(cob::root_element(0));
    ASSERT_EQ(builder.polygons(floor).size(), 81u);
    cob::BufferStatistics statistics;
    builder.build(cob::children(roots[0], cob::root_element(0))[0], floor, &statistics);
    EXPECT_EQ(statistics.from_scene, 1u);
    RadiosityOptions options = cheap(2, 1000);
    options.patch_edge = 3;
    expect_the_same(scene, options);
}

/// The facts by definition: every pair.
bool is_convex(const Scene& scene) {
    for (const cob::Piece& wall : scene.pieces()) {
        const auto plane = cob::plane_of(scene, wall);
        for (const cob::Piece& other : scene.pieces())
            for (const cob::VertexId corner : scene.corners(other))
                if (orientation(plane[0], plane[1], plane[2], scene.position(corner)) == cob::Sign::negative)
                    return false;
    }
    return true;
}

bool is_apart(const Scene& scene, const cob::Roots& roots) {
    for (const cob::Root& root : roots.all()) {
        const cob::Box box(box_question(scene, root, cob::root_element(root.id), {1, 8}, {1, 4}));
        const auto& b = box.bounds();
        const cob::Bounds around{{b[0], b[1], b[2]}, {b[3], b[4], b[5]}};
        for (cob::PolygonId p = 0; p < scene.polygon_count(); ++p)
            if (p != root.polygon && bounds_of(scene, scene.loop(p)).meets(around)) return false;
    }
    return true;
}

TEST(LeavingOut, FactsAboutPairsHoldOfEveryPair) {
    int convex = 0, apart = 0, decided = 0;
    const auto compare = [&](const Scene& scene) {
        const cob::Roots roots(scene);
        const Omissions omissions(scene, roots, {});
        EXPECT_EQ(omissions(Omission::convex), is_convex(scene));
        EXPECT_EQ(omissions(Omission::buffers), is_apart(scene, roots));
        convex += omissions(Omission::convex);
        apart += omissions(Omission::buffers);
        ++decided;
    };
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE(seed);
        compare(random_scene(seed));
    }
    EXPECT_GT(convex, 20);
    EXPECT_LT(convex, decided - 20);
    EXPECT_GT(apart, 20);
    EXPECT_LT(apart, decided - 20);

    // However many polygons there are: tiles of a floor and one an ulp off it; plates and one over the first, in reach
    // of its box (5/16 high) or not.
    const auto last_of = [](double spacing, double z) {
        scenes::Builder b;
        for (int k = 0; k <= 1600; ++k) {
            const double x = k % 1600 % 40 * spacing, y = k % 1600 / 40 * spacing, h = k == 1600 ? z : 0;
            b.add({{x, y, h}, {x + 1, y, h}, {x + 1, y + 1, h}, {x, y + 1, h}}, {0.5, 0.5, 0.5});
        }
        return b.scene();
    };
    const auto decide = [](const Scene& scene) { return Omissions(scene, cob::Roots(scene), {}); };
    EXPECT_TRUE(decide(last_of(1, 0))(Omission::convex));
    EXPECT_EQ(decide(last_of(1, -0x1p-1074)).of(Omission::convex).reason,
              "polygon 1600 reaches behind the plane of polygon 1599");
    EXPECT_EQ(decide(last_of(1, 0x1p-1074)).of(Omission::convex).reason.substr(0, 8), "polygon ");
    EXPECT_TRUE(decide(last_of(2, 0.3126))(Omission::buffers));
    EXPECT_EQ(decide(last_of(2, 0.3125)).of(Omission::buffers).reason, "polygon 1600 is near the box of polygon 0");
}

TEST(LeavingOut, IsDecidedFromExactFacts) {
    const auto decide = [](const Scene& scene) { return Omissions(scene, cob::Roots(scene), {}); };
    std::array<std::array<double, 3>, 6> rho, e{};
    rho.fill({0.5, 0.5, 0.5});
    e[5] = {1, 1, 1};
    scenes::Builder room;
    room.room({0, 0, 0}, {1, 1, 1}, rho, e);
    EXPECT_TRUE(decide(room.scene())(Omission::convex));
    EXPECT_TRUE(decide(room.scene())(Omission::grey));
    EXPECT_TRUE(decide(room.scene())(Omission::tree));
    EXPECT_FALSE(decide(room.scene())(Omission::black));
    EXPECT_FALSE(decide(room.scene())(Omission::buffers));  // walls meet in edges

    // A plate one ulp in front of a wall is no part of a convex scene; on the wall's plane it is.
    const double ulp = 0x1p-52;
    scenes::Builder off = room, on = room;
    off.add({{0.25, 0.25, ulp}, {0.5, 0.25, ulp}, {0.5, 0.5, ulp}, {0.25, 0.5, ulp}}, {0, 0, 0});
    on.add({{0.25, 0.25, 0}, {0.5, 0.25, 0}, {0.5, 0.5, 0}, {0.25, 0.5, 0}}, {0, 0, 0});
    EXPECT_FALSE(decide(off.scene())(Omission::convex));
    EXPECT_TRUE(decide(on.scene())(Omission::convex));
    EXPECT_TRUE(decide(on.scene())(Omission::black));
    EXPECT_EQ(decide(on.scene()).of(Omission::black).reason, "1 of 7 polygons neither reflect nor emit");

    // The box over a floor of side 1 with margin 1/8 and height 1/4 is 5/16 high, and closed.
    const auto under_lamp = [&](double height) {
        scenes::Builder b;
        b.add({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0.5, 0.5, 0.5});
        b.add({{0.5, 0.5, height}, {0.5, 0.75, height}, {0.75, 0.75, height}, {0.75, 0.5, height}}, {0, 0, 0},
              {1, 1, 0.5});
        return b.scene();
    };
    EXPECT_FALSE(decide(under_lamp(0.3125))(Omission::buffers));
    EXPECT_TRUE(decide(under_lamp(0.3126))(Omission::buffers));
    EXPECT_FALSE(decide(under_lamp(1))(Omission::grey));
}

TEST(LeavingOut, NamesAreReadAndRefused) {
    const OmissionSet two = OmissionSet::parse("grey,shaft");
    EXPECT_TRUE(two.has(Omission::grey));
    EXPECT_TRUE(two.has(Omission::shaft));
    EXPECT_FALSE(two.has(Omission::tree));
    EXPECT_EQ(OmissionSet::parse(OmissionSet::all().to_text()).to_text(), OmissionSet::all().to_text());
    EXPECT_EQ(OmissionSet::parse("").to_text(), "");
    EXPECT_THROW(OmissionSet::parse("gray"), cob::InputError);
    const Scene scene = scenes::plate_over_table();
    const Omissions kept(scene, cob::Roots(scene), {OmissionSet::all(), cob::Rational(1, 8), cob::Rational(1, 4)});
    for (const Omission omission : cob::all_omissions) EXPECT_FALSE(kept(omission));
    EXPECT_TRUE(kept.of(Omission::shaft).possible);
}

}  // namespace
