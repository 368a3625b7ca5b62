// Loads that do not grow in proportion, for an elastic body whose faces slide: the case file has one load factor, so
// the loads are changed stage by stage, and every stage goes on from where the last one ended.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "coarse/equilibrium/condensed_equilibrium.hpp"
#include "coarse/equilibrium/newton.hpp"
#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "fine/zone/fine_model.hpp"
#include "tests/support/one_equilibrium.hpp"

namespace stria::test {

/// Tractions of a uniform state of stress on all four sides, MPa; `across` is sigma_xx, `along` sigma_yy, which grows
/// by `along_gradient` per mm of x from x = `origin` on.
struct UniformStress {
    double across = 0.0, along = 0.0, shear = 0.0, along_gradient = 0.0, origin = 0.0;

    [[nodiscard]] std::vector<BoundarySection> sections() const {
        std::vector<BoundarySection> sides(4);
        const char* names[] = {"top", "bottom", "right", "left"};
        for (std::size_t k = 0; k < 4; ++k) {
            const double sign = k % 2 == 0 ? 1.0 : -1.0;
            sides[k].on = names[k];
            sides[k].traction = sign * (k < 2 ? Vec2(shear, along) : Vec2(across, shear));
            if (k >= 2) continue;
            sides[k].traction_gradient(1, 0) = sign * along_gradient;
            sides[k].origin = {origin, 0.0};
        }
        return sides;
    }
};

/// The loads must not reach into the zone.
class StagedBody {
public:
    explicit StagedBody(Case input) : input_(std::move(input)), fine_(input_) {}

    /// Brings the body to equilibrium under other loads, and commits it.
    Equilibrated load(std::vector<BoundarySection> sections) {
        input_.boundaries = std::move(sections);
        const coarse::Scene scene = coarse::refined_scene(input_);
        const std::vector<double> no_K(scene.enriched.tips.size(), 0.0);
        const coarse::Structure structure(scene, coarse::select_zone(scene, no_K));
        if (displacement_.size() == 0) {
            displacement_ = Eigen::VectorXd::Zero(scene.enriched.unknowns);
            fine_.set_patch(coarse::make_patch(scene, structure.in_zone(), structure.gamma(), displacement_));
        }
        coarse::CondensedEquilibrium equilibrium(structure, &fine_, scene.input, displacement_, 1.0);
        Equilibrated result;
        result.newton = coarse::find_equilibrium(equilibrium, {Control::Load, 1.0}, {}, input_.solver);
        result.displacement = displacement_ = equilibrium.structure_displacement();
        result.zone = equilibrium.commit(false);
        result.tips = coarse::fracture_parameters(structure, result.displacement, result.zone);
        return result;
    }

private:
    Case input_;
    fine::FineModel fine_;
    Eigen::VectorXd displacement_;
};

}  // namespace stria::test
