/// \file
/// The scene: polygons, their pieces and materials, as read from OBJ and MTL (SPEC section 2).
#pragma once

#include "cob/arithmetic.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cob {

using PolygonId = std::int32_t;  ///< The k-th face line of the scene, from 0.
using PieceId = std::int32_t;    ///< Index into Scene::pieces().
using VertexId = std::int32_t;   ///< Index into Scene::positions().
inline constexpr PolygonId no_polygon = -1;

/// Diffuse material, RGB.
struct Material {
    std::string name;
    std::array<double, 3> reflectance{0.5, 0.5, 0.5};  ///< Kd, in [0, 1].
    std::array<double, 3> emitted_exitance{0, 0, 0};   ///< Ke, W/m2, >= 0.

    bool emits() const { return emitted_exitance[0] > 0 || emitted_exitance[1] > 0 || emitted_exitance[2] > 0; }
};

/// The plane on which a polygon is "seen" (SPEC 2): along the coordinate axis where its Newell normal is largest
/// in absolute value, the visible side up. first and second are the axes that span the view, in the order in
/// which the loop of a simple polygon runs counter-clockwise.
struct View2 {
    std::uint8_t axis = 2;
    std::uint8_t first = 0, second = 1;
};

/// One face line of the scene.
struct Polygon {
    std::uint32_t first_corner = 0, corner_count = 0;  ///< Into the scene's loops; repeated positions dropped.
    std::uint32_t first_piece = 0, piece_count = 0;    ///< Into Scene::pieces(); none where not valid.
    std::int32_t material = 0;                         ///< Into Scene::materials().
    std::uint32_t line = 0;                            ///< Line of its face statement, from 1; 0: none.
    View2 view;
    bool planar = true;  ///< All corners in one plane, exactly.
    bool convex = true;  ///< Planar, and never turns right nor back, as seen.
    bool valid = true;   ///< False only with ReadOptions::skip_invalid: keeps its number, occurs in no answer.
};

/// A convex planar part of a polygon: the polygon itself where it is convex, else a triangle. Runs
/// counter-clockwise as seen from the visible side.
struct Piece {
    PolygonId polygon = no_polygon;
    std::uint32_t first_corner = 0, corner_count = 0;  ///< Into the scene's piece corners.
};

/// A polygon that SPEC 2 refuses.
struct InvalidPolygon {
    PolygonId polygon = no_polygon;
    std::uint32_t line = 0;
    std::string reason;  ///< "zero area", "sides 2 and 5 cross", ...
};

/// An immutable set of polygons with exact pieces. Everything is stored once, in flat arrays.
class Scene {
public:
    /// One polygon as it comes in, before repeated positions are dropped.
    struct Face {
        std::vector<VertexId> corners;
        std::int32_t material = 0;
        std::uint32_t line = 0;
    };
    struct Input {
        std::string name;              ///< For messages: the file's path.
        std::vector<Point> positions;  ///< Finite.
        std::vector<Face> faces;
        std::vector<Material> materials;  ///< At least one where there are faces.
    };
    struct Options {
        bool skip_invalid = false;  ///< Keep refused polygons as invalid() instead of throwing InputError.
    };

    /// Builds planarity, convexity and pieces exactly (SPEC 2). Throws InputError.
    static Scene build(Input input, Options options);
    static Scene build(Input input) { return build(std::move(input), Options{}); }

    const std::string& name() const { return name_; }
    const std::vector<Point>& positions() const { return positions_; }
    const std::vector<Polygon>& polygons() const { return polygons_; }
    const std::vector<Piece>& pieces() const { return pieces_; }
    const std::vector<Material>& materials() const { return materials_; }
    const std::vector<InvalidPolygon>& invalid() const { return invalid_; }

    PolygonId polygon_count() const { return static_cast<PolygonId>(polygons_.size()); }
    const Polygon& polygon(PolygonId id) const { return polygons_[static_cast<std::size_t>(id)]; }
    const Piece& piece(PieceId id) const { return pieces_[static_cast<std::size_t>(id)]; }
    const Point& position(VertexId id) const { return positions_[static_cast<std::size_t>(id)]; }
    const Material& material(PolygonId id) const { return materials_[static_cast<std::size_t>(polygon(id).material)]; }
    bool is_light(PolygonId id) const { return polygon(id).valid && material(id).emits(); }

    /// The polygon's loop, repeated positions dropped.
    View<VertexId> loop(PolygonId id) const;
    View<Piece> pieces_of(PolygonId id) const;
    View<VertexId> corners(const Piece& piece) const;

private:
    std::string name_;
    std::vector<Point> positions_;
    std::vector<Polygon> polygons_;
    std::vector<Piece> pieces_;
    std::vector<VertexId> loop_corners_, piece_corners_;
    std::vector<Material> materials_;
    std::vector<InvalidPolygon> invalid_;
};

/// What the scene was built from, repeated positions dropped: to build a changed one. Polygons that were left out come
/// again.
Scene::Input input_of(const Scene& scene);

/// What a reader met besides the scene.
struct ReadReport {
    std::map<std::string, std::size_t> skipped;  ///< Unknown statements and how often.
    std::vector<std::string> warnings;           ///< One line each.
};

struct ReadOptions {
    bool skip_invalid = false;
    bool emission_is_radiance = false;  ///< Ke means radiance: exitance = pi Ke.
};

/// Reads OBJ + MTL. Throws InputError with file, line, value and remedy.
Scene read_obj(const std::string& path, const ReadOptions& options, ReadReport* report = nullptr);

/// A piece exactly planar in itself gives triangles with the same ear cutting as SPEC 2 (used for pieces of more
/// than four corners, SPEC 3, and for triangles.csv, SPEC 7). Corner indices into the piece.
std::vector<std::array<std::uint32_t, 3>> cut_into_triangles(const Scene& scene, const Piece& piece);

}  // namespace cob
