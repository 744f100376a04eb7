#include "report/picture.hpp"

#include "arithmetic/shared_progress.hpp"
#include "arithmetic/threads.hpp"
#include "radiosity/mesh.hpp"
#include "report/ray_caster.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cob::report {

using radiosity::Mesh;
using radiosity::Node;
using radiosity::NodeId;

namespace {

constexpr Rgb background{0.012, 0.013, 0.016};
/// The brightest tenth of what does not emit is drawn at this and above.
constexpr double bright_share = 0.9, bright_light = 0.7;

/// What a picture's point shows.
struct Seen {
    NodeId leaf = -1;
    Rgb exitance{};
    bool emits = false;
    double line = 0;    ///< How much of a mesh line covers it, 0 to 1.
    double cosine = 0;  ///< To the visible side's normal.
};

/// Linear up to 0.8, then a shoulder: bright paper beside a lamp keeps its texture.
double tone(double x) {
    constexpr double knee = 0.8;
    return x <= knee ? x : knee + (1 - knee) * (1 - std::exp((knee - x) / (1 - knee)));
}

Rgb srgb_to_linear(const Colour& colour) {
    Rgb result;
    for (std::size_t c = 0; c < 3; ++c) {
        const double s = colour[c] / 255.0;
        result[c] = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    }
    return result;
}

/// The state that decided about an element: its own buffer's, or, where that was not needed, of the nearest element
/// around it that has one: the smallest elements at a shadow are children of a close one.
BufferState shown_state(const RadiositySolver& solver, NodeId leaf) {
    if (solver.hidden(leaf)) return BufferState::occluded;
    for (NodeId node = leaf; node >= 0; node = solver.mesh().node(node).parent)
        if (solver.buffer_state(node) != BufferState::uninitialised) return solver.buffer_state(node);
    return BufferState::uninitialised;
}

class Painter {
public:
    Painter(const RadiositySolver& solver, const Camera& camera, const PictureOptions& options)
        : solver_(solver),
          scene_(solver.mesh().scene()),
          field_(solver),
          view_(in_units(camera, solver.mesh().exponent()), options.width, options.height),
          caster_(scene_, solver.mesh().exponent(),
                  [&](PolygonId top, PolygonId under) { return solver.lies_on(top, under); }),
          ambient_(options.ambient ? solver.ambient() : Rgb{}),
          roots_of_piece_(scene_.pieces().size()) {
        for (RootId root = 0; root < solver.roots().size(); ++root)
            roots_of_piece_[static_cast<std::size_t>(solver.roots()[root].piece)].push_back(root);
    }

    Seen look(double x, double y) const {
        Seen seen;
        const Point direction = view_.direction(x, y);
        const Hit hit = caster_.first(view_.origin(), direction);
        if (hit.piece < 0) return seen;
        const Mesh& mesh = solver_.mesh();
        const Point point = view_.origin() + hit.distance * direction, in_scene = mesh.in_scene(point);

        // The root, then the leaf.
        const std::vector<RootId>& candidates = roots_of_piece_[static_cast<std::size_t>(hit.piece)];
        RootId root = candidates.front();
        std::array<double, 2> at{};
        double best = -std::numeric_limits<double>::infinity();
        for (const RootId candidate : candidates) {
            const std::array<double, 2> p = root_coordinates(scene_, solver_.roots()[candidate], in_scene);
            const double inside = std::min({p[0], p[1], 1 - p[0] - p[1]});
            if (candidates.size() > 1 && inside <= best) continue;
            best = inside;
            root = candidate;
            at = p;
        }
        const Material& material = scene_.material(scene_.piece(hit.piece).polygon);
        seen.leaf = mesh.leaf_at(root, at[0], at[1]);
        seen.exitance = field_.at(root, at[0], at[1]);
        seen.emits = material.emits();
        for (std::size_t c = 0; c < 3; ++c) seen.exitance[c] += material.reflectance[c] * ambient_[c];
        seen.cosine = hit.cosine;
        seen.line = line(seen.leaf, point, view_.pixel() * hit.distance);
        return seen;
    }

private:
    /// Share of a mesh line at a point: lines are a pixel and a half wide, thinner where elements are small.
    double line(NodeId leaf, const Point& point, double pixel) const {
        const Mesh& mesh = solver_.mesh();
        const Node& node = mesh.node(leaf);
        double nearest = std::numeric_limits<double>::infinity();
        for (int k = 0; k < node.corner_count(); ++k) {
            const auto corner = [&](int n) {
                const auto v = node.corners[static_cast<std::size_t>(n % node.corner_count())];
                return mesh.vertices()[static_cast<std::size_t>(v)].position;
            };
            const Point a = corner(k), side = corner(k + 1) - a, d = cross(point - a, side);
            nearest = std::min(nearest, std::hypot(d.x, d.y, d.z) / std::hypot(side.x, side.y, side.z));
        }
        return std::clamp(1.25 - nearest / pixel, 0.0, 1.0);
    }

