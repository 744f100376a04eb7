/// \file
/// A solution as files: meshes for ParaView and Blender, tables, and the run's summary.
#pragma once

#include "cob/solver.hpp"

#include <string>
#include <utility>
#include <vector>

namespace cob::report {

/// Binary PLY. Vertices shared by elements of one polygon, each with its exitance (`exitance_r` ... W/m2) and a colour
/// (`red` ... sRGB at the exposure); one face for each element, T-vertices included, with `polygon`, `level`, `state`.
std::string solution_ply(const RadiositySolver& solver, double exposure);
/// VTK XML PolyData: the same with exitance as point and cell data.
std::string solution_vtp(const RadiositySolver& solver);
/// One row for each element: its address, centre, visible area, exitance and the state of its buffer.
std::string solution_csv(const RadiositySolver& solver);

/// What a run was and cost, as JSON and as text. `seconds`: whole run; the rest by phase.
struct RunFigures {
    std::string scene;
    double seconds = 0, picture_seconds = 0;
    double exposure = 0;
    bool interrupted = false;
    std::string ended_by;  ///< "shots", "elements", "unshot flux" or "interrupt".
};
std::string summary_json(const RadiositySolver& solver, const RunFigures& figures);
std::string summary_text(const RadiositySolver& solver, const RunFigures& figures);

/// Largest resident set of this process so far, bytes.
std::size_t peak_memory();

}  // namespace cob::report
