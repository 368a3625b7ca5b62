// The loads of the load factor 1, condensed onto Gamma, and what a testing machine reads and does work on.
#pragma once

#include "coarse/structure/leaf_numbering.hpp"
#include "coarse/structure/linear_reading.hpp"
#include "common/substructure/substructure.hpp"

namespace stria::coarse {

/// Readings are linear in the displacement of the free places of Gamma and in the load factor.
class CondensedLoads {
public:
    /// `leaf`: the structure, its unknowns numbered as `numbering` says.
    CondensedLoads(const CoarseElements& elements, const LeafNumbering& numbering, const Substructure& leaf);

    /// On all unknowns of the structure: forces and imposed displacements of the load factor 1, N/mm.
    [[nodiscard]] const ReducedLoad& unit() const { return unit_; }

    /// Likewise of the initial stress; zero without one.
    [[nodiscard]] const ReducedLoad& initial() const { return initial_; }

    /// Mean displacement of the loaded boundary along its direction, mm.
    [[nodiscard]] const LinearReading& mean_displacement() const { return mean_displacement_; }

    /// Force with which the supports hold the loaded boundary along its direction, N/mm, as far as coarse elements pull
    /// at it. Zero where forces load that boundary.
    [[nodiscard]] const LinearReading& holding_force() const { return holding_force_; }

    /// Displacement that the forces of the load factor 1 do work on: their product with u, N.
    [[nodiscard]] const LinearReading& load_displacement() const { return load_displacement_; }

    /// Force that the imposed displacements of the load factor 1 do work against: their product with the reactions of
    /// the coarse elements, N.
    [[nodiscard]] const LinearReading& imposed_force() const { return imposed_force_; }

    /// Elastic energy of the coarse elements, N (per mm of thickness), without visiting one. `tangent`: the
    /// structure's, condensed; `u`: on the free places.
    [[nodiscard]] double stored_energy(const Eigen::MatrixXd& tangent, const Eigen::VectorXd& u,
                                       double load_factor) const;

private:
    ReducedLoad unit_, initial_;
    LinearReading mean_displacement_, holding_force_, load_displacement_, imposed_force_;
    double unit_energy_ = 0.0;     // twice the energy of the load factor 1 with the free places held, N
    double initial_energy_ = 0.0;  // that of the initial stress with the free places held, N
};

}  // namespace stria::coarse
