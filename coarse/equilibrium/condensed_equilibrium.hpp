// The structure condensed once, plus the zone's answers: equilibrium on the boundary Gamma (docs/method.md, section 1).
#pragma once

#include <vector>

#include "coarse/equilibrium/bordered_system.hpp"
#include "coarse/equilibrium/equilibrium.hpp"
#include "coarse/equilibrium/equilibrium_sections.hpp"
#include "coarse/equilibrium/expanded_displacement.hpp"
#include "coarse/equilibrium/factor_reuse.hpp"
#include "coarse/structure/structure.hpp"
#include "coupling/fine_scale.hpp"

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
    void look_at_rest() override { request_.check_rest = true; }
    void set_elastic(bool elastic) override { request_.elastic = elastic; }
    void apply() override;
    void apply_further(double part) override;
    void put_aside() override;
    void begin_commit(const coupling::Commit& what) override;
    coupling::StepReport commit(const coupling::Commit& what) override;
    void rollback() override;
    [[nodiscard]] LoadFactors factors() const override { return trial_.factors(); }
    [[nodiscard]] const std::vector<std::int32_t>& yielding_points() const override {
        return response_.digest.yielding_points;
    }
    [[nodiscard]] Eigen::VectorXd structure_displacement() const override { return expanded_.whole(trial_); }
    [[nodiscard]] DisplacementBesideFar displacement_beside_far() const override {
        return expanded_.beside_far(trial_);
    }
    [[nodiscard]] const Eigen::VectorXd& near_displacement() const override { return expanded_.near(trial_); }
    [[nodiscard]] MachineReading machine_reading() const override;
    [[nodiscard]] EquilibriumState state() const override;
    void restore(const EquilibriumState& state) override;
    [[nodiscard]] CoarseEffort effort() const override;

private:
    [[nodiscard]] Eigen::VectorXd on_free(const Eigen::VectorXd& gamma) const;
    void impose_held();
    void ask_zone(const Eigen::VectorXd& u);
    [[nodiscard]] Eigen::MatrixXd tangent() const;
    [[nodiscard]] Eigen::VectorXd load_derivative() const;
    [[nodiscard]] double largest_applied_force() const;
    void add_structure_work(Residual& result) const;
    void move(double part);

    /// A place on Gamma that is prescribed.
    struct Held {
        std::ptrdiff_t place;
        const PrescribedUnknown* prescribed;
        double share;  // of its reaction in the machine's force
    };

    const Structure& structure_;
    coupling::FineScale* fine_;
    EquilibriumSections input_;
    double largest_unit_force_, largest_initial_force_;  // N/mm
    std::vector<double> largest_case_forces_;            // likewise, of each load case
    std::vector<Held> held_;
    LinearReading controlled_;  // on the free places
    double target_ = 0.0, off_target_ = 0.0;
    GammaState committed_, trial_;
    IncrementMemory<GammaState> increments_;
    Eigen::VectorXd residual_;            // on the free places, N/mm
    Eigen::VectorXd structure_residual_;  // likewise, without the zone's forces
    GammaState correction_;               // likewise, mm
    struct Taken {
        GammaState correction;  // the last one that was applied, whole
        double work_before;     // along it, of the structure's residual where it began, N
    } taken_;
    FactorReuse factor_reuse_{0.0};        // in the present search
    coupling::PatchDisplacement request_;  // the next one; its boundary is put in when it leaves
    coupling::PatchResponse response_;
    CondensedTangent zone_tangent_;  // of the last response that brought one
    BorderedSystem system_;          // for as long as the zone's tangent is the same
    bool factor_is_due_ = true;      // it is not any more
    bool put_aside_ = false;         // the zone does not know yet
    bool near_wanted_ = false;       // of the next trial state, which may well be the last
    ExpandedDisplacement expanded_;  // of the trial state
    CoarseEffort effort_;
};

}  // namespace stria::coarse
