/// \file
/// The solver's state: mesh, exitance of every element, unshot flux of every patch, buffers and books.
///
/// Letters as in SPEC 8: M exitance, rho reflectance, F form factor, A area (in square units, mesh.hpp); i receives,
/// j shoots.
#pragma once

#include "cob/solver.hpp"
#include "radiosity/mesh.hpp"
#include "radiosity/sheets.hpp"
#include "radiosity/transport.hpp"

#include <tbb/task_arena.h>

#include <chrono>
#include <memory>
#include <string>
#include <vector>

namespace cob {

/// Adds the time of its life to a phase.
class PhaseTimer {
public:
    explicit PhaseTimer(double& phase) : phase_(phase), begin_(std::chrono::steady_clock::now()) {}
    ~PhaseTimer() { phase_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count(); }
    PhaseTimer(const PhaseTimer&) = delete;
    PhaseTimer& operator=(const PhaseTimer&) = delete;

private:
    double& phase_;
    std::chrono::steady_clock::time_point begin_;
};

class RadiositySolver::State {
public:
    State(const Scene& scene, RadiosityOptions options);

    bool step();
    bool stopped() const;
    double unshot_share() const;
    EnergyBooks books() const;
    std::vector<Rgb> vertex_exitance() const;
    Rgb ambient(double most_reflectance = 1) const;
    std::string checkpoint() const;
    void resume(const std::string& text);

    Rgb exitance(radiosity::NodeId node) const;
    double area(radiosity::NodeId node) const;  ///< What of it no sheet hides.
    const Material& material(radiosity::NodeId node) const;

    /// What the solver knows of a patch or an element.
    struct Cell {
        Rgb irradiance{};         ///< W/m2, of a leaf.
        double area = 0;          ///< In square units.
        double longest_side = 0;  ///< In units.
        radiosity::Cover cover;
        CloseObjectBuffer buffer;
        std::vector<std::uint8_t> sights;  ///< Of a leaf: Sight of each shot, four a byte.
    };

    const Scene& scene;
    RadiosityOptions options;
    Roots roots;
    Omissions omissions;
    std::unique_ptr<CandidateSource> candidates;
    std::unique_ptr<radiosity::Mesh> mesh;
    std::unique_ptr<radiosity::Sheets> sheets;
    std::unique_ptr<radiosity::Transport> transport;
    std::unique_ptr<BufferBuilder> builder;

    std::vector<Cell> cells;  ///< By node.
    std::vector<CloseObjectBuffer> root_buffers;
    std::vector<std::vector<radiosity::NodeId>> leaves;  ///< By patch.
    std::vector<radiosity::NodeId> shooters;             ///< Patches that may ever have something to shoot.
    std::vector<Rgb> unshot_flux, shot_flux;             ///< By patch, in W per (scene unit / unit)^2.
    std::vector<radiosity::Shot> shots;
    std::vector<radiosity::NodeId> splits;  ///< In order: the mesh's history.
    Rgb emitted_flux{};
    double flux_taken = 0, flux_arrived = 0;  ///< Sums over shots of what left the shooter, and of what arrived.
    double flux_off = 0;                      ///< Sum over shots of the difference of the two.
    double flux_moved = 0;                    ///< Sum over channels of corrections.
    double closure_sum = 0, closure_least = 0, closure_most = 0;
    radiosity::NodeId closure_least_patch = -1, closure_most_patch = -1;
    RadiosityCounters counters;
    RadiosityTimes times;

private:
    /// An element that a shot has to be brought to.
    struct Work {
        enum class Action : std::uint8_t { skip, ask_buffer, shoot, put_aside };
        radiosity::NodeId leaf = -1;
        Action action = Action::skip;
        double form_factor = 0;  ///< Unobstructed, at its centroid.
    };
    /// The work in one patch, and what came of it.
    struct Batch {
        radiosity::NodeId patch = -1;
        std::vector<Work> work;
        bool asks = false;  ///< Some of it asks for a buffer.
        Rgb given{};        ///< Flux received.
        Rgb reflected{};    ///< Of it, made unshot flux.
        RadiosityCounters counters;
        BufferStatistics statistics;
    };

    static RadiosityOptions checked(const Scene& scene, RadiosityOptions options);
    void add_cells();
    bool uses_buffer() const;
    bool uses_gradient() const;

    // One iteration (iteration.cpp).
    radiosity::NodeId brightest_patch() const;
    Rgb flux_to_shoot(radiosity::NodeId patch, const Rgb& foreseen) const;  ///< Unshot and foreseen, W in units.
    radiosity::Shot take_shot(radiosity::NodeId patch);
    void bring(const radiosity::Shot& shot);
    bool is_skipped(const Cell& cell) const;
    void decide(const radiosity::Shot& shot, Batch& batch) const;
    bool is_strong(const radiosity::Shot& shot, const Work& work) const;
    void build_buffers(std::vector<Batch>& batches);
    CloseObjectBuffer around(radiosity::NodeId leaf) const;
    CloseObjectBuffer build_root_buffer(RootId root, BufferStatistics* statistics = nullptr);
    CloseObjectBuffer build_buffer(radiosity::NodeId leaf, BufferStatistics* statistics = nullptr);
    void shoot(const radiosity::Shot& shot, Batch& batch);

    // Refinement (refinement.cpp).
    std::vector<Batch> refine_put_aside(const std::vector<Batch>& batches);
    void refine_by_gradient();
    /// Splits leaves as far as the stop allows; returns all that was split, for balance, too, in order.
    std::vector<radiosity::NodeId> split(const std::vector<radiosity::NodeId>& leaves_to_split);
    /// Children take over what their parents received from the first shot_count(parent) shots (choice 6).
    void take_over(const std::vector<radiosity::NodeId>& parents, const std::vector<std::size_t>& shot_counts);
    void take_over(radiosity::NodeId parent, std::size_t shot_count, radiosity::TransportScratch& scratch);
    bool is_full() const;
    /// Refined no further: the mesh's lattice (Element, level 31) must have room for neighbours and middles of sides.
    bool is_deepest(radiosity::NodeId leaf) const;
    void refresh_leaves(const std::vector<radiosity::NodeId>& parents);
    void count(const radiosity::TransportScratch& scratch, RadiosityCounters& into) const;
    void count(const BufferStatistics& statistics);

    /// Of a grey scene one channel is computed, and the others are the same.
    void spread(Rgb& value) const {
        if (channels_ == 1) value[1] = value[2] = value[0];
    }

    std::size_t channels_ = 3;
    tbb::task_arena arena_;
};

/// Bit access to Cell::sights.
inline radiosity::Sight sight_of(const std::vector<std::uint8_t>& sights, std::size_t shot) {
    return shot / 4 < sights.size() ? static_cast<radiosity::Sight>(sights[shot / 4] >> (shot % 4 * 2) & 3)
                                    : radiosity::Sight::away;
}
inline void set_sight(std::vector<std::uint8_t>& sights, std::size_t shot, radiosity::Sight sight) {
    if (sights.size() <= shot / 4) sights.resize(shot / 4 + 1);
    std::uint8_t& byte = sights[shot / 4];
    byte = static_cast<std::uint8_t>((byte & ~(3 << (shot % 4 * 2))) | static_cast<int>(sight) << (shot % 4 * 2));
}

inline double sum(const Rgb& c) {
    return c[0] + c[1] + c[2];
}

}  // namespace cob
