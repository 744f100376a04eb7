// Checks a small float implementation against a golden set: all of it, in one file, with the standard library alone.
//
//     verify_example data/golden/cornell
#include "cob/verify.hpp"

#include <cstdio>

namespace {

using cob::verify::Segment;
using cob::verify::Set;

struct Vec {
    float x, y, z;
};
Vec to_float(const cob::verify::Vector& v) {
    return {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
}
Vec operator-(Vec a, Vec b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
Vec cross(Vec a, Vec b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
float dot(Vec a, Vec b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Moeller and Trumbore's ray and triangle (1997), as it is everywhere.
bool hits(Vec origin, Vec direction, Vec a, Vec b, Vec c) {
    const Vec e1 = b - a, e2 = c - a, p = cross(direction, e2), s = origin - a, q = cross(s, e1);
    const float determinant = dot(e1, p);
    if (std::abs(determinant) < 1e-12F) return false;
    const float u = dot(s, p) / determinant, v = dot(direction, q) / determinant, t = dot(e2, q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 1e-5F && t < 1 - 1e-5F;
}

/// Is something strictly between the ends of the segment?
bool hidden(const Set& set, const Segment& segment) {
    const Vec from = to_float(segment.from), along = to_float(segment.to) - from;
    for (const auto& polygon : set.polygons)
        for (const auto& [a, b, c] : polygon.triangles)
            if (hits(from, along, to_float(a), to_float(b), to_float(c))) return true;
    return false;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) return std::fprintf(stderr, "usage: verify_example SET\n"), 2;
    const Set set = cob::verify::load_set(argv[1]);
    const auto report = cob::verify::check(set, nullptr, [&](const Segment& segment) { return hidden(set, segment); });
    std::fputs(to_text(report).c_str(), stdout);
    return report.agree() ? 0 : 1;
} catch (const cob::verify::Error& error) {
    return std::fprintf(stderr, "%s\n", error.what()), 2;
}
