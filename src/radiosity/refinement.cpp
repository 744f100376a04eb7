/// Refinement: what the buffer put aside, and where exitance changes fast (the paper's section 6; SPEC 8, choice 6).
#include "radiosity/state.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <unordered_set>

namespace cob {

using namespace radiosity;

bool RadiositySolver::State::is_full() const {
    return static_cast<std::int64_t>(mesh->leaf_count()) >= options.stop.elements;
}

bool RadiositySolver::State::is_deepest(NodeId leaf) const {
    const Element& element = mesh->node(leaf).element;
    return std::max(element.level_i, element.level_j) >= 29;
}

std::vector<NodeId> RadiositySolver::State::split(const std::vector<NodeId>& leaves_to_split) {
    std::vector<NodeId> parents;
    for (const NodeId leaf : leaves_to_split)
        if (!is_full()) mesh->refine(leaf, parents);
    splits.insert(splits.end(), parents.begin(), parents.end());
    add_cells();
    refresh_leaves(parents);
    return parents;
}

void RadiositySolver::State::refresh_leaves(const std::vector<NodeId>& parents) {
    std::vector<NodeId> patches;
    for (const NodeId parent : parents) patches.push_back(mesh->node(parent).patch);
    std::sort(patches.begin(), patches.end());
    patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
    for (const NodeId patch : patches) {
        std::vector<NodeId>& of_patch = leaves[static_cast<std::size_t>(patch)];
        of_patch.clear();
        mesh->append_leaves(patch, of_patch);
    }
}

/// End of an iteration: elements put aside are refined, and their children are the work of the next round.
std::vector<RadiositySolver::State::Batch> RadiositySolver::State::refine_put_aside(const std::vector<Batch>& batches) {
    std::vector<NodeId> aside;
    for (const Batch& batch : batches)
        for (const Work& work : batch.work)
            if (work.action == Work::Action::put_aside) aside.push_back(work.leaf);
    if (aside.empty()) return {};
    const std::vector<NodeId> parents = split(aside);

    // Who still waits for this shot: what was put aside, or lies in it. Everybody else has had it already.
    std::unordered_set<NodeId> waiting(aside.begin(), aside.end());
    std::vector<std::size_t> shot_counts;
    std::vector<NodeId> left = aside;
    for (const NodeId parent : parents) {
        const bool waits = waiting.count(parent) > 0;
        shot_counts.push_back(waits ? shots.size() - 1 : shots.size());
        ++(waits ? counters.put_aside : counters.refined_for_balance);
        if (!waits) continue;
        for (NodeId k = 0; k < 4; ++k) {
            waiting.insert(mesh->node(parent).first_child + k);
            left.push_back(mesh->node(parent).first_child + k);
        }
    }
    take_over(parents, shot_counts);

    left.erase(std::remove_if(left.begin(), left.end(), [&](NodeId n) { return !mesh->node(n).is_leaf(); }),
               left.end());
    std::sort(left.begin(), left.end(), [&](NodeId a, NodeId b) {
        const NodeId patch_a = mesh->node(a).patch, patch_b = mesh->node(b).patch;
        return patch_a != patch_b ? patch_a < patch_b : a < b;
    });
    std::vector<Batch> next;
    for (const NodeId leaf : left) {
        const NodeId patch = mesh->node(leaf).patch;
        if (next.empty() || next.back().patch != patch) {
            next.emplace_back();
            next.back().patch = patch;
        }
        next.back().work.push_back({leaf, Work::Action::skip, 0});
    }
    return next;
}

void RadiositySolver::State::refine_by_gradient() {
    std::vector<NodeId> chosen;
    {
        const PhaseTimer timer(times.gradient);
        const std::vector<Rgb> at_vertices = vertex_exitance();
        Rgb floor{};
        double all = 0;
        for (const auto& of_patch : leaves)
            for (const NodeId leaf : of_patch) {
                const Rgb m = exitance(leaf);
                all += area(leaf);
                for (std::size_t c = 0; c < 3; ++c) floor[c] += area(leaf) * m[c];
            }
        for (double& f : floor) f *= options.gradient.floor / all;

        const double shortest = std::scalbn(options.gradient.minimum_edge, -mesh->exponent());
        for (const auto& of_patch : leaves)
            for (const NodeId leaf : of_patch) {
                const Cell& cell = cells[static_cast<std::size_t>(leaf)];
                if (cell.cover.kind == Cover::Kind::wholly || cell.buffer.state() == BufferState::occluded) continue;
                if (cell.longest_side <= shortest || is_deepest(leaf)) continue;
                // The difference of exitance between corners against its mean, channel by channel.
                const Node& node = mesh->node(leaf);
                bool steep = false;
                for (std::size_t c = 0; c < 3; ++c) {
                    double least = std::numeric_limits<double>::infinity(), most = -least, mean = 0;
                    for (int k = 0; k < node.corner_count(); ++k) {
                        const double m =
                            at_vertices[static_cast<std::size_t>(node.corners[static_cast<std::size_t>(k)])][c];
                        least = std::min(least, m);
                        most = std::max(most, m);
                        mean += m / node.corner_count();
                    }
                    steep = steep || most - least > options.gradient.threshold[c] * std::max(mean, floor[c]);
                }
                if (steep) chosen.push_back(leaf);
            }
    }
    if (chosen.empty()) return;
    const PhaseTimer timer(times.refinement);
    const std::vector<NodeId> parents = split(chosen);
    const std::unordered_set<NodeId> by_gradient(chosen.begin(), chosen.end());
    for (const NodeId parent : parents)
        ++(by_gradient.count(parent) > 0 ? counters.refined_by_gradient : counters.refined_for_balance);
    take_over(parents, std::vector<std::size_t>(parents.size(), shots.size()));
}

// ---------------------------------------------------------------------------------------------- taking over

void RadiositySolver::State::take_over(const std::vector<NodeId>& parents,
                                       const std::vector<std::size_t>& shot_counts) {
    std::vector<TransportScratch> scratches(parents.size());
    // Level by level: a parent may be the child of another one.
    std::vector<std::size_t> order(parents.size());
    for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
    const auto level = [&](std::size_t k) { return mesh->node(parents[k]).level; };
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return level(a) < level(b); });
    for (std::size_t first = 0; first < order.size();) {
        std::size_t last = first;
        while (last < order.size() && level(order[last]) == level(order[first])) ++last;
        arena_.execute([&] {
            tbb::parallel_for(first, last, [&](std::size_t k) {
                take_over(parents[order[k]], shot_counts[order[k]], scratches[order[k]]);
            });
        });
        first = last;
    }

    // What changes hands by that: the patch has more or less to shoot. Bookkeeping stays closed.
    for (std::size_t k = 0; k < parents.size(); ++k) {
        const NodeId parent = parents[k];
        Cell& cell = cells[static_cast<std::size_t>(parent)];
        const Material& m = material(parent);
        Rgb& unshot = unshot_flux[static_cast<std::size_t>(mesh->node(parent).patch)];
        for (std::size_t c = 0; c < 3; ++c) {
            double moved = -cell.area * cell.irradiance[c];
            for (NodeId child = 0; child < 4; ++child) {
                const Cell& part = cells[static_cast<std::size_t>(mesh->node(parent).first_child + child)];
                moved += part.area * part.irradiance[c];
            }
            unshot[c] += m.reflectance[c] * moved;
            flux_moved += std::fabs(moved);
        }
        count(scratches[k], counters);
        std::vector<std::uint8_t>().swap(cell.sights);
    }
}

