/// \file
/// What `cob bench` shows: a table, CSV, and error rate against time.
#pragma once

#include "cob/bench.hpp"
#include "report/gnuplot.hpp"

namespace cob::report {

/// For people: the sums over all kinds, then every kind.
std::string bench_table(const std::vector<BenchRow>& rows, const BenchMachine& machine);
/// bench.csv: `question,variant,kind,questions,wrong,undecided,ns_min,ns_median,bytes`, after comments on the machine.
std::string bench_csv(const std::vector<BenchRow>& rows, const BenchMachine& machine);
/// Share of wrong or undecided answers over the median time, one curve a variant, one point a kind of question.
Plot bench_plot(const std::vector<BenchRow>& rows, const BenchMachine& machine, const std::string& question);

}  // namespace cob::report
