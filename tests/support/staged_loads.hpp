// Loads that do not grow in proportion, for an elastic body whose faces slide: the case file has one load factor, so
// the loads are changed stage by stage, and every stage goes on from where the last one ended.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "coarse/equilibrium/condensed/condensed_equilibrium.hpp"
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
    /// `slip_at`: as coupling::Patch::slip_at.
    explicit StagedBody(Case input, std::vector<std::vector<double>> slip_at = {})
        : input_(std::move(input)), slip_at_(std::move(slip_at)), fine_(input_) {}

    /// Brings the body to equilibrium under other loads, and commits it.
    Equilibrated load(std::vector<BoundarySection> sections, const coupling::Commit& what = {}) {
        Stage stage(*this, std::move(sections));
        Equilibrated result;
        result.newton = stage.newton;
        result.displacement = displacement_ = stage.equilibrium.structure_displacement();
        result.zone = stage.equilibrium.commit(what);
        result.tips = coarse::fracture_parameters(stage.structure, result.displacement, result.zone);
        return result;
    }

    /// The same, and goes back to what is committed.
    coarse::NewtonReport attempt(std::vector<BoundarySection> sections) {
        Stage stage(*this, std::move(sections));
        stage.equilibrium.rollback();
        return stage.newton;
    }

private:
    /// Loads, and the trial state that bears them.
    struct Stage {
        Stage(StagedBody& body, std::vector<BoundarySection> sections)
            : scene(body.loaded(std::move(sections))), structure(scene, zone_of(scene)),
              equilibrium(structure, body.zone(structure), scene.input, body.displacement_, 1.0),
              newton(coarse::find_equilibrium(equilibrium, {Control::Load, 1.0}, {}, {scene.input.solver})) {}
        coarse::Scene scene;
        coarse::Structure structure;
        coarse::CondensedEquilibrium equilibrium;
        coarse::NewtonReport newton;
    };

    static ElementSet zone_of(const coarse::Scene& scene) {
        return coarse::select_zone(scene, std::vector<double>(scene.enriched.tips.size(), 0.0));
    }
    [[nodiscard]] coarse::Scene loaded(std::vector<BoundarySection> sections) {
        input_.boundaries = std::move(sections);
        return coarse::refined_scene(input_);
    }
    [[nodiscard]] fine::FineModel* zone(const coarse::Structure& structure) {
        if (displacement_.size() > 0) return &fine_;
        const coarse::Scene& scene = structure.scene();
        displacement_ = Eigen::VectorXd::Zero(scene.enriched.unknowns);
        coupling::Patch patch = coarse::make_patch(scene, structure.in_zone(), structure.gamma(), displacement_);
        patch.slip_at = slip_at_;
        fine_.set_patch(patch);
        return &fine_;
    }

    Case input_;
    std::vector<std::vector<double>> slip_at_;
    fine::FineModel fine_;
    Eigen::VectorXd displacement_;
};

}  // namespace stria::test
