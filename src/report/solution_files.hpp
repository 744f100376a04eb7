/// \file
/// A solution as files: meshes for ParaView and Blender, tables, and the run's summary.
#pragma once

#include "cob/solver.hpp"

#include <optional>
#include <string>

namespace cob::report {

/// Binary PLY. Vertices shared by elements of one polygon, each with its exitance (`exitance_r` ... W/m2) and a colour
/// (`red` ... sRGB at the exposure); one face for each element, T-vertices included, with `polygon`, `level`, `state`.
std::string solution_ply(const RadiositySolver& solver, double exposure);
/// VTK XML PolyData: the same with exitance as point and cell data.
std::string solution_vtp(const RadiositySolver& solver);
/// One row for each element: its address, centre, visible area, exitance and the state of its buffer.
std::string solution_csv(const RadiositySolver& solver);

/// What a run was and cost beyond what the solver knows.
struct RunFigures {
    std::string scene;
    double seconds = 0, picture_seconds = 0;  ///< Of the whole run and of its pictures.
    std::optional<double> exposure;           ///< None where the drawing was interrupted and no picture was written.
    bool interrupted = false;
    std::string ended_by;  ///< "number of shots", "number of elements", "unshot flux" or "interrupt".
};
struct RunSummary {
    std::string json, text;
};
RunSummary summarise(const RadiositySolver& solver, const RunFigures& figures);

}  // namespace cob::report
