/// \file
/// The box as the filter sees it, and the exact box behind it, made when first needed.
#pragma once

#include "cob/geometry.hpp"
#include "geometry/aligned_box.hpp"
#include "geometry/exact_box.hpp"
#include "geometry/frame.hpp"
#include "geometry/grid_kernel.hpp"

#include <memory>
#include <mutex>

namespace cob {

struct IntervalBox;

struct Box::Prepared {
    BoxQuestion question;
    std::array<double, 6> bounds{};

    // The frame in binary64: unit directions times a power of two that brings the box's size between 2^-150 and
    // 2^150, so that nothing under- or overflows in its neighbourhood.
    bool usable = false;  ///< False: the box is too large, small or far out; everything goes to the exact stages.
    std::optional<AlignedBox> aligned;  ///< The frame is parallel to the coordinate axes, exactly.
    bool base_exact = false;            ///< The element's plane is z = 0 exactly.
    Point origin;
    std::array<Vector3<double>, 3> directions;
    double scale = 1;
    FrameBox<double> frame;
    double size = 0;   ///< Largest absolute coordinate of the box in the frame.
    double error = 0;  ///< Bound on the error of any coordinate, relative to the largest in the query (at least size).
    GridSteps grid;    ///< Steps on which the origin and the box lie exactly, unscaled; none where it is not aligned.

    explicit Prepared(const BoxQuestion& question);
    ~Prepared();

    const ExactBox& exact() const;
    const IntegerBox& integers() const;
    const IntervalBox& intervals() const;

    /// Inlined where the time goes.
    Vector3<double> to_frame(const Point& p) const {
        const Vector3<double> relative = p - origin;
        return {dot(directions[0], relative), dot(directions[1], relative), dot(directions[2], relative)};
    }

private:
    void put_on_grid();

    mutable std::once_flag exact_once_, integers_once_, intervals_once_;
    mutable std::unique_ptr<const ExactBox> exact_;
    mutable std::unique_ptr<const IntegerBox> integers_;
    mutable std::unique_ptr<const IntervalBox> intervals_;
};

}  // namespace cob
