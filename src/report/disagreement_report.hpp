/// \file
/// Where Embree's triangles give another answer than the exact one: counted, and the worst as a picture.
#pragma once

#include "cob/bench.hpp"
#include "report/gnuplot.hpp"

namespace cob::report {

/// The first of each kind, by kind: of embree_disagreements(), the plainest.
std::vector<EmbreeDisagreement> worst_of_each_kind(const std::vector<EmbreeDisagreement>& disagreements);
/// By kind of question: blocked and not hit (near an end, elsewhere), clear and hit; then the worst in words.
std::string disagreement_table(const Scene& scene, const std::vector<EmbreeDisagreement>& disagreements);
/// The section through the segment and across the piece that it is about, near the contact: what polygons stand there,
/// and which part of the segment Embree is asked about. All in shares of the segment's length, from the contact.
Plot disagreement_plot(const Scene& scene, const EmbreeDisagreement& disagreement);

}  // namespace cob::report
