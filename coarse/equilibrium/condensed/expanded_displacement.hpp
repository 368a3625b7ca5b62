// The structure's displacement that follows from a state on Gamma: found when it is asked for, and once.
#pragma once

#include <optional>

#include "coarse/equilibrium/condensed/gamma_states.hpp"
#include "coarse/structure/structure.hpp"
#include "coupling/work_counts.hpp"

namespace stria::coarse {

class ExpandedDisplacement {
public:
    explicit ExpandedDisplacement(const Structure& structure)
        : structure_(structure), near_(Eigen::VectorXd::Zero(structure.scene().enriched.unknowns)) {}

    /// The state is another one.
    void forget() {
        whole_.reset();
        near_known_ = false;
    }

    /// Of the whole mesh, mm, zero inside the zone; and the same of near elements alone.
    [[nodiscard]] const Eigen::VectorXd& whole(const GammaState& state) const;
    [[nodiscard]] const Eigen::VectorXd& near(const GammaState& state) const;
    [[nodiscard]] DisplacementBesideFar beside_far(const GammaState& state) const;

    [[nodiscard]] const coupling::WorkCounts& work() const { return work_; }

private:
    const Structure& structure_;
    mutable std::optional<Eigen::VectorXd> whole_;
    mutable Eigen::VectorXd near_;
    mutable bool near_known_ = false;
    mutable coupling::WorkCounts work_;
};

}  // namespace stria::coarse