void RadiositySolver::State::take_over(NodeId parent, std::size_t shot_count, TransportScratch& scratch) {
    const Node& node = mesh->node(parent);
    const std::vector<std::uint8_t>& sights = cells[static_cast<std::size_t>(parent)].sights;
    for (std::size_t number = 0; number < shot_count; ++number) {
        const Shot& shot = shots[number];
        const Sight before = sight_of(sights, number);
        if (before == Sight::away && transport->apart(shot, node.element.root)) continue;
        bool found = false;
        for (NodeId k = 0; k < 4; ++k) {
            const NodeId child = node.first_child + k;
            Cell& cell = cells[static_cast<std::size_t>(child)];
            Reception reception;
            if (before == Sight::none || cell.cover.kind == Cover::Kind::wholly) {
                reception.sight = Sight::none;
            } else if (before == Sight::whole) {
                reception = transport->receive_unobstructed(shot, child, scratch);
            } else {
                // Partly occluded, or the parent's centroid faced away: sampled anew.
                if (before == Sight::away && transport->unobstructed(shot, child, scratch) == 0) continue;
                if (!found) transport->find_between(shot, node.patch, scratch);
                found = true;
                reception = transport->receive(shot, child, scratch);
                ++scratch.resampled;
            }
            set_sight(cell.sights, number, reception.sight);
            for (std::size_t c = 0; c < channels_; ++c) cell.irradiance[c] += shot.exitance[c] * reception.form_factor;
            spread(cell.irradiance);
        }
    }
}

}  // namespace cob
