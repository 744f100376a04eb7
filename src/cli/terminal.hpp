/// \file
/// Progress on a terminal and Ctrl-C, for commands that take long.
#pragma once

#include "cob/progress.hpp"

#include <stdexcept>
#include <string>

namespace cob::cli {

/// Thrown through the work when the user has pressed Ctrl-C (or the process was asked to end): files that are not
/// finished disappear, and the program ends with exit code 130.
class Interrupted : public std::runtime_error {
public:
    Interrupted() : std::runtime_error("interrupted") {}
};

/// From now on Ctrl-C (SIGINT) and SIGTERM only set a flag; a second one ends the process at once.
void catch_interrupts();
/// Ctrl-C was pressed since catch_interrupts().
bool interrupted();
/// An interrupt was dealt with: interrupted() is false again, and the next one sets it rather than ending the process.
void catch_next_interrupt();

/// A line for the reader of standard error, behind the program's name.
void remark_on_terminal(const std::string& line);

/// Shows "title 42 %" (or the count, where the total is not known) on standard error where that is a terminal, a few
/// times a second, and throws Interrupted after Ctrl-C. Calls catch_interrupts().
Progress terminal_progress(std::string title);

}  // namespace cob::cli
