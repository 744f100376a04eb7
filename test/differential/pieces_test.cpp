// SPEC 2: which polygons are refused, which are planar, and what their pieces are, against the naive twin.
#include "differential/run.hpp"
#include "differential/scenes.hpp"
#include "naive/clip.hpp"

#include <algorithm>

namespace cob::test {
namespace {

using naive::Corners;

Corners library_piece(const Scene& scene, const Piece& piece) {
    Corners corners;
    for (const VertexId corner : scene.corners(piece)) corners.push_back(to_rational(scene.position(corner)));
    return corners;
}

/// Triangles, each from its smallest corner, sorted: pieces that are the same whatever their order is.
std::vector<Corners> sorted(std::vector<Corners> pieces) {
    for (Corners& piece : pieces) std::rotate(piece.begin(), std::min_element(piece.begin(), piece.end()), piece.end());
    std::sort(pieces.begin(), pieces.end());
    return pieces;
}

/// Each set of convex parts leaves nothing of the other, as seen.
bool same_region(const naive::Polygon& view, const std::vector<Corners>& a, const std::vector<Corners>& b) {
    const auto seen = [&](std::vector<Corners> parts) {
        for (Corners& part : parts)
            for (RationalPoint& corner : part) corner = {corner[view.first], corner[view.second], 0};
        return parts;
    };
    const auto within = [](const std::vector<Corners>& parts, const std::vector<Corners>& others) {
        return std::all_of(parts.begin(), parts.end(),
                           [&](const Corners& part) { return naive::subtract_all(part, others).empty(); });
    };
    return within(seen(a), seen(b)) && within(seen(b), seen(a));
}

/// How the library's pieces compare with the twin's.
void compare_pieces(const std::vector<Point>& corners, const std::string& what, Tally& tally) {
    const Scene scene = library_scene({{corners, false}});
    const naive::Polygon twin = naive::prepare(corners);
    const Polygon& polygon = scene.polygon(0);
    const std::string where = what + " " + literals(corners);
    tally.compare(polygon.valid ? "accepted" : "refused", twin.refused.empty() ? "accepted" : "refused",
                  where + twin.refused + (polygon.valid ? "" : " / " + scene.invalid()[0].reason));
    if (!polygon.valid || !twin.refused.empty()) return;
    tally.compare(polygon.planar ? "planar" : "not planar", twin.planar ? "planar" : "not planar", where);
    if (twin.planar) tally.count(twin.pieces.size() == 1 ? "convex" : "not convex");

    naive::Loop loop;
    for (const VertexId corner : scene.loop(0)) loop.push_back(to_rational(scene.position(corner)));
    tally.compare(loop == twin.loop ? "same loop" : "other loop", "same loop", where);

    std::vector<Corners> library, naive;
    for (const Piece& piece : scene.pieces_of(0)) library.push_back(library_piece(scene, piece));
    for (const naive::Piece& piece : twin.pieces) naive.push_back(piece.corners);
    const bool same = twin.planar ? same_region(twin, library, naive) : sorted(library) == sorted(naive);
    tally.compare(same ? "same pieces" : "other pieces", "same pieces", where);
    for (const Corners& piece : library) {
        const RationalPoint normal = naive::newell(piece);
        tally.compare(dot(normal, twin.normal) > 0 || !twin.planar ? "same side" : "other side", "same side", where);
    }
}

TEST(PiecesAgainstTwin, AdversarialPolygons) {
    const Tally tally = run_cases(0, 5000 * length, [](std::uint64_t seed, Tally& sum) {
        compare_pieces(naive::polygon_case(seed), "polygon case " + std::to_string(seed), sum);
    });
    expect_no_difference(tally);
    expect_shares(tally, {{"accepted", 0.2}, {"refused", 0.1}});
    expect_shares(tally, {{"planar", 0.2}, {"not planar", 0.1}});
    expect_shares(tally, {{"convex", 0.1}, {"not convex", 0.1}});
}

}  // namespace
}  // namespace cob::test
