/// cob render: progressive refinement radiosity and its pictures (SPEC 8).
#include "cli/commands.hpp"
#include "cli/number_checks.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "cob/error.hpp"
#include "cob/files.hpp"
#include "cob/solver.hpp"
#include "radiosity/mesh.hpp"
#include "report/exitance_line.hpp"
#include "report/picture.hpp"
#include "report/solution_files.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace cob::cli {

namespace {

struct Arguments {
    SceneOptions scene;
    std::string folder, checkpoint, view, beside;
    Choice<Refinement> refinement{Refinement::both,
                                  {Refinement::none, Refinement::gradient, Refinement::buffer, Refinement::both}};
    Choice<Strength> strength{Strength::exitance, {Strength::exitance, Strength::flux, Strength::paper}};
    Choice<BufferLevels> levels{BufferLevels::tree, {BufferLevels::element, BufferLevels::polygon, BufferLevels::tree}};
    Choice<BufferMode> mode{BufferMode::strict, {BufferMode::strict, BufferMode::inherit}};
    BoxOptions box;
    KeepOptions keep;
    std::vector<double> gradient_threshold{0.25};
    std::vector<double> position, target, up, line;
    int line_points = 200, line_samples = 64;
    double fov = 0;
    std::int64_t elements = 0;
    double checkpoint_seconds = 30;
    RadiosityOptions options;
    report::PictureOptions picture;
};

RadiosityOptions solver_options(const Arguments& arguments) {
    RadiosityOptions options = arguments.options;
    options.refinement = arguments.refinement();
    options.buffer.strength = arguments.strength();
    options.buffer.levels = arguments.levels();
    options.buffer.mode = arguments.mode();
    arguments.box.set(options.buffer);
    options.keep = arguments.keep.set();
    if (arguments.elements > 0) options.stop.elements = arguments.elements;
    const std::vector<double>& threshold = arguments.gradient_threshold;
    if (threshold.size() != 1 && threshold.size() != 3)
        throw InputError("--gradient-threshold takes one number, or one for each channel",
                         {"", 0, std::to_string(threshold.size()) + " numbers", "give 1 or 3"});
    for (std::size_t c = 0; c < 3; ++c) options.gradient.threshold[c] = threshold[threshold.size() == 1 ? 0 : c];
    return options;
}

Point point_of(const std::vector<double>& numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

report::Camera camera_of(const Arguments& arguments, const Scene& scene) {
    const std::optional<std::string> beside = report::view_beside(arguments.scene.path);
    report::Camera camera = !arguments.view.empty() ? report::read_view(arguments.view)
                            : beside                ? report::read_view(*beside)
                                                    : report::default_camera(scene);
    const auto in_units = [&](const Point& p) { return radiosity::in_units(p, camera.exponent); };
    if (!arguments.position.empty()) camera.position = in_units(point_of(arguments.position));
    if (!arguments.target.empty()) camera.target = in_units(point_of(arguments.target));
    if (!arguments.up.empty()) camera.up = point_of(arguments.up);
    if (arguments.fov > 0) camera.fov = arguments.fov;
    return camera;
}

/// What ended the run, as far as the stops tell.
std::string ended_by(const RadiositySolver& solver) {
    const RadiosityOptions::Stop& stop = solver.options().stop;
    if (solver.counters().shots >= stop.shots) return "number of shots";
    if (static_cast<std::int64_t>(solver.element_count()) >= stop.elements) return "number of elements";
    return "unshot flux";
}

/// The line that is asked for, if one is.
std::optional<report::ExitanceLine> line_of(const RadiositySolver& solver, const Arguments& arguments) {
    const std::vector<double>& l = arguments.line;
    if (l.empty()) return std::nullopt;
    return report::ExitanceLine(solver, {{l[0], l[1], l[2]},
                                         {l[3], l[4], l[5]},
                                         arguments.line_points,
                                         arguments.line_samples,
                                         arguments.options.threads});
}

void resume(RadiositySolver& solver, const std::string& path) {
    const std::string text = read_file(path);
    try {
        solver.resume(text);
    } catch (const InputError& error) {
        throw InputError(path + ": " + error.what());
    }
}

double seconds_since(std::chrono::steady_clock::time_point t) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count();
}

/// Draws the pictures, then writes them and what shows their exposure: all of these files or, interrupted, none.
void write_pictures(const RadiositySolver& solver, const Arguments& arguments, const report::Camera& camera,
                    const std::optional<report::Image>& beside, report::RunFigures& figures) {
    const auto begin = std::chrono::steady_clock::now();
    report::PictureOptions options = arguments.picture;
    options.threads = arguments.options.threads;
    options.progress = terminal_progress("drawing");
    const report::Pictures pictures = report::render_pictures(solver, camera, options);
    figures.picture_seconds = seconds_since(begin);

    std::vector<std::pair<std::string, std::string>> files;
    const auto encode = [&](const char* name, const report::Image& image) {
        options.progress(1, 1);
        files.emplace_back(name, report::encode_png(image));
    };
    encode("picture.png", pictures.plain);
    encode("mesh.png", pictures.mesh);
    encode("states.png", pictures.states);
    if (beside) encode("beside.png", report::beside(*beside, pictures.plain));
    files.emplace_back("mesh.ply", report::solution_ply(solver, pictures.exposure));

    for (const auto& [name, bytes] : files) write_file(arguments.folder + "/" + name, bytes);
    figures.exposure = pictures.exposure;
}

void write_all(const RadiositySolver& solver, const Arguments& arguments, const report::Camera& camera,
               const std::optional<report::ExitanceLine>& line, const std::optional<report::Image>& beside,
               report::RunFigures& figures, std::chrono::steady_clock::time_point begin) {
    const std::string base = arguments.folder + "/";
    write_file(base + "mesh.vtp", report::solution_vtp(solver));
    write_file(base + "exitance.csv", report::solution_csv(solver));

    // Ctrl-C ends the drawing; what there is of the solution stays, and the summary tells.
    try {
        write_pictures(solver, arguments, camera, beside, figures);
        if (line && !line->write(base + "line", terminal_progress("line")))
            remark_on_terminal("no plot " + base + "line: gnuplot is missing or failed; install gnuplot-nox");
    } catch (const Interrupted&) {
        figures.interrupted = true;
    }
    figures.seconds = seconds_since(begin);
    const report::RunSummary summary = report::summarise(solver, figures);
    write_file(base + "summary.json", summary.json);
    write_file(base + "summary.txt", summary.text);
    std::fputs(summary.text.c_str(), stdout);
}

void run(const Arguments& arguments) {
    const auto begin = std::chrono::steady_clock::now();
    const Scene scene = arguments.scene.read();
    const report::Camera camera = camera_of(arguments, scene);
    report::Frame(report::in_units(camera, radiosity::unit_exponent(scene)), arguments.picture.width,
                  arguments.picture.height);  // refuses before the work, not after
    // Read now: it may be the picture that this run replaces.
    std::optional<report::Image> beside;
    if (!arguments.beside.empty()) beside = report::decode_png(arguments.beside);
    const OutputFolder created(arguments.folder);

    RadiositySolver solver(scene, solver_options(arguments));
    const std::optional<report::ExitanceLine> line = line_of(solver, arguments);
    if (!arguments.checkpoint.empty() && exists(arguments.checkpoint)) resume(solver, arguments.checkpoint);

    // The run: one shot after the other. Ctrl-C ends it after the current one, and what there is is drawn and written;
    // one more ends the drawing.
    const Progress progress = terminal_progress("unshot flux shot");
    report::RunFigures figures;
    figures.scene = arguments.scene.path;
    auto saved = std::chrono::steady_clock::now();
    const double from = std::log(1 / solver.options().stop.unshot);
    try {
        while (solver.step()) {
            // Progress by the logarithm of what remains: it falls about as fast all the time.
            const double done =
                std::isfinite(from) && from > 0 ? std::log(1 / std::max(solver.unshot_share(), 1e-300)) / from : 0;
            const double shots =
                static_cast<double>(solver.counters().shots) / static_cast<double>(solver.options().stop.shots);
            progress(static_cast<std::uint64_t>(1e4 * std::min(1.0, std::max({done, shots, 0.0}))), 10000);
            const auto now = std::chrono::steady_clock::now();
            if (!arguments.checkpoint.empty() &&
                std::chrono::duration<double>(now - saved).count() > arguments.checkpoint_seconds) {
                write_file(arguments.checkpoint, solver.checkpoint());
                saved = now;
            }
        }
        figures.ended_by = ended_by(solver);
    } catch (const Interrupted&) {
        figures.interrupted = true;
        figures.ended_by = "interrupt";
        catch_next_interrupt();
    }
    if (!arguments.checkpoint.empty()) write_file(arguments.checkpoint, solver.checkpoint());
    write_all(solver, arguments, camera, line, beside, figures, begin);
    if (figures.interrupted) throw Interrupted();
}

}  // namespace

