/// \file
/// Pictures of a solution: Gouraud-interpolated exitance, ray cast against the scene itself; the same with the mesh
/// over it; and elements coloured by the state of their buffer.
#pragma once

#include "cob/progress.hpp"
#include "cob/solver.hpp"
#include "report/camera.hpp"
#include "report/image.hpp"

namespace cob::report {

struct PictureOptions {
    int width = 960, height = 720;
    int antialiasing = 3;  ///< Rays a pixel along either side.
    double exposure = 0;   ///< Linear light for 1 W/m2 of exitance; 0: so that the picture's bright parts are bright.
    bool ambient = false;  ///< Adds the ambient term, for display only.
    int threads = 0;       ///< 0: as many as the machine has.
    Progress progress;     ///< Counts rows.
};

struct Pictures {
    Image plain, mesh, states;
    double exposure = 0;  ///< As used.
};

Pictures render_pictures(const RadiositySolver& solver, const Camera& camera, const PictureOptions& options);

}  // namespace cob::report
