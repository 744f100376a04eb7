#include "report/camera.hpp"

#include "cob/error.hpp"
#include "cob/files.hpp"
#include "geometry/bounds.hpp"
#include "radiosity/mesh.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace cob::report {
namespace {

double length(const Point& p) {
    return std::hypot(p.x, p.y, p.z);
}

Point unit(const Point& p) {
    return (1 / length(p)) * p;
}

std::string text_of(const Point& p) {
    return to_text(p.x) + " " + to_text(p.y) + " " + to_text(p.z);
}

/// Throws where the camera has no direction, or no up.
void check(const Camera& camera, const std::string& path) {
    const Point ahead = camera.target - camera.position;
    if (!(length(ahead) > 0) || !std::isfinite(length(ahead)))
        throw InputError("the camera's position and target are one point, or too far apart",
                         {path, 0, text_of(camera.target), "move one"});
    if (!(length(cross(unit(ahead), camera.up)) > 1e-9 * length(camera.up)))
        throw InputError("the camera looks along its own up direction",
                         {path, 0, text_of(camera.up), "choose another"});
}

}  // namespace

Frame::Frame(const Camera& camera, int width, int height) : origin_(camera.position) {
    check(camera, "");
    forward_ = unit(camera.target - camera.position);
    right_ = unit(cross(forward_, camera.up));
    down_ = cross(forward_, right_);
    half_height_ = std::tan(camera.fov * 3.14159265358979323846 / 360);
    half_width_ = half_height_ * width / height;
    pixel_ = 2 * half_height_ / height;
}

Point Frame::direction(double x, double y) const {
    return unit(forward_ + ((x * pixel_ - half_width_) * right_ + (y * pixel_ - half_height_) * down_));
}

Camera read_view(const std::string& path) {
    Camera camera;
    std::istringstream lines(read_file(path));
    std::size_t number = 0;
    bool has_position = false, has_target = false;
    for (std::string line; std::getline(lines, line);) {
        ++number;
        std::istringstream words(line.substr(0, line.find('#')));
        std::string key, extra;
        if (!(words >> key)) continue;
        const auto next = [&] {
            std::string word;
            words >> word;
            const std::optional<double> value = parse_binary64(word);
            if (!value) throw InputError("not a number in a view", {path, number, word, "write it in decimal"});
            return *value;
        };
        if (key == "position" || key == "target" || key == "up") {
            Point& point = key == "position" ? camera.position : key == "target" ? camera.target : camera.up;
            for (int axis = 0; axis < 3; ++axis) point[axis] = next();
            has_position = has_position || key == "position";
            has_target = has_target || key == "target";
        } else if (key == "fov") {
            camera.fov = next();
            if (!(camera.fov > 0 && camera.fov < 180))
                throw InputError("field of view out of range", {path, number, to_text(camera.fov), "choose 1 to 179"});
        } else {
            throw InputError("unknown statement in a view", {path, number, key, "use position, target, up or fov"});
        }
        if (words >> extra) throw InputError("too much on a line of a view", {path, number, extra, "remove it"});
    }
    if (!has_position || !has_target)
        throw InputError("a view needs a position and a target", {path, 0, "", "add the missing line"});
    check(camera, path);
    return camera;
}

std::optional<std::string> view_beside(const std::string& scene_path) {
    std::filesystem::path path(scene_path);
    path.replace_extension(".view");
    if (!exists(path)) return std::nullopt;
    return path.string();
}

Camera in_units(const Camera& camera, int exponent) {
    Camera result = camera;
    result.position = radiosity::in_units(camera.position, exponent - camera.exponent);
    result.target = radiosity::in_units(camera.target, exponent - camera.exponent);
    result.exponent = exponent;
    return result;
}

Camera default_camera(const Scene& scene) {
    if (scene.pieces().empty())
        throw InputError("the scene has no valid polygon", {scene.name(), 0, "", "give one that has something to see"});
    const Bounds bounds = bounds_of(scene);
    Camera camera;
    camera.exponent = radiosity::unit_exponent(scene);
    const auto in_units = [&](const std::array<double, 3>& p) {
        return radiosity::in_units({p[0], p[1], p[2]}, camera.exponent);
    };
    const Point low = in_units(bounds.low), high = in_units(bounds.high);
    const Point middle = 0.5 * (low + high), extent = high - low;
    camera.target = middle;
    camera.fov = 45;
    // Far enough for the bounding sphere; the backs of the near walls are not drawn.
    const double radius = length(extent) / 2;
    camera.position =
        middle + (1.05 * radius / std::sin(camera.fov * 3.14159265358979323846 / 360)) * unit({-0.45, -1, 0.55});
    return camera;
}

}  // namespace cob::report
