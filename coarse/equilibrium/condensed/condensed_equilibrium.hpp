// The structure condensed once, plus the zone's answers: equilibrium on the boundary Gamma (docs/method.md, section 1).
#pragma once

#include <vector>

#include "coarse/equilibrium/condensed/bordered_system.hpp"
#include "coarse/equilibrium/condensed/condensed_zone.hpp"
#include "coarse/equilibrium/condensed/control_equation.hpp"
#include "coarse/equilibrium/condensed/expanded_displacement.hpp"
#include "coarse/equilibrium/condensed/gamma_states.hpp"
#include "coarse/equilibrium/condensed/gamma_supports.hpp"
#include "coarse/equilibrium/equilibrium.hpp"
#include "coarse/equilibrium/equilibrium_sections.hpp"
#include "coarse/equilibrium/factor_reuse.hpp"
#include "coarse/equilibrium/largest_forces.hpp"
#include "coarse/structure/structure.hpp"

namespace stria::coarse {

class CondensedEquilibrium : public Equilibrium {
public:
    /// `fine` may be null: an elastic, traction-free scene without a zone. `committed`: displacement of the whole mesh
    /// to start from, reached at `factors`.
    CondensedEquilibrium(const Structure& structure, coupling::FineScale* fine, EquilibriumSections input,
                         const Eigen::VectorXd& committed, const LoadFactors& factors);

    void begin(const Target& target, const Predictor& predictor) override;
    Residual linearise() override;
    double solve() override;
    void look_at_rest() override { zone_.look_at_rest(); }
    void set_elastic(bool elastic) override { zone_.set_elastic(elastic); }
    void apply() override;
    void apply_further(double part) override;
    void put_aside() override;
    void begin_commit(const coupling::Commit& what) override { zone_.begin_commit(what); }
    coupling::StepReport commit(const coupling::Commit& what) override;
    void rollback() override;
    [[nodiscard]] LoadFactors factors() const override { return states_.trial().factors(); }
    [[nodiscard]] const std::vector<std::int32_t>& yielding_points() const override {
        return zone_.answer().digest.yielding_points;
    }
    [[nodiscard]] Eigen::VectorXd structure_displacement() const override { return expanded_.whole(states_.trial()); }
    [[nodiscard]] DisplacementBesideFar displacement_beside_far() const override {
        return expanded_.beside_far(states_.trial());
    }
    [[nodiscard]] const Eigen::VectorXd& near_displacement() const override { return expanded_.near(states_.trial()); }
    [[nodiscard]] MachineReading machine_reading() const override;
    [[nodiscard]] EquilibriumState state() const override;
    void restore(const EquilibriumState& state) override;
    [[nodiscard]] CoarseEffort effort() const override;

private:
    void impose_supports();
    void ask_zone(const Eigen::VectorXd& u);
    [[nodiscard]] CondensedTangent tangent() const;
    [[nodiscard]] Eigen::VectorXd load_derivative() const;
    void add_structure_work(Residual& result) const;
    void expect_next(const Residual& result);
    void move(double part, bool further);

    const Structure& structure_;
    double tolerance_;  // of the relative residual
    LargestForces largest_forces_;
    GammaSupports supports_;
    GammaStates states_;
    CondensedZone zone_;
    ControlEquation control_;
    double off_target_ = 0.0;
    Eigen::VectorXd residual_;            // on the free places, N/mm
    Eigen::VectorXd structure_residual_;  // likewise, without the zone's forces
    GammaState correction_;               // likewise, mm
    struct Taken {
        GammaState correction;  // the last one that was applied, whole
        double work_before;     // along it, of the structure's residual where it began, N
    } taken_;
    FactorReuse factor_reuse_{0.0};  // in the present search
    BorderedSystem system_;          // for as long as the zone's tangent is the same
    bool near_wanted_ = false;       // of the next trial state, which may well be the last
    ExpandedDisplacement expanded_;  // of the trial state
    coupling::WorkCounts work_;
};

}  // namespace stria::coarse
