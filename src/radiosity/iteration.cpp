/// One iteration of progressive refinement with the buffer inside (the paper's section 5).
#include "radiosity/state.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace cob {

using namespace radiosity;

namespace {

/// Overshooting foresees no more bounces than this mean reflectance has: with more, the closure error of the form
/// factors, a few thousandths, times their number passes 1, and the overshooting never ends (rho = 0.9999).
constexpr double most_foreseen_reflectance = 0.995;

Classification nothing_close() {
    Classification result;
    result.state = BufferState::empty;
    return result;
}

}  // namespace

bool RadiositySolver::State::stopped() const {
    return counters.shots >= options.stop.shots || is_full() || unshot_share() <= options.stop.unshot;
}

bool RadiositySolver::State::step() {
    if (stopped()) return false;
    const NodeId patch = brightest_patch();
    if (patch < 0) return false;
    shots.push_back(take_shot(patch));
    ++counters.shots;
    bring(shots.back());
    if (uses_gradient()) refine_by_gradient();
    return true;
}

Rgb RadiositySolver::State::flux_to_shoot(NodeId patch, const Rgb& foreseen) const {
    Rgb flux = unshot_flux[static_cast<std::size_t>(patch)];
    for (std::size_t c = 0; c < 3; ++c) flux[c] += area(patch) * material(patch).reflectance[c] * foreseen[c];
    return flux;
}

NodeId RadiositySolver::State::brightest_patch() const {
    // By what it would shoot: after overshooting, what it owes can be the most of all and wait for what is foreseen.
    const Rgb foreseen = options.overshoot ? ambient(most_foreseen_reflectance) : Rgb{};
    NodeId best = -1;
    double most = 0;
    for (const NodeId patch : shooters) {
        const Rgb shot = flux_to_shoot(patch, foreseen);
        const double flux = std::fabs(shot[0]) + std::fabs(shot[1]) + std::fabs(shot[2]);
        if (flux > most && area(patch) > 0) {
            most = flux;
            best = patch;
        }
    }
    return best;
}

Shot RadiositySolver::State::take_shot(NodeId patch) {
    const auto p = static_cast<std::size_t>(patch);
    // Overshooting (Feda and Purgathofer 1992): the patch's share of the ambient term is going to arrive anyway.
    const Rgb foreseen = options.overshoot ? ambient(most_foreseen_reflectance) : Rgb{};
    const Rgb flux = flux_to_shoot(patch, foreseen);
    Rgb exitance;
    for (std::size_t c = 0; c < 3; ++c) {
        exitance[c] = flux[c] / area(patch);
        unshot_flux[p][c] -= flux[c];
        shot_flux[p][c] += flux[c];
    }
    return transport->make_shot(patch, exitance);
}

/// Brings one shot to every leaf, each exactly once (choice 6).
void RadiositySolver::State::bring(const Shot& shot) {
    // All leaves, by patch, but those of roots that cannot see the shooter.
    std::vector<Batch> batches;
    for (RootId root = 0; root < roots.size(); ++root) {
        if (transport->apart(shot, root)) continue;
        const auto [first, last] = mesh->patches_of(root);
        for (NodeId patch = first; patch < last; ++patch) {
            Batch batch;
            batch.patch = patch;
            for (const NodeId leaf : leaves[static_cast<std::size_t>(patch)])
                batch.work.push_back({leaf, Work::Action::skip, 0});
            batches.push_back(std::move(batch));
        }
    }

    double given = 0;
    const double taken = sum(shot.exitance) * area(shot.patch);
    while (!batches.empty()) {
        const auto for_each_batch = [&](const auto& act) {
            arena_.execute(
                [&] { tbb::parallel_for(std::size_t(0), batches.size(), [&](std::size_t k) { act(batches[k]); }); });
        };
        {
            const PhaseTimer timer(times.interaction);
            for_each_batch([&](Batch& batch) { decide(shot, batch); });
        }
        if (uses_buffer()) {
            const PhaseTimer timer(times.buffer);
            build_buffers(batches);
        }
        {
            const PhaseTimer timer(times.shooting);
            for_each_batch([&](Batch& batch) { shoot(shot, batch); });
        }

        // Sums in the order of patches, whatever thread did the work.
        for (const Batch& batch : batches) {
            given += sum(batch.given);
            for (std::size_t c = 0; c < 3; ++c)
                unshot_flux[static_cast<std::size_t>(batch.patch)][c] += batch.reflected[c];
            counters.interactions += batch.counters.interactions;
            counters.form_factors += batch.counters.form_factors;
            counters.segments += batch.counters.segments;
            counters.oracle_segments += batch.counters.oracle_segments;
            counters.segments_left_out += batch.counters.segments_left_out;
            counters.skipped_occluded += batch.counters.skipped_occluded;
            counters.buffers_left_out += batch.counters.buffers_left_out;
            count(batch.statistics);
        }
        const PhaseTimer timer(times.refinement);
        batches = refine_put_aside(batches);
    }

    const double closure = given / taken;
    closure_sum += closure;
    flux_taken += std::fabs(taken);
    flux_arrived += std::fabs(given);
    flux_off += std::fabs(given - taken);
    if (closure_least_patch < 0 || closure < closure_least) {
        closure_least = closure;
        closure_least_patch = shot.patch;
    }
    if (closure_most_patch < 0 || closure > closure_most) {
        closure_most = closure;
        closure_most_patch = shot.patch;
    }
}

