/// \file
/// The trees behind make_candidates(), each in a file of its own because its library compiles slowly.
#pragma once

#include "cob/candidates.hpp"

namespace cob {

std::unique_ptr<CandidateSource> make_tree_candidates(const Scene& scene);
std::unique_ptr<CandidateSource> make_octree_candidates(const Scene& scene);
/// Only where the library is built with Embree.
std::unique_ptr<CandidateSource> make_embree_candidates(const Scene& scene);

}  // namespace cob
