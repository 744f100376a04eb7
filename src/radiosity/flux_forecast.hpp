/// \file
/// What the flux between two pieces will take, told from a beginning of it.
#pragma once

#include "radiosity/piece_pair.hpp"

namespace cob::radiosity {

struct ForecastOptions {
    QuadratureOptions quadrature;  ///< As it will be asked for.
    bool certified = false;        ///< By certified_flux(), else by flux_between().
    bool both_sides = false;       ///< From the other side, too, in any case; else where it falls short.
    std::size_t samples = 1;       ///< Forecasts that share about a second.
};

struct FluxForecast {
    double evaluations = 0;  ///< Triangles where certified.
    double seconds = 0;      ///< Of one core.
};

/// Begins an obstructed pair, with more and more evaluations, up to about a tenth of what it will take. The numbers in
/// it are fitted to pairs behind 3 to 10 triangles in general position; on others it was 0.3 to 2 times, once 4.4.
FluxForecast forecast_flux(const PairContext& context, const PiecePair& pair, const ForecastOptions& options);

}  // namespace cob::radiosity
