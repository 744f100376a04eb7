#include "cob/scene.hpp"

#include "cob/error.hpp"
#include "scene/seen.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace cob {

namespace {

/// Consecutive corners at one position count once, the last and the first too; the first of a run is kept (SPEC 2).
std::vector<VertexId> without_repeats(const std::vector<VertexId>& corners, const std::vector<Point>& positions) {
    const auto at = [&](VertexId id) -> const Point& { return positions[static_cast<std::size_t>(id)]; };
    std::vector<VertexId> kept;
    for (const VertexId corner : corners)
        if (kept.empty() || at(kept.back()) != at(corner)) kept.push_back(corner);
    while (kept.size() > 1 && at(kept.back()) == at(kept.front())) kept.pop_back();
    return kept;
}

bool has_three_positions(const std::vector<Point>& loop) {
    for (const Point& point : loop)
        if (point != loop[0] && point != loop[1]) return true;
    return false;
}

/// What SPEC 2 says about one loop.
struct Judgement {
    std::string refusal;  ///< Empty: accepted.
    View2 view;
    bool planar = true, convex = true;
    std::vector<EarTriangle> triangles;  ///< The pieces of a polygon that is not convex.
};

Judgement judge(std::vector<Point> positions) {
    Judgement judgement;
    if (positions.size() < 3 || !has_three_positions(positions)) {
        judgement.refusal = "fewer than 3 distinct vertices";
        return judgement;
    }
    const auto view = view_of(positions);
    if (!view) {
        judgement.refusal = "zero area";
        return judgement;
    }
    judgement.view = *view;
    const SeenLoop loop = see(std::move(positions), *view);
    judgement.planar = is_planar(loop);
    judgement.convex = judgement.planar && is_convex(loop);
    if (judgement.convex) return judgement;
    if (const auto pair = crossing_sides(loop)) {
        judgement.refusal =
            "sides " + std::to_string(pair->first + 1) + " and " + std::to_string(pair->second + 1) + " cross";
        return judgement;
    }
    // Ears of a loop that winds around something twice would lie on each other.
    if (judgement.planar && touches_itself(loop)) {
        WoundTriangles wound = triangulate_wound(loop);
        if (wound.most > 1) judgement.triangles = std::move(wound.triangles);
    }
    if (!judgement.triangles.empty()) return judgement;
    if (auto triangles = cut_ears(loop))
        judgement.triangles = std::move(*triangles);
    else if (judgement.planar)
        judgement.triangles = triangulate_wound(loop).triangles;  // such loops turn clockwise somewhere
    else
        judgement.refusal = "no triangle can be cut off";
    return judgement;
}

void check_limits(const Scene::Input& input) {
    constexpr auto most = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max());
    if (input.positions.size() > most || input.faces.size() > most)
        throw InputError("too many vertices or polygons", {input.name, 0, "", "split the scene"});
}

void check_positions(const Scene::Input& input) {
    for (const Point& point : input.positions)
        for (int axis = 0; axis < 3; ++axis)
            if (!std::isfinite(point[axis]))
                throw InputError("coordinate is not finite",
                                 {input.name, 0, std::to_string(point[axis]), "give every vertex finite coordinates"});
}

void check_face(const Scene::Input& input, const Scene::Face& face) {
    for (const VertexId corner : face.corners)
        if (corner < 0 || static_cast<std::size_t>(corner) >= input.positions.size())
            throw InputError("vertex does not exist", {input.name, face.line, std::to_string(corner),
                                                       "use numbers of vertices that the scene has"});
    if (face.material < 0 || static_cast<std::size_t>(face.material) >= input.materials.size())
        throw InputError("material does not exist", {input.name, face.line, std::to_string(face.material),
                                                     "use numbers of materials that the scene has"});
}

}  // namespace

