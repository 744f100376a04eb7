/// \file
/// Options that several commands share: each registers itself, shows its default and is checked when it is used.
#pragma once

#include "cob/buffer.hpp"
#include "cob/candidates.hpp"
#include "cob/classify.hpp"
#include "cob/files.hpp"
#include "cob/omissions.hpp"

#include <CLI/CLI.hpp>

#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace cob::cli {

/// Reads the value of an option as an exact number (decimal, C hex-float or fraction p/q) that is at least 0, or
/// above it. Throws InputError.
Rational exact_option(const char* option, const std::string& text, bool positive);

/// SCENE and how to read it.
struct SceneOptions {
    std::string path;
    bool skip_invalid = false;
    std::string emission = "exitance";

    /// Returns SCENE, which is required.
    CLI::Option* add_to(CLI::App& command);
    void add_skip_invalid_to(CLI::App& command);
    /// --emission, where photometry is asked for.
    void add_emission_to(CLI::App& command);
    /// Reads the scene; warnings and skipped polygons go to standard error.
    Scene read() const;
};

/// --margin, --height: the elements' boxes.
struct BoxOptions {
    std::string margin = "0.125", height = "0.25";

    void add_to(CLI::App& command);
    /// Sets the options of that name.
    template <class Options>
    void set(Options& options) const {
        options.margin = exact_option("--margin", margin, false);
        options.height = exact_option("--height", height, true);
    }
};

/// --level, --edge and the boxes': the elements.
struct MeshingOptions {
    int level = 0;
    std::string edge = "0";
    BoxOptions box;

    void add_to(CLI::App& command);
    Meshing meshing() const;
};

/// An option that takes one of several values by its name, to_text(value).
template <class Value>
class Choice {
public:
    Choice(Value standard, std::initializer_list<Value> values) : name_(to_text(standard)) {
        for (const Value value : values) values_.emplace(to_text(value), value);
    }
    void add_to(CLI::App& command, const char* option, const std::string& description) {
        command.add_option(option, name_, description)->check(CLI::IsMember(values_));
    }
    Value operator()() const { return values_.at(name_); }
    const std::string& name() const { return name_; }

private:
    std::string name_;
    std::map<std::string, Value> values_;
};

/// --source
struct SourceOption : Choice<Source> {
    SourceOption() : Choice(Source::tree, {Source::all, Source::tree, Source::embree, Source::octree}) {}
    void add_to(CLI::App& command);
};

/// --keep and --keep-all: what is done although the scene does not need it.
struct KeepOptions {
    std::string names;
    bool all = false;

    void add_to(CLI::App& command);
    OmissionSet set() const;
};

/// Where one table goes: the path itself where it ends in .csv, else the table of that name in the folder. The folder
/// is created and, should no table come, removed.
class TablePath {
public:
    TablePath(const std::string& out, const std::string& name);
    const std::string& operator()() const { return path_; }

private:
    std::string path_;
    std::optional<OutputFolder> folder_;
};

/// Refuses an output file that is one of the files that the command reads.
void refuse_overwriting(const std::string& output, const std::vector<std::string>& inputs);

/// --threads
void add_threads(CLI::App& command, int& threads);
/// -o DIR
void add_output_folder(CLI::App& command, std::string& folder);

}  // namespace cob::cli
