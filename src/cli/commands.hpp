/// \file
/// The commands of the program: each adds itself to the parser and runs when it is chosen.
#pragma once

#include <CLI/CLI.hpp>

namespace cob::cli {

// Each command registers its options and a callback; the callback throws InputError on bad input and CLI::RuntimeError
// with an exit code where the code is part of its meaning (verify).
void add_answer(CLI::App& app);
void add_bench(CLI::App& app);
void add_classify(CLI::App& app);
void add_explain(CLI::App& app);
void add_formfactors(CLI::App& app);
void add_golden(CLI::App& app);
void add_info(CLI::App& app);
void add_irradiance(CLI::App& app);
void add_occlude(CLI::App& app);
void add_render(CLI::App& app);
void add_stress(CLI::App& app);
void add_study(CLI::App& app);
void add_verify(CLI::App& app);

}  // namespace cob::cli