/// Step 1: totally occluded, by the buffer or by a sheet in its plane: no shot.
bool RadiositySolver::State::is_skipped(const Cell& cell) const {
    return cell.cover.kind == Cover::Kind::wholly ||
           (uses_buffer() && options.buffer.skip_occluded && cell.buffer.state() == BufferState::occluded);
}

/// Steps 1 and 2 of the paper's section 5, as far as they need no new buffer.
void RadiositySolver::State::decide(const Shot& shot, Batch& batch) const {
    TransportScratch scratch;
    for (Work& work : batch.work) {
        work.action = Work::Action::skip;
        const Cell& cell = cells[static_cast<std::size_t>(work.leaf)];
        if (is_skipped(cell)) {
            ++batch.counters.skipped_occluded;
            continue;
        }
        work.form_factor = transport->unobstructed(shot, work.leaf, scratch);
        if (work.form_factor == 0 && options.receiving_points == 1) continue;
        // Step 2: a weak interaction, or an element that is small enough: shoot.
        work.action = Work::Action::shoot;
        if (!uses_buffer() || is_full() || is_deepest(work.leaf) ||
            cell.longest_side <= std::scalbn(options.buffer.minimum_edge, -mesh->exponent()))
            continue;
        if (!is_strong(shot, work)) continue;
        // Step 3: the buffer decides.
        work.action = Work::Action::ask_buffer;
        batch.asks = true;
    }
    count(scratch, batch.counters);
}

/// Equation (1) as SPEC 8 has it (choice 7).
bool RadiositySolver::State::is_strong(const Shot& shot, const Work& work) const {
    const Material& m = material(work.leaf);
    double strength = 0, reference = 0;
    switch (options.buffer.strength) {
        case Strength::exitance:
            for (std::size_t c = 0; c < 3; ++c)
                strength += m.reflectance[c] * std::fabs(shot.exitance[c]) * work.form_factor;
            reference = sum(exitance(work.leaf));
            break;
        case Strength::flux:
            for (std::size_t c = 0; c < 3; ++c) {
                strength += area(work.leaf) * m.reflectance[c] * std::fabs(shot.exitance[c]) * work.form_factor;
                reference += area(shot.patch) * std::fabs(shot.exitance[c]);
            }
            break;
        case Strength::paper: {
            // From centre to centre, without the shooter's exitance.
            const double third = 1.0 / 3;
            const bool triangle = mesh->node(work.leaf).corner_count() == 3,
                       from_triangle = shot.shape.corner_count == 3;
            const Point from = transport->point(work.leaf, triangle ? third : 0.5, triangle ? third : 0.5);
            const Point to = transport->point(shot.patch, from_triangle ? third : 0.5, from_triangle ? third : 0.5);
            const Point d = to - from;
            const Planes& planes = transport->planes();
            const PieceId piece = roots[mesh->node(work.leaf).element.root].piece;
            const double cosines = dot(planes.normal(piece), d) * -dot(planes.normal(shot.shape.piece), d);
            strength = sum(m.reflectance) / 3 * std::max(cosines, 0.0) * area(shot.patch) /
                       (3.14159265358979323846 * dot(d, d) * dot(d, d));
            reference = 1;
            break;
        }
    }
    return strength > 0 && strength > options.buffer.threshold * reference;
}

/// The nearest element around a leaf whose buffer is built; of two levels, its root's.
CloseObjectBuffer RadiositySolver::State::around(NodeId leaf) const {
    const Node& node = mesh->node(leaf);
    if (options.buffer.levels == BufferLevels::element) return {};
    if (options.buffer.levels == BufferLevels::tree)
        for (NodeId up = node.parent; up >= 0; up = mesh->node(up).parent)
            if (cells[static_cast<std::size_t>(up)].buffer.is_built())
                return cells[static_cast<std::size_t>(up)].buffer;
    return root_buffers[static_cast<std::size_t>(node.element.root)];
}

CloseObjectBuffer RadiositySolver::State::build_root_buffer(RootId root, BufferStatistics* statistics) {
    if (omissions(Omission::buffers)) return builder->keep(nothing_close());
    return builder->build(root_element(root), statistics);
}