void add_render(CLI::App& app) {
    auto arguments = std::make_shared<Arguments>();
    Arguments& a = *arguments;
    RadiosityOptions& o = a.options;
    CLI::App* command = app.add_subcommand("render", "Solve radiosity with the Close Object Buffer and draw it");
    a.scene.add_to(*command)->description("OBJ file of the scene; a .view file beside it is the default camera");
    a.scene.add_emission_to(*command);
    command
        ->add_option("-o,--output", a.folder,
                     "Folder for picture.png, mesh.png, states.png, mesh.ply, mesh.vtp, exitance.csv, summary.*")
        ->required();
    const auto number = [](CLI::Option* option) { option->check(not_negative()); };
    const auto defaults = command->option_defaults();

    defaults->group("Refinement");
    a.refinement.add_to(*command, "--refine", "Which refinement is on");
    number(command->add_option("--edge", o.patch_edge,
                               "Longest side of a patch; 0: a twelfth of the scene's longest extent"));
    number(command->add_option("--light-edge", o.light_edge, "Longest side of a light's patch; 0: as --edge"));
    number(command->add_option("--buffer-edge", o.buffer.minimum_edge,
                               "The buffer's minimum edge; 0: a sixteenth of --edge"));
    a.strength.add_to(*command, "--strength", "Strength of an interaction (SPEC 8, choice 7)");
    number(command->add_option("--strength-threshold", o.buffer.threshold, "Weaker interactions do not refine"));
    a.box.add_to(*command);
    a.levels.add_to(*command, "--buffer", "What an element's buffer is built from");
    a.mode.add_to(*command, "--mode", "What an occluded buffer means inside (SPEC 5, choice 5)");
    number(command
               ->add_option("--gradient-threshold", a.gradient_threshold,
                            "Difference of exitance over its mean; 1 or 3 numbers")
               ->delimiter(',')
               ->expected(1, 3));
    number(command->add_option("--gradient-edge", o.gradient.minimum_edge,
                               "The gradient's minimum edge; 0: an eighth of --edge"));

    defaults->group("Stop");
    command->add_option("--shots", o.stop.shots, "Stop after so many shots")->check(positive_whole_number());
    command->add_option("--elements", a.elements, "Stop at so many elements; 0: never")->check(whole_number());
    command->add_option("--unshot", o.stop.unshot, "Stop when this share of the emitted flux is unshot")
        ->check(CLI::Range(0.0, 1.0))
        ->check(finite());
    command->add_option("--checkpoint", a.checkpoint, "File to resume from, if it exists, and to save to");
    number(command->add_option("--checkpoint-seconds", a.checkpoint_seconds, "Save so often"));

    defaults->group("Transport");
    command->add_option("--samples", o.samples, "Points of a shooter seen from each receiver")
        ->check(CLI::IsMember({1, 4, 16, 64}));
    command->add_option("--mixed-samples", o.mixed_samples, "Instead, where some of them are blocked")
        ->check(CLI::IsMember({1, 4, 16, 64}));
    command->add_option("--receiving-points", o.receiving_points, "Points of an element that receive")
        ->check(CLI::IsMember({1, 4, 16}));
    command->add_flag("--overshoot", o.overshoot, "Shoot what is going to arrive, too: fewer shots");
    a.keep.add_to(*command);
    add_threads(*command, o.threads);

    defaults->group("Picture");
    command->add_option("--view", a.view, "File with position, target, up, fov");
    command->add_option("--position", a.position, "Camera's place, X Y Z")->expected(3)->check(finite());
    command->add_option("--target", a.target, "Where it looks, X Y Z")->expected(3)->check(finite());
    command->add_option("--up", a.up, "What is up, X Y Z")->expected(3)->check(finite());
    command->add_option("--fov", a.fov, "Vertical field of view, degrees; 0: of the view")
        ->check(CLI::Range(0.0, 179.0))
        ->check(finite());
    command->add_option("--width", a.picture.width, "Pixels")->check(CLI::Range(16, 8192));
    command->add_option("--picture-height", a.picture.height, "Pixels")->check(CLI::Range(16, 8192));
    command->add_option("--antialias", a.picture.antialiasing, "Rays a pixel along either side")
        ->check(CLI::Range(1, 16));
    number(command->add_option("--exposure", a.picture.exposure, "Linear light for 1 W/m2; 0: from the picture"));
    command
        ->add_option("--beside", a.beside, "Another picture: beside.png shows it to the left of this run's picture.png")
        ->check(CLI::ExistingFile);
    command
        ->add_option("--line", a.line,
                     "Exitance along a line on a surface, X0 Y0 Z0 X1 Y1 Z1, beside what the same shots bring to each "
                     "point itself: line.csv, line.svg, line.png")
        ->expected(6)
        ->check(finite());
    command->add_option("--line-points", a.line_points, "Points along --line")->check(CLI::Range(2, 100000));
    command->add_option("--line-samples", a.line_samples, "Segments from each point of --line to each shooter")
        ->check(CLI::IsMember({1, 4, 16, 64, 256, 1024}));
    command->add_flag("--ambient", a.picture.ambient, "Add the ambient term, for display only");
    command->callback([arguments] { run(*arguments); });
}

}  // namespace cob::cli
