#include "naive/ears.hpp"

#include <numeric>
#include <optional>

namespace cob::naive {

Rational turn(const Seen& a, const Seen& b, const Seen& c) {
    return (b.s - a.s) * (c.t - a.t) - (b.t - a.t) * (c.s - a.s);
}

Rational ahead(const Seen& a, const Seen& b, const Seen& c) {
    return (b.s - a.s) * (c.s - b.s) + (b.t - a.t) * (c.t - b.t);
}

bool meets_open_triangle(const Side& side, const std::array<Seen, 3>& triangle) {
    // The parameters of the side's points strictly left of each line of the triangle: intervals whose ends count
    // only where they are the side's own.
    Rational low = 0, high = 1;
    bool low_counts = true, high_counts = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const Seen &a = triangle[k], &b = triangle[(k + 1) % 3];
        const Rational begin = turn(a, b, side.from), end = turn(a, b, side.to);
        if (begin <= 0 && end <= 0) return false;
        if (begin > 0 && end > 0) continue;
        const Rational on_line = begin / (begin - end);
        if (begin <= 0 && on_line >= low) {
            low = on_line;
            low_counts = false;
        }
        if (end <= 0 && on_line <= high) {
            high = on_line;
            high_counts = false;
        }
    }
    return low < high || (low == high && low_counts && high_counts);
}

namespace {

/// What is left of the loop while it is cut.
class Rest {
public:
    Rest(const std::vector<RationalPoint>& loop, const std::vector<Seen>& seen)
        : loop_(loop), seen_(seen), left_(loop.size()) {
        std::iota(left_.begin(), left_.end(), std::size_t{0});
    }

    std::size_t size() const { return left_.size(); }
    void drop(std::size_t k) { left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(k)); }
    std::array<std::size_t, 3> around(std::size_t k) const {
        return {left_[(k + size() - 1) % size()], left_[k], left_[(k + 1) % size()]};
    }

    /// "The first vertex at which the loop, as seen, turns back on itself or which stands where the one before it
    /// stands."
    std::optional<std::size_t> first_back_or_repeated() const {
        return first([](const Seen& a, const Seen& b, const Seen& c) {
            return a == b || (turn(a, b, c) == 0 && ahead(a, b, c) < 0);
        });
    }
    /// "The first straight vertex."
    std::optional<std::size_t> first_straight() const {
        return first(
            [](const Seen& a, const Seen& b, const Seen& c) { return turn(a, b, c) == 0 && ahead(a, b, c) > 0; });
    }
    /// "A vertex with a strict left turn whose open triangle, as seen, meets no remaining side, and of all such the
    /// one at the smallest position in space; of several there the first."
    std::optional<std::size_t> smallest_ear() const {
        std::optional<std::size_t> best;
        for (std::size_t k = 0; k < size(); ++k)
            if ((!best || loop_[left_[k]] < loop_[left_[*best]]) && is_ear(k)) best = k;
        return best;
    }

private:
    template <class Condition>
    std::optional<std::size_t> first(Condition holds) const {
        for (std::size_t k = 0; k < size(); ++k) {
            const auto [a, b, c] = around(k);
            if (holds(seen_[a], seen_[b], seen_[c])) return k;
        }
        return std::nullopt;
    }
    bool is_ear(std::size_t k) const {
        const auto [a, b, c] = around(k);
        const std::array<Seen, 3> triangle{seen_[a], seen_[b], seen_[c]};
        if (turn(triangle[0], triangle[1], triangle[2]) <= 0) return false;
        for (std::size_t j = 0; j < size(); ++j)
            if (meets_open_triangle({seen_[left_[j]], seen_[left_[(j + 1) % size()]]}, triangle)) return false;
        return true;
    }

    const std::vector<RationalPoint>& loop_;
    const std::vector<Seen>& seen_;
    std::vector<std::size_t> left_;
};

}  // namespace

Ears cut_ears(const std::vector<RationalPoint>& loop, const std::vector<Seen>& seen) {
    Ears ears;
    Rest rest(loop, seen);
    while (rest.size() >= 3) {
        if (const auto useless = rest.first_back_or_repeated()) {
            rest.drop(*useless);
        } else if (const auto ear = rest.smallest_ear()) {
            ears.triangles.push_back(rest.around(*ear));
            rest.drop(*ear);
        } else if (const auto straight = rest.first_straight()) {
            rest.drop(*straight);
        } else {
            ears.complete = false;
            break;
        }
    }
    return ears;
}

}  // namespace cob::naive
