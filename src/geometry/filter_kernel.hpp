/// \file
/// The filter: signs in binary64 with semi-static error bounds.
///
/// With u = 2^-53, M the largest absolute frame coordinate in the query and E the bound of Box::Prepared::error,
/// every coordinate is wrong by at most E M, so that
///   a difference (at most 2M) by D = (2E + 2u) M,
///   a determinant of differences, or d.(c - q) with d of two components, by 2 (4 M D + D^2 + 4 u M^2) + 8 u M^2
///       < (17 E + 33 u) M^2; choosing the wrong corner c, where a component of d has the wrong sign, adds at most
///       2 M D for each of two components: (25 E + 41 u) M^2,
///   d.(c - q) with d = N (each component at most 8 M^2, wrong as above) by 3 (8 M^2 D + 2 M (17 E + 33 u) M^2 +
///       2 * 16 u M^3) + 2 * 48 u M^3, wrong corners 3 * 2 M (17 E + 33 u) M^2: (252 E + 636 u) M^3.
/// A fan of m triangles multiplies the bounds of N by m. M is at least the box's size, which is at least 2^-150,
/// so that what underflows is far below every bound; corners that could overflow never come here.
#pragma once

#include "arithmetic/uncertain_sign.hpp"
#include "geometry/frame.hpp"

#include <algorithm>

namespace cob {

class FilterKernel {
public:
    using Number = double;

    /// largest: M; error: E; fan: triangles in the piece's fan.
    FilterKernel(double largest, double error, int fan, bool base_exact)
        : face_bound_((2 * error + 3 * unit) * largest),
          base_bound_(base_exact ? 0 : face_bound_),
          edge_bound_((26 * error + 42 * unit) * largest * largest),
          turn_bound_(edge_bound_ * fan),
          plane_bound_((260 * error + 640 * unit) * largest * largest * largest * fan) {}

    UncertainSign face(double gap, int) const { return filtered_sign(gap, face_bound_); }
    UncertainSign base(double gap) const { return filtered_sign(gap, base_bound_); }
    UncertainSign top(double gap) const { return filtered_sign(gap, face_bound_); }
    UncertainSign edge(double gap, const Vector3<double>&, bool) const { return filtered_sign(gap, edge_bound_); }
    template <class Offset>
    UncertainSign plane(double gap, const Vector3<double>&, const Offset&, bool) const {
        return filtered_sign(gap, plane_bound_);
    }
    UncertainSign turn(double value, int) const { return filtered_sign(value, turn_bound_); }

private:
    static constexpr double unit = 0x1p-53;
    double face_bound_, base_bound_, edge_bound_, turn_bound_, plane_bound_;
};

}  // namespace cob
