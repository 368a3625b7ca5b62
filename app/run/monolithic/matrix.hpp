// The matrix of one Newton step on the whole body: structure, zone, contact multipliers and load factor at once.
#pragma once

#include <vector>

#include "coarse/model/scene.hpp"
#include "coarse/structure/linear_reading.hpp"
#include "common/linear/sparse.hpp"
#include "fine/zone/zone_system.hpp"

namespace stria {

/// What it is made of; all must outlive the call.
struct MonolithicMatrix {
    const coarse::Scene& scene;
    const SparseMatrix& stiffness;  // of the structure, on the unknowns of the whole mesh, MPa
    const fine::ZoneSystem& zone;
    const std::vector<int>& whole;            // unknown of the whole mesh of each zone unknown
    const std::vector<char>& held;            // of the whole mesh: 1 where an unknown is held
    const coarse::LinearReading& controlled;  // on the unknowns of the whole mesh

    /// Square: unknowns of the whole mesh, tractions of the multipliers, load factor.
    [[nodiscard]] SparseMatrix assembled() const;

private:
    using Entries = std::vector<Triplet>;
    void add(Entries& entries, int row, int column, double value) const;
    void add_bulk(Entries& entries) const;
    void add_contact(Entries& entries) const;
    void add_push(Entries& entries, int k) const;
    void add_held_and_target(Entries& entries) const;
};

}  // namespace stria
