#include "geometry/study.hpp"

#include "geometry/exact_kernel.hpp"
#include "geometry/interval_box.hpp"
#include "geometry/prepared_box.hpp"
#include "geometry/study_kernels.hpp"

#include <cmath>

namespace cob {
namespace {

BoxAnswer relate_binary32(const Scene& scene, PolygonId polygon, const Box::Prepared& box) {
    const auto rounded = [](const Vector3<double>& v) {
        return Vector3<float>{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
    };
    const Vector3<float> u = rounded(box.directions[0]), w = rounded(box.directions[1]), n = rounded(box.directions[2]);
    const Vector3<float> origin = rounded(box.origin);
    const auto to_frame = [&](const Point& p) {
        const Vector3<float> relative = rounded(p) - origin;
        return Vector3<float>{dot(u, relative), dot(w, relative), dot(n, relative)};
    };
    const FrameBox<float> frame{rounded(box.frame.low), rounded(box.frame.high)};
    return relate_with(PlainKernel<float>{}, frame, scene, polygon, to_frame);
}

/// A millionth of what is looked at: of the box and the polygon.
double tolerance(const Scene& scene, PolygonId polygon, const Box::Prepared& box) {
    double largest = box.size;
    for (const VertexId vertex : scene.loop(polygon)) {
        const Vector3<double> q = box.to_frame(scene.position(vertex));
        for (int axis = 0; axis < 3; ++axis) largest = std::max(largest, std::abs(q[axis]));
    }
    return 1e-6 * largest;
}

BoxAnswer relate_interval(const Scene& scene, PolygonId polygon, const Box::Prepared& box) {
    const IntervalBox& interval = box.intervals();
    const auto to_frame = [&](const Point& p) {
        Vector3<Interval> relative;
        for (int axis = 0; axis < 3; ++axis) relative[axis] = Interval(p[axis]) - Interval(interval.origin[axis]);
        return Vector3<Interval>{dot(interval.directions[0], relative), dot(interval.directions[1], relative),
                                 dot(interval.directions[2], relative)};
    };
    return relate_with(IntervalKernel{}, interval.frame, scene, polygon, to_frame);
}

BoxAnswer relate_rational(const Scene& scene, PolygonId polygon, const Box::Prepared& box) {
    const ExactBox& exact = box.exact();
    const Rational rise_squared = exact.rise_squared();
    const auto to_frame = [&](const Point& p) { return exact.to_frame(to_rational(p)); };
    return relate_with(RationalKernel(rise_squared), exact.frame, scene, polygon, to_frame);
}

}  // namespace

BoxAnswer relate(const Scene& scene, PolygonId polygon, const Box& box, Arithmetic arithmetic,
                 PredicateCounters* counters) {
    const Box::Prepared& prepared = box.prepared();
    const auto to_frame = [&](const Point& p) { return prepared.to_frame(p); };
    switch (arithmetic) {
        case Arithmetic::exact:
            return relate(scene, polygon, box, counters);
        case Arithmetic::binary32:
            return relate_binary32(scene, polygon, prepared);
        case Arithmetic::binary64:
            return relate_with(PlainKernel<double>{}, prepared.frame, scene, polygon, to_frame);
        case Arithmetic::epsilon:
            return relate_with(EpsilonKernel(tolerance(scene, polygon, prepared)), prepared.frame, scene, polygon,
                               to_frame);
        case Arithmetic::interval: {
            const BoxAnswer answer = relate_interval(scene, polygon, prepared);
            if (counters != nullptr) counters->undecided += answer.decided ? 0 : 1;
            return answer;
        }
        case Arithmetic::rational: {
            if (counters != nullptr) ++counters->rational;
            return relate_rational(scene, polygon, prepared);
        }
    }
    return {};
}

}  // namespace cob
