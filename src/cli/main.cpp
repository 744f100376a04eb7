/// \file
/// The program `cob`: thin commands over the library.
#include "cli/commands.hpp"
#include "cli/terminal.hpp"

#include "cob/error.hpp"

#include <fcntl.h>
#include <gmp.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <string>
#include <system_error>
#include <vector>

namespace {

constexpr const char* out_of_memory = "cob: out of memory: use a smaller scene, fewer elements or fewer threads\n";

/// What is no option stands for a command.
void refuse_unknown_command(const CLI::App& app, const std::string& word) {
    std::string names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        if (command->get_name() == word) return;
        names += (names.empty() ? "" : ", ") + command->get_name();
    }
    if (word.front() != '-') throw cob::InputError("unknown command", {"", 0, word, "choose one of " + names});
}

/// What CLI11 refuses, in the form of all bad input: one line with a remedy.
std::string refusal(const CLI::App& app, std::string problem) {
    constexpr std::size_t longest = 300;
    if (problem.size() > longest) problem = problem.substr(0, longest) + "...";
    std::string command = "cob";
    for (const CLI::App* chosen : app.get_subcommands()) command += " " + chosen->get_name();
    return cob::InputError(problem, {"", 0, "", "see " + command + " --help"}).what();
}

/// The arguments, last first, as CLI11 takes them; "-.5" is a number and no option.
std::vector<std::string> words_of(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    for (std::string& word : words)
        if (word.size() > 2 && word[0] == '-' && word[1] == '.' && word[2] >= '0' && word[2] <= '9')
            word.insert(1, "0");
    std::reverse(words.begin(), words.end());
    return words;
}

[[noreturn]] void end_without_memory() {
    std::fputs(out_of_memory, stderr);
    std::_Exit(2);
}

/// GMP would abort. It is C: no exception may pass through it.
void end_where_gmp_has_no_memory() {
    ::mp_set_memory_functions(
        [](std::size_t size) {
            void* block = std::malloc(size);
            if (block == nullptr) end_without_memory();
            return block;
        },
        [](void* old, std::size_t, std::size_t size) {
            void* block = std::realloc(old, size);
            if (block == nullptr) end_without_memory();
            return block;
        },
        nullptr);
}

}  // namespace

int main(int argc, char** argv) {
    std::signal(SIGXFSZ, SIG_IGN);  // files that may not grow are full disks: what is begun is removed
    end_where_gmp_has_no_memory();
    CLI::App app{"cob: the exact reference for the Close Object Buffer", "cob"};
    app.require_subcommand(1);
    app.option_defaults()->always_capture_default();
    cob::cli::add_answer(app);
    cob::cli::add_bench(app);
    cob::cli::add_classify(app);
    cob::cli::add_explain(app);
    cob::cli::add_formfactors(app);
    cob::cli::add_golden(app);
    cob::cli::add_info(app);
    cob::cli::add_irradiance(app);
    cob::cli::add_occlude(app);
    cob::cli::add_render(app);
    cob::cli::add_stress(app);
    cob::cli::add_study(app);
    cob::cli::add_verify(app);
    try {
        if (argc > 1 && *argv[1] != '\0') refuse_unknown_command(app, argv[1]);
        app.parse(words_of(argc, argv));
        const bool unwritten = std::fflush(stdout) != 0 || std::ferror(stdout) != 0;
        if (unwritten && ::fcntl(STDOUT_FILENO, F_GETFD) >= 0)  // closed on purpose: nobody wants it
            throw cob::InputError("cannot write standard output",
                                  {"", 0, std::strerror(errno), "send it where there is room"});
        return 0;
    } catch (const CLI::ParseError& error) {
        const bool is_refused = error.get_exit_code() != 0 && error.get_name() != "RuntimeError";
        if (!is_refused) return app.exit(error);
        std::fprintf(stderr, "cob: %s\n", refusal(app, error.what()).c_str());
        return 2;
    } catch (const cob::InputError& error) {
        std::fprintf(stderr, "cob: %s\n", error.what());
        return 2;
    } catch (const cob::cli::Interrupted&) {
        std::fprintf(stderr, "cob: interrupted\n");
        return 130;
    } catch (const std::bad_alloc&) {
        std::fputs(out_of_memory, stderr);
        return 2;
    } catch (const std::exception& error) {
        const auto* system = dynamic_cast<const std::system_error*>(&error);
        if (system && system->code() == std::errc::resource_unavailable_try_again) {
            std::fprintf(stderr, "cob: cannot start a thread: use fewer threads, or give more memory\n");
            return 2;
        }
        std::fprintf(stderr, "cob: internal error: %s\n", error.what());
        return 70;
    }
}
