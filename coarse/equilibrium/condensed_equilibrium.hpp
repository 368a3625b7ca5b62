// The structure condensed once, plus the zone's answers: equilibrium on the boundary Gamma (docs/method.md, section 1).
#pragma once

#include <Eigen/LU>
#include <optional>

#include "coarse/equilibrium/equilibrium.hpp"
#include "coarse/equilibrium/equilibrium_sections.hpp"
#include "coarse/structure/structure.hpp"
#include "common/linear/dense_cholesky.hpp"
#include "coupling/fine_scale.hpp"

namespace stria::coarse {

class CondensedEquilibrium : public Equilibrium {
public:
    /// `fine` may be null: an elastic, traction-free scene without a zone. `committed`: displacement of the whole mesh
    /// to start from.
    CondensedEquilibrium(const Structure& structure, coupling::FineScale* fine, EquilibriumSections input,
                         const Eigen::VectorXd& committed, double load_factor);

    void begin(const Target& target, const Predictor& predictor) override;
    Residual linearise() override;
    double solve() override;
    void look_at_rest() override { check_rest_ = true; }
    void apply(double step) override;
    void begin_commit(bool reversal) override;
    coupling::StepReport commit(bool reversal) override;
    void rollback() override;
    [[nodiscard]] double load_factor() const override { return load_factor_; }
    [[nodiscard]] Eigen::VectorXd structure_displacement() const override;
    [[nodiscard]] const Eigen::VectorXd& near_displacement() const override;
    [[nodiscard]] MachineReading machine_reading() const override;
    [[nodiscard]] EquilibriumState state() const override;
    void restore(const EquilibriumState& state) override;
    [[nodiscard]] CoarseEffort effort() const override { return effort_; }

private:
    [[nodiscard]] Eigen::VectorXd on_free(const Eigen::VectorXd& gamma) const;
    void impose_held();
    void forget_expansions();
    [[nodiscard]] Eigen::MatrixXd bordered_tangent();
    void factor_tangent();
    [[nodiscard]] Eigen::VectorXd load_derivative() const;

    const Structure& structure_;
    const Scene& scene_;
    coupling::FineScale* fine_;
    EquilibriumSections input_;
    double largest_unit_force_;
    std::vector<std::pair<int, double>> held_;    // place in Gamma, value per unit load factor
    std::vector<std::pair<int, double>> pulled_;  // place in Gamma, share of its reaction in the machine's force
    int iteration_ = 0;
    Predictor predictor_;
    LinearReading controlled_;  // on the free places
    double target_ = 0.0, off_target_ = 0.0;
    Eigen::VectorXd committed_, trial_;  // on Gamma
    double committed_load_factor_ = 0.0, load_factor_ = 0.0;
    struct Increment {
        Eigen::VectorXd displacement;  // of Gamma
        double load_factor;
    };
    IncrementMemory<Increment> increments_;
    Eigen::VectorXd residual_, correction_;  // on the free places
    double load_correction_ = 0.0;
    coupling::PatchResponse response_;
    CondensedTangent zone_tangent_;  // of the last response that brought one
    // For the next request.
    double settled_below_ = 0.0, step_ = 1.0, held_faces_ = 0.0;
    bool check_rest_ = false;
    // Of the bordered tangent, for as long as the zone's is the same; the second where that is not symmetric or not
    // definite.
    DenseCholesky factor_;
    Eigen::PartialPivLU<Eigen::MatrixXd> general_factor_;
    double sigma_ = 0.0;
    bool definite_ = false;
    bool near_wanted_ = false;                         // of the next trial state, which may well be the last
    mutable std::optional<Eigen::VectorXd> expanded_;  // structure_displacement() of the trial state
    mutable Eigen::VectorXd near_;                     // near_displacement(), of the trial state where near_known_
    mutable bool near_known_ = false;
    mutable CoarseEffort effort_;
};

}  // namespace stria::coarse
