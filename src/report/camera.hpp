/// \file
/// The camera of the pictures and the `.view` files beside scenes.
#pragma once

#include "cob/scene.hpp"

#include <optional>
#include <string>

namespace cob::report {

/// A pinhole camera.
struct Camera {
    Point position, target;
    Point up{0, 0, 1};
    double fov = 50;   ///< Vertical, degrees, in (0, 180).
    int exponent = 0;  ///< Position and target are in units of 2^exponent.
};

/// Where each picture point looks.
class Frame {
public:
    /// Throws InputError where position and target are one, or up runs along the line between them.
    Frame(const Camera& camera, int width, int height);
    const Point& origin() const { return origin_; }
    /// Unit direction through the picture at (x, y) pixels from the top left.
    Point direction(double x, double y) const;
    /// Width of a pixel at unit distance.
    double pixel() const { return pixel_; }

private:
    Point origin_, forward_, right_, down_;
    double half_width_, half_height_, pixel_;
};

/// Lines `position x y z`, `target x y z`, `up x y z`, `fov degrees`; `#` begins a comment. Throws InputError.
Camera read_view(const std::string& path);
/// The file beside an OBJ that has its base name, if there is one.
std::optional<std::string> view_beside(const std::string& scene_path);
/// The same view of the scene in units of 2^exponent (mesh.hpp).
Camera in_units(const Camera& camera, int exponent);
/// From a corner over the scene's middle, everything in sight.
Camera default_camera(const Scene& scene);

}  // namespace cob::report