    const RadiositySolver& solver_;
    const Scene& scene_;
    ExitanceField field_;
    Frame view_;
    RayCaster caster_;
    Rgb ambient_;
    std::vector<std::vector<RootId>> roots_of_piece_;
};

double automatic_exposure(const Painter& painter, const PictureOptions& options, SharedProgress& progress) {
    std::vector<double> lights;
    constexpr int step = 6;
    for (int y = step / 2; y < options.height; y += step) {
        progress.pulse();
        for (int x = step / 2; x < options.width; x += step) {
            const Seen seen = painter.look(x, y);
            if (seen.leaf < 0 || seen.emits) continue;
            const double light = 0.2126 * seen.exitance[0] + 0.7152 * seen.exitance[1] + 0.0722 * seen.exitance[2];
            if (light > 0) lights.push_back(light);
        }
    }
    if (lights.empty()) return 1;
    const auto place = static_cast<std::ptrdiff_t>(bright_share * static_cast<double>(lights.size() - 1));
    std::nth_element(lights.begin(), lights.begin() + place, lights.end());
    return std::min(bright_light / lights[static_cast<std::size_t>(place)], 1e300);
}

}  // namespace

Pictures render_pictures(const RadiositySolver& solver, const Camera& camera, const PictureOptions& options) {
    const Painter painter(solver, camera, options);
    SharedProgress progress(options.progress, static_cast<std::uint64_t>(options.height));
    Pictures pictures;
    pictures.exposure = options.exposure > 0 ? options.exposure : automatic_exposure(painter, options, progress);
    pictures.plain = pictures.mesh = pictures.states = Image(options.width, options.height);
    const int n = std::max(1, options.antialiasing);

    in_parallel(options.threads, static_cast<std::size_t>(options.height), [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < options.width; ++x) {
            if (x % 64 == 0) progress.pulse();  // a row of many rays a pixel takes seconds
            Rgb plain{}, mesh{}, states{};
            for (int k = 0; k < n * n; ++k) {
                const Seen seen = painter.look(x + (k % n + 0.5) / n, y + (k / n + 0.5) / n);
                Rgb light = background, lined = background, state = background;
                if (seen.leaf >= 0) {
                    double luminance = 0;
                    for (std::size_t c = 0; c < 3; ++c) {
                        light[c] = tone(pictures.exposure * seen.exitance[c]);
                        luminance += light[c] / 3;
                    }
                    const Rgb colour = srgb_to_linear(colour_of(shown_state(solver, seen.leaf)));
                    for (std::size_t c = 0; c < 3; ++c) {
                        // Dark lines over what is bright, bright ones over what is dark.
                        const double ink = luminance > 0.06 ? 0.0 : 0.25;
                        lined[c] = light[c] + 0.75 * seen.line * (ink - light[c]);
                        const double shade = (0.35 + 0.4 * seen.cosine + 0.25 * luminance) * colour[c];
                        state[c] = shade * (1 - 0.55 * seen.line);
                    }
                }
                for (std::size_t c = 0; c < 3; ++c) {
                    plain[c] += light[c] / (n * n);
                    mesh[c] += lined[c] / (n * n);
                    states[c] += state[c] / (n * n);
                }
            }
            for (std::size_t c = 0; c < 3; ++c) {
                pictures.plain.at(x, y)[c] = to_srgb(plain[c]);
                pictures.mesh.at(x, y)[c] = to_srgb(mesh[c]);
                pictures.states.at(x, y)[c] = to_srgb(states[c]);
            }
        }
        progress.step();
    });
    return pictures;
}

}  // namespace cob::report
