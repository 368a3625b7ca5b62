// Sections of a case file on loads beside those of [load] (case.hpp): load cases, and pressures that travel.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace stria {

/// Hertz' pressure p0 sqrt(1 - ((s - s_c) / half_width)^2) on a straight edge, with friction times it along the edge.
/// In each cycle its middle s_c goes from `from` to `to`, equally far in each increment.
struct TravellingPressure {
    std::string profile = "hertz";
    double p0 = 0.0;              // MPa
    double half_width = 0.0;      // mm
    double friction = 0.0;        // traction towards growing s, in p
    double from = 0.0, to = 0.0;  // mm along the edge, towards growing x (y where it stands upright), from `origin` on
    bool operator==(const TravellingPressure&) const = default;
};

/// Factors of a load case at the maximum and the minimum of each cycle of [load].
struct CaseBlock {
    int cycles = 1;
    double at_max = 0.0, at_min = 0.0;
    bool operator==(const CaseBlock&) const = default;
};

/// How a load that lags goes from one turn to the next.
enum class LagPath { Sine, Triangle };

/// Loads beside those of [load], with a history of their own: one of `constant`, `factor` and `blocks`.
struct LoadCaseSection {
    std::string name;
    std::optional<double> constant;  // of a dead load: applied first, then kept
    std::optional<double> factor;    // times the history of [load]
    double phase = 0.0;              // degrees of a cycle by which it lags behind [load]
    LagPath path = LagPath::Sine;
    std::vector<CaseBlock> blocks;  // those of the spectrum file's column included
    bool operator==(const LoadCaseSection&) const = default;
};

}  // namespace stria
