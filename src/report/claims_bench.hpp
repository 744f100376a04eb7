/// \file
/// What the claims are measured with: scenes, runs that several claims share, and the registry.
#pragma once

#include "cob/claims.hpp"
#include "cob/solver.hpp"
#include "cob/study.hpp"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cob::claims {

/// A run under full transport, and what claims ask of it.
struct RunRecord {
    std::vector<double> shot_seconds;
    std::vector<std::int64_t> shot_elements;             ///< Before each shot.
    std::vector<std::int64_t> shot_nodes, shot_buffers;  ///< Elements of all levels and buffers built, after it.
    RadiosityCounters counters;
    RadiosityTimes times;
    double processor_seconds = 0;  ///< Of all threads: steadier than the clock where a machine does other work.
    std::size_t elements = 0, nodes = 0, buffers = 0, buffer_bytes = 0, occluded = 0;
};

/// The scenes and options of one measurement.
class Bench {
public:
    explicit Bench(const ClaimOptions& options) : options_(options) {}

    const ClaimOptions& options() const { return options_; }
    bool quick() const { return options_.quick; }
    /// A shipped scene, read once.
    const Scene& scene(const std::string& name);
    /// Names of scenes: the first `quick_count` where it is to be quick.
    std::vector<std::string> names(std::vector<std::string> all, std::size_t quick_count) const;
    /// Longest extent of a scene over so many.
    double edge(const Scene& scene, double parts) const;

    /// A case has been measured; throws where the user has had enough.
    void tick();
    /// Takes shots until a stop is reached.
    void solve(RadiositySolver& solver);
    RunRecord run(const Scene& scene, const RadiosityOptions& options);
    /// The same, kept under a name: several claims may be about one run.
    const RunRecord& run_once(const std::string& name, const Scene& scene, const RadiosityOptions& options);
    /// 100 shots with the buffer on a shipped scene; 30, on larger patches, where it is to be quick.
    const RunRecord& buffer_run(const std::string& name);
    /// One run of a study of direct light; light patches of a fixed size.
    StudyRun study(const Scene& scene, const StudyReference& reference, Refinement refinement, double patch_edge,
                   double minimum_edge, const Rational& height = Rational(1, 4), int repeats = 1);
    /// Points and exact light of a shipped scene, made once.
    const StudyReference& reference(const std::string& name, std::size_t points);

private:
    const ClaimOptions& options_;
    std::uint64_t done_ = 0;
    std::map<std::string, Scene> scenes_;
    std::map<std::string, RunRecord> runs_;
    std::map<std::string, StudyReference> references_;
};

/// The pencil on the desk: a scene of what is around it with the lights, and where its shadow falls.
struct PencilScene {
    Scene scene;
    StudyRegion region;
    double width = 0;  ///< Of the pencil.
};
PencilScene pencil_on_desk(const Scene& desk);

/// One entry of the registry.
struct Claim {
    const char* id;
    const char* text;
    const char* where;
    const char* criterion;
    const char* condition;
    void (*measure)(Bench& bench, ClaimResult& result);
};
/// By what is measured: error against the exact irradiance, counters and times of runs, buffers alone, what is seen.
std::vector<Claim> error_claims();
std::vector<Claim> run_claims();
std::vector<Claim> buffer_claims();
std::vector<Claim> sight_claims();

}  // namespace cob::claims
