// The unit loads of a case: the main one, and those that have a factor of their own (load_factors.hpp).
#pragma once

#include <optional>
#include <vector>

#include "coarse/model/loads/boundary_conditions.hpp"

namespace stria::coarse {

struct LoadsOfCase {
    Loads main;                // with all supports: what a load case moves or holds, the main load holds at zero
    std::vector<Loads> cases;  // in the order of CaseHistories

    /// Of a load case by its number; none: the main one.
    [[nodiscard]] const Loads& of(std::optional<std::size_t> load_case) const {
        return load_case ? cases[*load_case] : main;
    }
};

/// Distance to the nearest node on which a force acts or that is held, mm; infinite where there is none.
double distance_to_loads(const Mesh& mesh, const LoadsOfCase& loads, const Vec2& x);

/// To the nearest of Loads::points.
double distance_to_points(const Mesh& mesh, const LoadsOfCase& loads, const Vec2& x);

/// Each at the factor 1: tractions in MPa, forces in N per mm of thickness, displacements in mm. Throws CaseError,
/// naming the key, for what cannot be put on that boundary.
LoadsOfCase resolve_loads(const Mesh& mesh, const Case& input);

/// That of the first listed section with a load or a non-zero displacement, if any; of those without a factor of their
/// own if there is one. What other sections put on it counts. `all`: the loads of the case.
std::optional<LoadedBoundary> loaded_boundary(const Mesh& mesh, const Case& input, const LoadsOfCase& all);

}  // namespace stria::coarse