Scene Scene::build(Input input, Options options) {
    check_limits(input);
    check_positions(input);
    for (Point& point : input.positions) point = point + Point{};  // -0 and 0 are one number: 0

    Scene scene;
    scene.polygons_.reserve(input.faces.size());
    for (std::size_t id = 0; id < input.faces.size(); ++id) {
        const Face& face = input.faces[id];
        check_face(input, face);
        const std::vector<VertexId> corners = without_repeats(face.corners, input.positions);
        std::vector<Point> positions;
        positions.reserve(corners.size());
        for (const VertexId corner : corners) positions.push_back(input.positions[static_cast<std::size_t>(corner)]);
        const Judgement judgement = judge(std::move(positions));
        if (!judgement.refusal.empty()) {
            if (!options.skip_invalid)
                throw InputError("invalid polygon",
                                 {input.name, face.line, std::to_string(id) + ": " + judgement.refusal,
                                  "correct it, or leave such polygons out with --skip-invalid"});
            scene.invalid_.push_back({static_cast<PolygonId>(id), face.line, judgement.refusal});
        }

        Polygon polygon;
        polygon.first_corner = static_cast<std::uint32_t>(scene.loop_corners_.size());
        polygon.corner_count = static_cast<std::uint32_t>(corners.size());
        polygon.first_piece = static_cast<std::uint32_t>(scene.pieces_.size());
        polygon.material = face.material;
        polygon.line = face.line;
        polygon.view = judgement.view;
        polygon.planar = judgement.planar;
        polygon.convex = judgement.convex;
        polygon.valid = judgement.refusal.empty();
        scene.loop_corners_.insert(scene.loop_corners_.end(), corners.begin(), corners.end());
        if (polygon.valid) {
            const auto add_piece = [&](View<VertexId> piece) {
                scene.pieces_.push_back({static_cast<PolygonId>(id),
                                         static_cast<std::uint32_t>(scene.piece_corners_.size()),
                                         static_cast<std::uint32_t>(piece.size())});
                scene.piece_corners_.insert(scene.piece_corners_.end(), piece.begin(), piece.end());
            };
            if (polygon.convex) add_piece({corners.data(), corners.data() + corners.size()});
            for (const auto& [before, ear, after] : judgement.triangles) {
                const std::array<VertexId, 3> triangle{corners[before], corners[ear], corners[after]};
                add_piece({triangle.data(), triangle.data() + 3});
            }
        }
        polygon.piece_count = static_cast<std::uint32_t>(scene.pieces_.size()) - polygon.first_piece;
        scene.polygons_.push_back(polygon);
    }
    scene.name_ = std::move(input.name);
    scene.positions_ = std::move(input.positions);
    scene.materials_ = std::move(input.materials);
    return scene;
}

View<VertexId> Scene::loop(PolygonId id) const {
    const VertexId* begin = loop_corners_.data() + polygon(id).first_corner;
    return {begin, begin + polygon(id).corner_count};
}

View<Piece> Scene::pieces_of(PolygonId id) const {
    const Piece* begin = pieces_.data() + polygon(id).first_piece;
    return {begin, begin + polygon(id).piece_count};
}

View<VertexId> Scene::corners(const Piece& piece) const {
    const VertexId* begin = piece_corners_.data() + piece.first_corner;
    return {begin, begin + piece.corner_count};
}

Scene::Input input_of(const Scene& scene) {
    Scene::Input input;
    input.name = scene.name();
    input.positions = scene.positions();
    input.materials = scene.materials();
    for (PolygonId id = 0; id < scene.polygon_count(); ++id) {
        const View<VertexId> loop = scene.loop(id);
        input.faces.push_back({{loop.begin(), loop.end()}, scene.polygon(id).material, scene.polygon(id).line});
    }
    return input;
}

std::vector<std::array<std::uint32_t, 3>> cut_into_triangles(const Scene& scene, const Piece& piece) {
    if (piece.corner_count == 3) return {{0, 1, 2}};
    std::vector<Point> positions;
    positions.reserve(piece.corner_count);
    for (const VertexId corner : scene.corners(piece)) positions.push_back(scene.position(corner));
    auto triangles = cut_ears(see(std::move(positions), scene.polygon(piece.polygon).view));
    if (!triangles) throw std::logic_error("a convex piece has no ear");
    return std::move(*triangles);
}

}  // namespace cob
