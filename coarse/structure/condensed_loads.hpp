// The unit loads, condensed onto Gamma, and what a testing machine reads and does work on.
#pragma once

#include <vector>

#include "coarse/structure/leaf_numbering.hpp"
#include "coarse/structure/linear_reading.hpp"
#include "common/substructure/substructure.hpp"

namespace stria::coarse {

/// What the work of one unit load needs.
struct WorkReadings {
    LinearReading displacement;   // that its forces do work on: their product with u, N
    LinearReading imposed_force;  // that its imposed displacements do work against: their product with the reactions of
                                  // the coarse elements, N
};

/// Readings are linear in the displacement of the free places of Gamma and in the load factors.
class CondensedLoads {
public:
    /// `leaf`: the structure, its unknowns numbered as `numbering` says.
    CondensedLoads(const CoarseElements& elements, const LeafNumbering& numbering, const Substructure& leaf);

    /// On all unknowns of the structure: forces and imposed displacements of the load factor 1, N/mm.
    [[nodiscard]] const ReducedLoad& unit() const { return unit_; }

    /// Likewise of each load case.
    [[nodiscard]] const std::vector<ReducedLoad>& cases() const { return cases_; }

    /// Likewise of the initial stress; without one zero, and nothing inside.
    [[nodiscard]] const ReducedLoad& initial() const { return initial_; }

    /// Mean displacement of the loaded boundary along its direction, mm.
    [[nodiscard]] const LinearReading& displacement_reading() const { return displacement_reading_; }

    /// Force with which the supports hold the loaded boundary along its direction, N/mm, as far as coarse elements and
    /// loads pull at it: those on the boundary, and those beside it that act on its corner nodes. Zero where forces
    /// load that boundary.
    [[nodiscard]] const LinearReading& holding_force() const { return holding_force_; }

    /// Of the main load, and of each load case.
    [[nodiscard]] const WorkReadings& work() const { return work_; }
    [[nodiscard]] const std::vector<WorkReadings>& work_of_cases() const { return work_of_cases_; }

    /// Elastic energy of the coarse elements, N (per mm of thickness), without visiting one. `tangent`: the
    /// structure's, condensed; `u`: on the free places.
    [[nodiscard]] double stored_energy(const Eigen::MatrixXd& tangent, const Eigen::VectorXd& u,
                                       const LoadFactors& factors) const;

private:
    [[nodiscard]] double energy_of_cases(const Eigen::VectorXd& u, const LoadFactors& factors) const;

    ReducedLoad unit_, initial_;
    std::vector<ReducedLoad> cases_;
    LinearReading displacement_reading_, holding_force_;
    WorkReadings work_;
    std::vector<WorkReadings> work_of_cases_;
    double unit_energy_ = 0.0;     // twice the energy of the load factor 1 with the free places held, N
    double initial_energy_ = 0.0;  // that of the initial stress with the free places held, N
};

}  // namespace stria::coarse
