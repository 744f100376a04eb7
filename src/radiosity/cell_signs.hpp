/// \file
/// Signs of determinants for every viewpoint x of a triangle at once.
///
/// Cones over a viewpoint are cut by the signs of two kinds of determinants (cone.hpp), of which one is linear in x
/// over the receiver's plane: [a - x, b - x, v - x] for a side ab and a corner v; and the other,
/// [m, m', m''] for the planes through x and three sides, quadratic: it vanishes where x lies on the quadric of the
/// lines that meet all three. A polynomial has one sign on a triangle where its Bernstein coefficients have (Farin
/// 2002). So signs are certified for a whole cell, by bounds of rounding errors, or the determinant that is not decided
/// is named: where it vanishes, what is seen may change its shape.
#pragma once

#include "radiosity/pair_shapes.hpp"

#include <optional>
#include <unordered_map>
#include <vector>

namespace cob::radiosity {

/// A determinant whose sign over a cell is not known: its Bernstein coefficients, about. Those at the corners come
/// first, then, where it is quadratic, those of the sides from corner k to the next.
struct UndecidedSign {
    bool linear = false;
    std::array<double, 6> coefficients{};
};

/// A quadratic determinant that is taken to have the sign it has at the cell's centroid: where it has not, it is small.
struct DoubtfulSign {
    std::array<std::int32_t, 3> sides{};  ///< Ascending.
    UndecidedSign sign;
    Point2D worst;      ///< Near the cell's sides, where it has the other sign most,
    double beyond = 1;  ///< and at most so many times as much it has it anywhere.
    double share = 1;   ///< Of the cell's area, at most, has the other sign.
};

/// The ray in which the planes through two sides meet, or towards a corner.
struct ContourRay {
    VertexId vertex = -1;    ///< Or -1,
    PlaneRef first, second;  ///< and the ray points to the vector product of these planes' normals.

    friend bool operator==(const ContourRay& a, const ContourRay& b) {
        return a.vertex == b.vertex && a.first == b.first && a.second == b.second;
    }
};

/// Planes through x and a side ab are positive where (a - x) x (b - x) points, a the lower number.
class SignsOverCell {
public:
    SignsOverCell(const PairShapes& shapes, const Triangle2D& cell);
    /// Of a single viewpoint of a cell: what is certain there is known here.
    SignsOverCell(const SignsOverCell& around, const Point2D& point);

    /// The side of the plane to which the ray points, all over the cell; nothing where that is not certain.
    std::optional<Sign> side(PlaneRef plane, const ContourRay& ray);
    /// The same for the ray to a corner.
    std::optional<Sign> side(PlaneRef plane, VertexId v);
    /// The same, without slivers: it is certain also for the cell's parts.
    std::optional<Sign> side_without_sliver(PlaneRef plane, VertexId v);

    /// From now on, quadratic determinants count as decided where those values of the other sign than at the centroid
    /// are at most this share of the largest.
    void allow_doubt(double share) { doubt_ = share; }
    const std::vector<DoubtfulSign>& doubtful() const { return doubtful_; }
    /// Share of the cell's area, at most, on which some sign is another: slivers along cuts that are rounded.
    double sliver() const { return sliver_; }

    /// A determinant that was asked for and not decided since it was last forgotten; a linear one, if there was any.
    const std::optional<UndecidedSign>& undecided() const { return undecided_; }
    void forget_undecided() { undecided_.reset(); }

private:
    struct Normals {
        std::array<BoundedVector, 6> at;  ///< At the cell's corners and the middles of its sides.
        bool at_corners = false, at_middles = false;
    };
    enum class Known : std::uint8_t {
        not_asked,
        undecided,
        zero,
        negative,
        positive,
        mostly_negative,
        mostly_positive
    };
    std::array<BoundedNumber, 3> values_of(std::int32_t side, VertexId v);
    bool is_sparse() const { return linear_.empty(); }
    Known& known(std::int32_t side, VertexId v);
    const Normals& normals(std::int32_t side, bool at_middles);
    Known linear(std::int32_t side, VertexId v);
    std::optional<Sign> linear_sign(std::int32_t side, VertexId v);
    std::optional<Sign> determinant_sign(std::int32_t p, std::int32_t q, std::int32_t r);
    std::optional<Sign> quadratic_sign(std::int32_t p, std::int32_t q, std::int32_t r);
    std::optional<Sign> sign_in_doubt(const UndecidedSign& sign, std::array<std::int32_t, 3> sides);
    void note(const UndecidedSign& sign);

    const PairShapes* shapes_;
    Triangle2D cell_;
    std::array<BoundedVector, 6> places_;  ///< The cell's corners and the middles of its sides.
    std::vector<Normals> normals_;         ///< By side,
    std::vector<Known> linear_;            ///< and by side and corner, where these are not too many; else
    std::unordered_map<std::int32_t, Normals> sparse_normals_;
    std::unordered_map<std::uint64_t, Known> sparse_linear_;
    bool is_point_ = false;
    double doubt_ = 0, sliver_ = 0;
    std::vector<DoubtfulSign> doubtful_;
    std::optional<UndecidedSign> undecided_;
};

}  // namespace cob::radiosity