CloseObjectBuffer RadiositySolver::State::build_buffer(NodeId leaf, BufferStatistics* statistics) {
    if (omissions(Omission::buffers)) return builder->keep(nothing_close());
    const CloseObjectBuffer parent = around(leaf);
    const Element& element = mesh->node(leaf).element;
    return parent.is_built() ? builder->build(element, parent, statistics) : builder->build(element, statistics);
}

/// Step 3: builds what is asked for, then begins again at step 1: the buffer may have turned out occluded.
void RadiositySolver::State::build_buffers(std::vector<Batch>& batches) {
    // The buffers over whole pieces first (section 7), each the first time it is needed.
    if (options.buffer.levels != BufferLevels::element) {
        std::vector<RootId> needed;
        for (const Batch& batch : batches) {
            const RootId root = mesh->node(batch.patch).element.root;
            const bool asked = batch.asks && std::any_of(batch.work.begin(), batch.work.end(), [&](const Work& work) {
                                   return work.action == Work::Action::ask_buffer &&
                                          !cells[static_cast<std::size_t>(work.leaf)].buffer.is_built();
                               });
            if (asked && !root_buffers[static_cast<std::size_t>(root)].is_built() &&
                (needed.empty() || needed.back() != root))
                needed.push_back(root);
        }
        std::vector<BufferStatistics> statistics(needed.size());
        arena_.execute([&] {
            tbb::parallel_for(std::size_t(0), needed.size(), [&](std::size_t k) {
                root_buffers[static_cast<std::size_t>(needed[k])] = build_root_buffer(needed[k], &statistics[k]);
            });
        });
        for (const BufferStatistics& s : statistics) count(s);
    }

    arena_.execute([&] {
        tbb::parallel_for(std::size_t(0), batches.size(), [&](std::size_t k) {
            if (!batches[k].asks) return;
            for (Work& work : batches[k].work) {
                if (work.action != Work::Action::ask_buffer) continue;
                Cell& cell = cells[static_cast<std::size_t>(work.leaf)];
                if (!cell.buffer.is_built()) {
                    cell.buffer = build_buffer(work.leaf, &batches[k].statistics);
                    if (omissions(Omission::buffers)) ++batches[k].counters.buffers_left_out;
                }
                switch (cell.buffer.state()) {
                    case BufferState::occluded:
                        if (!options.buffer.skip_occluded) {
                            work.action = Work::Action::shoot;
                            break;
                        }
                        work.action = Work::Action::skip;
                        ++batches[k].counters.skipped_occluded;
                        break;
                    case BufferState::close:
                        work.action = Work::Action::put_aside;
                        break;
                    case BufferState::empty:
                    case BufferState::uninitialised:
                        // A sheet in its own plane is no close polygon (SPEC 5), but an edge of one all the same.
                        work.action =
                            cell.cover.kind == Cover::Kind::partly ? Work::Action::put_aside : Work::Action::shoot;
                        break;
                }
            }
        });
    });
}

void RadiositySolver::State::shoot(const Shot& shot, Batch& batch) {
    TransportScratch scratch;
    bool found = false;
    const std::size_t number = shots.size() - 1;
    for (const Work& work : batch.work) {
        if (work.action == Work::Action::put_aside) continue;
        Cell& cell = cells[static_cast<std::size_t>(work.leaf)];
        if (work.action == Work::Action::skip) {
            const bool away = work.form_factor == 0 && !is_skipped(cell);
            if (options.refinement != Refinement::none)
                set_sight(cell.sights, number, away ? Sight::away : Sight::none);
            continue;
        }
        if (!found) transport->find_between(shot, batch.patch, scratch);
        found = true;
        const Reception reception = transport->receive(shot, work.leaf, scratch, work.form_factor);
        ++batch.counters.interactions;
        if (options.refinement != Refinement::none) set_sight(cell.sights, number, reception.sight);
        const Material& m = material(work.leaf);
        for (std::size_t c = 0; c < channels_; ++c) {
            const double irradiance = shot.exitance[c] * reception.form_factor;
            cell.irradiance[c] += irradiance;
            batch.given[c] += cell.area * irradiance;
            batch.reflected[c] += cell.area * m.reflectance[c] * irradiance;
        }
        spread(cell.irradiance);
    }
    spread(batch.given);
    spread(batch.reflected);
    count(scratch, batch.counters);
}

void RadiositySolver::State::count(const BufferStatistics& statistics) {
    for (std::size_t k = 0; k < 4; ++k) counters.buffers[k] += static_cast<std::int64_t>(statistics.built[k]);
    counters.light_tests += static_cast<std::int64_t>(statistics.light_tests);
}

void RadiositySolver::State::count(const TransportScratch& scratch, RadiosityCounters& into) const {
    into.form_factors += scratch.form_factors;
    into.segments += scratch.segments;
    into.oracle_segments += scratch.oracle_segments;
    into.segments_left_out += scratch.segments_left_out;
    into.resampled += scratch.resampled;
}

}  // namespace cob
