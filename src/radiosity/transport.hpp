/// \file
/// What one shot brings to one element: the closed form, and the visible fraction by exact segments (SPEC 8).
#pragma once

#include "cob/candidates.hpp"
#include "cob/omissions.hpp"
#include "cob/solver.hpp"
#include "cob/visibility.hpp"
#include "radiosity/between.hpp"
#include "radiosity/mesh.hpp"
#include "radiosity/planes.hpp"
#include "radiosity/sheets.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace cob::radiosity {

/// How an element saw a shooter; kept for those who take over (choice 6).
enum class Sight : std::uint8_t {
    away,     ///< One lies behind the other.
    whole,    ///< All sample points were visible.
    partial,  ///< Some were.
    none,     ///< None was, or the element was skipped as occluded.
};

/// A point of a patch, by its parameters in it.
struct Sample {
    double s = 0, t = 0;
    Point position;       ///< In units, rounded.
    bool hidden = false;  ///< Under a sheet on top of it (choice 9).
};

/// One shot: who shot, and how much.
struct Shot {
    NodeId patch = -1;
    Rgb exitance{};  ///< W/m2.
    PatchShape shape;
    std::vector<Sample> samples, mixed_samples;
};

/// What an element got of a shooter.
struct Reception {
    double form_factor = 0;  ///< Obstructed.
    Sight sight = Sight::away;
};

/// Work of one thread at a time: lists that are reused, and counters.
struct TransportScratch {
    std::vector<Obstacle> between;
    std::vector<std::optional<Sign>> side_from;  ///< By place in `between`: of its plane, where the receiving point is.
    std::size_t last_blocker = 0;
    std::int64_t form_factors = 0, segments = 0, oracle_segments = 0, segments_left_out = 0, resampled = 0;
};

class Transport {
public:
    Transport(const Scene& scene, const Mesh& mesh, const CandidateSource& candidates, const Sheets& sheets,
              const RadiosityOptions& options, const Omissions& omissions);

    Shot make_shot(NodeId patch, const Rgb& exitance) const;
    /// The whole root lies behind the shooter or the shooter behind it, exactly: nothing passes.
    bool apart(const Shot& shot, RootId receiver) const;
    /// Closed form from the element's centroid to the whole patch, as if nothing stood between.
    double unobstructed(const Shot& shot, NodeId element, TransportScratch& scratch) const;
    /// The pieces that may stand between the shooter and a patch, where the list of them is used.
    void find_between(const Shot& shot, NodeId receiving_patch, TransportScratch& scratch) const;
    /// Closed form times visible fraction. `between` of the scratch must be of the element's patch. `unobstructed` is
    /// what unobstructed() says, where that is known already.
    Reception receive(const Shot& shot, NodeId element, TransportScratch& scratch,
                      std::optional<double> unobstructed = {}) const;
    /// Closed form times visible fraction at one point of an element, with so many samples of the shooter.
    double receive_at(const Shot& shot, NodeId element, double s, double t, int samples,
                      TransportScratch& scratch) const;
    /// As receive(), where the whole patch is known to be visible.
    Reception receive_unobstructed(const Shot& shot, NodeId element, TransportScratch& scratch) const;

    /// Point of an element at parameters (s, t), in units.
    Point point(NodeId element, double s, double t) const;
    const Planes& planes() const { return planes_; }

private:
    double form_factor(const Shot& shot, const Point& at, const Point& normal, TransportScratch& scratch) const;
    /// Sum of kernel weights of the samples in front of the receiver, and of these of the visible ones.
    struct Fraction {
        double all = 0, visible = 0;
        int tested = 0, clear = 0;
    };
    PatchShape shape_of(NodeId patch) const;
    /// No segment is needed: nothing stands between, and no sheet hides any of the shooter.
    bool is_clear(const Shot& shot, const TransportScratch& scratch) const;
    void find_sides(const Point& from, TransportScratch& scratch) const;
    std::vector<Sample> samples_of(NodeId patch, int count) const;
    Fraction fraction(const Shot& shot, const std::vector<Sample>& samples, NodeId element, const Sample& at,
                      TransportScratch& scratch) const;
    /// Weight that a segment transports: 1 clear, 0 blocked, half grazing, as near segments go to either side.
    double passes(const Shot& shot, const Sample& to, NodeId element, const Sample& from,
                  TransportScratch& scratch) const;
    ExactPoint exact(NodeId element, const Sample& sample) const;
    bool in_front(PieceId plane, NodeId element, const Sample& sample) const;

    const Scene& scene_;
    const Mesh& mesh_;
    const Sheets& sheets_;
    bool convex_, shaft_, filter_;  ///< What is left out (Omission).
    int samples_, mixed_samples_;
    Planes planes_;
    Between between_;
    VisibilityOracle oracle_;
    std::array<std::vector<Sample>, 2> receiving_;  ///< Of triangles and quadrilaterals; parameters only.
};

}  // namespace cob::radiosity
