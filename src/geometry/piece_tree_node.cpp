#include "geometry/piece_tree_node.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace cob {
namespace {

/// Rounding of parameters, see NodeSegment.
constexpr float later = 1 + 0x1p-20f;

float rounded_down(double value) {
    const float nearest = static_cast<float>(value);
    return static_cast<double>(nearest) <= value ? nearest
                                                 : std::nextafter(nearest, -std::numeric_limits<float>::infinity());
}

std::uint8_t byte(double number) {
    return static_cast<std::uint8_t>(std::clamp(number, 0.0, 255.0));
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] inline __m256 lanes_of(const std::array<std::uint8_t, 8>& bytes) {
    const __m128i packed = _mm_loadl_epi64(static_cast<const __m128i*>(static_cast<const void*>(bytes.data())));
    return _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(packed));
}

[[gnu::target("avx2")]] unsigned children_met_by_avx2(const PieceTreeNode& node, const NodeSegment& segment) {
    const Lanes step = node.step * segment.inverse, start = (node.origin - segment.origin) * segment.inverse;
    __m256 first = _mm256_setzero_ps(), last = _mm256_set1_ps(1);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const __m256 steps = _mm256_set1_ps(step[axis]), starts = _mm256_set1_ps(start[axis]);
        const __m256 in = lanes_of(node.bounds[segment.enter[axis]]), out = lanes_of(node.bounds[segment.leave[axis]]);
        first = _mm256_max_ps(_mm256_add_ps(_mm256_mul_ps(in, steps), starts), first);
        last = _mm256_min_ps(_mm256_add_ps(_mm256_mul_ps(out, steps), starts), last);
    }
    const __m256 met = _mm256_cmp_ps(first, _mm256_mul_ps(last, _mm256_set1_ps(later)), _CMP_LE_OQ);
    return static_cast<unsigned>(_mm256_movemask_ps(met)) & node.filled;
}
#endif

}  // namespace

void PieceTreeNode::set_bounds(const std::vector<Bounds>& of_children) {
    // 1. Numbers from 0 to 255 for all of them together.
    Bounds all;
    for (const Bounds& child : of_children) all.add(child);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        origin[axis] = rounded_down(all.low[axis]);
        step[axis] = -rounded_down((static_cast<double>(origin[axis]) - all.high[axis]) / 255);
        // 2. Each child's, rounded outward.
        for (std::size_t k = 0; k < of_children.size(); ++k) {
            const auto number = [&](double at) {
                return (at - static_cast<double>(origin[axis])) / static_cast<double>(step[axis]);
            };
            bounds[axis][k] = byte(std::floor(number(of_children[k].low[axis])));
            bounds[axis + 3][k] = byte(std::ceil(number(of_children[k].high[axis])));
        }
    }
    filled = (1u << of_children.size()) - 1;
}

NodeSegment::NodeSegment(const NormalSegment& segment) {
    // Along an axis on which the segment runs this little, it does not: the bounds are widened by far more.
    constexpr double still = 0x1p-40, inverse_of_still = 0x1p100;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double x = segment.from[static_cast<int>(axis)], d = segment.to[static_cast<int>(axis)] - x;
        origin[axis] = static_cast<float>(x);
        inverse[axis] = static_cast<float>(std::abs(d) > still ? 1 / d : inverse_of_still);
        enter[axis] = inverse[axis] < 0 ? axis + 3 : axis;
        leave[axis] = inverse[axis] < 0 ? axis : axis + 3;
    }
}

unsigned children_met(const PieceTreeNode& node, const NodeSegment& segment) {
    using Bytes = std::uint8_t __attribute__((vector_size(4)));
    const Lanes step = node.step * segment.inverse, start = (node.origin - segment.origin) * segment.inverse;
    unsigned met = 0;
    for (std::size_t half = 0; half < 8; half += 4) {
        Lanes first = all_lanes(0), last = all_lanes(1);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Bytes in, out;
            std::memcpy(&in, &node.bounds[segment.enter[axis]][half], sizeof in);
            std::memcpy(&out, &node.bounds[segment.leave[axis]][half], sizeof out);
            first = greater(__builtin_convertvector(in, Lanes) * step[axis] + start[axis], first);
            last = lesser(__builtin_convertvector(out, Lanes) * step[axis] + start[axis], last);
        }
        met |= bits_of(first <= last * later) << half;
    }
    return met & node.filled;
}

ChildrenMet children_met_of_processor() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2")) return children_met_by_avx2;
#endif
    return nullptr;
}

}  // namespace cob
