// Multipliers at rest: where faces stay apart, or together without sliding, they are a linear part of the substructure
// that they rest with (docs/equations.md, rest).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/index_set.hpp"
#include "coupling/zone_snapshot.hpp"

namespace stria::fine {

/// Tractions are those of all multipliers, pressures first, MPa: FaceOperators.
class RestingFaces {
public:
    explicit RestingFaces(int multipliers, int tractions)
        : resting_(multipliers), traction_(Eigen::VectorXd::Zero(tractions)), changes_(at(multipliers), all) {}

    [[nodiscard]] bool contains(int k) const { return resting_.contains(k); }
    [[nodiscard]] const MultiplierSet& multipliers() const { return resting_; }
    /// With which they came to rest.
    [[nodiscard]] const Eigen::VectorXd& traction() const { return traction_; }

    /// These rest, and no others, at committed tractions of all.
    void rest(MultiplierSet multipliers, const Eigen::VectorXd& traction) {
        resting_ = std::move(multipliers);
        traction_ = traction;
    }
    /// The others are awake.
    void wake_all_but(MultiplierSet still) { resting_ = std::move(still); }

    /// A status has changed in a committed increment; a half cycle ends.
    void note_change(int k) { changes_[at(k)] |= 1; }
    void note_half_cycle() {
        for (int& change : changes_) change = (change << 1) & all;
    }
    /// The status has not changed in the last half cycle of the direction that comes.
    [[nodiscard]] bool is_steady(int k) const {
        constexpr int same_direction = 4;
        return (changes_[at(k)] & same_direction) == 0;
    }
    /// Bit 0: it has changed in this half cycle; bit j: in the one j before it. Unknown bits are set.
    [[nodiscard]] int changes(int k) const { return changes_[at(k)]; }
    void set_changes(int k, int changes) { changes_[at(k)] = changes; }

private:
    static constexpr int all = 7;

    MultiplierSet resting_;
    Eigen::VectorXd traction_;
    std::vector<int> changes_;  // per multiplier
};

}  // namespace stria::fine
