// Rigid motions of the plane that the supports leave free: refused if the loads drive them, else pinned without stress.
#pragma once

#include <string>
#include <vector>

#include "coarse/model/loads/boundary_conditions.hpp"

namespace stria::coarse {

/// A displacement held at zero to remove a free motion. Its reaction vanishes, because the loads balance.
struct Pin {
    int node;
    int component;
};

struct FreeMotions {
    std::vector<std::string> names;  // "translation along x", "translation along y", "rotation"
    std::vector<Pin> pins;           // as many; together with the supports they remove every rigid motion and no more
    std::string text;                // for the log; empty if nothing is free
};

/// Throws CaseError naming the motion if the loads do work on a free one (to 1e-9 of the sum of their magnitudes).
FreeMotions analyse_rigid_motions(const Mesh& mesh, const Loads& loads);

/// Whether a motion that no support of `loads` feels changes the sum of force . u: then the pins say what it is, and
/// not the body.
bool is_left_free(const std::vector<AppliedForce>& sum, const Mesh& mesh, const Loads& loads);

}  // namespace stria::coarse
