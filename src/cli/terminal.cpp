#include "cli/terminal.hpp"

#include "arithmetic/text.hpp"

#include <signal.h>
#include <unistd.h>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <memory>

namespace cob::cli {
namespace {

volatile std::sig_atomic_t interrupt_flag = 0;  // a signal handler can reach nothing else

extern "C" void on_interrupt(int) {
    interrupt_flag = 1;
}

/// One line on a terminal, cleared when the work ends in any way.
class ProgressLine {
public:
    explicit ProgressLine(std::string title) : title_(std::move(title)), terminal_(::isatty(STDERR_FILENO) != 0) {}
    ~ProgressLine() {
        if (shown_) std::fprintf(stderr, "\r\033[K");
    }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(std::uint64_t done, std::uint64_t total) {
        if (!terminal_) return;
        const auto now = std::chrono::steady_clock::now();
        if (now - last_ < std::chrono::milliseconds(200)) return;
        last_ = now;
        shown_ = true;
        if (total > 0)
            std::fprintf(stderr, "\r\033[K%s %.0f %%", title_.c_str(),
                         100 * static_cast<double>(done) / static_cast<double>(total));
        else
            std::fprintf(stderr, "\r\033[K%s %llu", title_.c_str(), static_cast<unsigned long long>(done));
        std::fflush(stderr);
    }

private:
    std::string title_;
    bool terminal_;
    bool shown_ = false;
    std::chrono::steady_clock::time_point last_{};
};

}  // namespace

void catch_interrupts() {
    struct sigaction action {};
    action.sa_handler = on_interrupt;
    action.sa_flags = static_cast<int>(SA_RESETHAND);  // the second one ends the process
    sigemptyset(&action.sa_mask);
    ::sigaction(SIGINT, &action, nullptr);
    ::sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() {
    return interrupt_flag != 0;
}

void catch_next_interrupt() {
    interrupt_flag = 0;
    catch_interrupts();
}

void remark_on_terminal(const std::string& line) {
    std::fprintf(stderr, "cob: %s\n", one_line(line).c_str());
}

Progress terminal_progress(std::string title) {
    catch_interrupts();
    return [line = std::make_shared<ProgressLine>(std::move(title))](std::uint64_t done, std::uint64_t total) {
        if (interrupted()) throw Interrupted();
        line->show(done, total);
    };
}

}  // namespace cob::cli
