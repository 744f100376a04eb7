#include "radiosity/between.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace cob::radiosity {
namespace {

/// Up to here the sides of all pieces on all planes are kept, 2 MB each.
constexpr std::size_t most_pieces_in_matrix = 4096;

/// On which sides of a plane a patch may have points.
struct SidesTaken {
    bool front = false, back = false;

    /// The side on which all of it lies, strictly.
    std::optional<Sign> only(bool certain) const {
        if (!certain || front == back) return std::nullopt;
        return front ? Sign::positive : Sign::negative;
    }
};

SidesTaken sides_taken(const Planes& planes, PieceId plane, const PatchShape& patch, bool& certain) {
    SidesTaken result;
    certain = true;
    for (std::size_t k = 0; k < static_cast<std::size_t>(patch.corner_count); ++k) {
        const std::optional<Sign> side = planes.side(plane, patch.corners[k]);
        certain = certain && side.has_value();
        result.front = result.front || !side || *side == Sign::positive;
        result.back = result.back || !side || *side == Sign::negative;
    }
    return result;
}

}  // namespace

void Between::Bits::resize(std::size_t count) {
    per_row_ = (count + 63) / 64;
    words_.assign(per_row_ * count, 0);
}

Between::Bits Between::Bits::transposed(std::size_t count) const {
    Bits result;
    result.resize(count);
    for (std::size_t r = 0; r < count; ++r)
        for (std::size_t word = 0; word < per_row_; ++word)
            for (std::uint64_t rest = row(static_cast<PieceId>(r))[word]; rest != 0; rest &= rest - 1)
                result.set(static_cast<PieceId>(word * 64 + static_cast<std::size_t>(__builtin_ctzll(rest))),
                           static_cast<PieceId>(r));
    return result;
}

Between::Between(const Scene& scene, const Planes& planes) : scene_(scene), planes_(planes) {
    const std::size_t count = scene.pieces().size();
    if (count > most_pieces_in_matrix) {
        std::vector<Bounds3> boxes(count);
        for (std::size_t k = 0; k < count; ++k)
            for (const Point& corner : planes.corners(static_cast<PieceId>(k))) boxes[k].add(corner);
        tree_.emplace(std::move(boxes));
        return;
    }
    Bits before;
    behind_.resize(count);
    before.resize(count);
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t plane) {
        for (std::size_t piece = 0; piece < count; ++piece) {
            const auto p = static_cast<PieceId>(piece), q = static_cast<PieceId>(plane);
            const Planes::ClosedSides sides = planes_.closed_sides(p, q);
            if (sides.behind) behind_.set(q, p);
            if (sides.before) before.set(q, p);
        }
    });
    behind_of_ = behind_.transposed(count);
    before_of_ = before.transposed(count);
}

bool Between::behind(PieceId piece, PieceId plane) const {
    return behind_.empty() ? planes_.closed_sides(piece, plane).behind : behind_.at(plane, piece);
}

bool Between::apart(PieceId a, PieceId b) const {
    return a == b || behind(a, b) || behind(b, a);
}

void Between::find(const PatchShape& shooter, const PatchShape& receiver, std::vector<Obstacle>& out) const {
    out.clear();
    const Shaft shaft(shooter.bounds, receiver.bounds);
    if (tree_) {
        const auto meets = [&](const Bounds3& box) { return shaft.may_meet(box); };
        tree_->find_where(meets, [&](std::uint32_t id) {
            const auto piece = static_cast<PieceId>(id);
            if (!planes_.closed_sides(piece, shooter.piece).behind &&
                !planes_.closed_sides(piece, receiver.piece).behind)
                consider(piece, shaft, shooter, receiver, out);
        });
        std::sort(out.begin(), out.end(), [](const Obstacle& a, const Obstacle& b) { return a.piece < b.piece; });
        return;
    }
    const PieceId s = shooter.piece, r = receiver.piece;
    const std::uint64_t *behind_s = behind_.row(s), *behind_r = behind_.row(r);
    const std::uint64_t *s_behind = behind_of_.row(s), *r_behind = behind_of_.row(r);
    const std::uint64_t *s_before = before_of_.row(s), *r_before = before_of_.row(r);
    const std::size_t pieces = scene_.pieces().size(), words = behind_.words_per_row();
    for (std::size_t word = 0; word < words; ++word) {
        std::uint64_t rest =
            ~(behind_s[word] | behind_r[word] | (s_behind[word] & r_behind[word]) | (s_before[word] & r_before[word]));
        if (word + 1 == words && pieces % 64 != 0) rest &= (std::uint64_t(1) << (pieces % 64)) - 1;
        for (; rest != 0; rest &= rest - 1)
            consider(static_cast<PieceId>(word * 64 + static_cast<std::size_t>(__builtin_ctzll(rest))), shaft, shooter,
                     receiver, out);
    }
}

void Between::consider(PieceId piece, const Shaft& shaft, const PatchShape& shooter, const PatchShape& receiver,
                       std::vector<Obstacle>& out) const {
    if (!shaft.may_meet(planes_.bounds(piece), planes_.corners(piece))) return;
    bool shooter_certain = false, receiver_certain = false;
    SidesTaken of_shooter = sides_taken(planes_, piece, shooter, shooter_certain);
    SidesTaken of_receiver = sides_taken(planes_, piece, receiver, receiver_certain);
    const std::optional<Sign> shooter_side = of_shooter.only(shooter_certain),
                              receiver_side = of_receiver.only(receiver_certain);
    if (!behind_.empty()) {
        // What rounding does not tell of corners on the plane, the whole pieces may.
        of_shooter.front = of_shooter.front && !behind_of_.at(shooter.piece, piece);
        of_shooter.back = of_shooter.back && !before_of_.at(shooter.piece, piece);
        of_receiver.front = of_receiver.front && !behind_of_.at(receiver.piece, piece);
        of_receiver.back = of_receiver.back && !before_of_.at(receiver.piece, piece);
    }
    // Both on one closed side: between points of them that face each other, a segment leaves or reaches the plane at
    // its ends at most, and there contact does not count (SPEC 6).
    if (!(of_shooter.front || of_receiver.front) || !(of_shooter.back || of_receiver.back)) return;
    out.push_back({piece, shooter_side, receiver_side});
}

}  // namespace cob::radiosity
