#include "coarse/structure/condensed_loads.hpp"

#include "coarse/elements/support_forces.hpp"

namespace stria::coarse {
namespace {

/// Forces on the free unknowns, and what imposed displacements pull at them.
ReducedLoad reduce_unit_load(const CoarseElements& elements, const LeafNumbering& numbering, const Substructure& leaf) {
    const Scene& scene = elements.scene();
    Eigen::VectorXd imposed = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    impose(scene.prescribed, 1.0, imposed);
    return leaf.reduce(gather(scene.unit_force, numbering.unknowns()) +
                       gather(load_of_imposed(elements, imposed), numbering.unknowns()));
}

/// Condenses readings: what they make of the load factor is seen with Gamma held.
struct Reader {
    const CoarseElements& elements;
    const LeafNumbering& numbering;
    const Substructure& leaf;
    const ReducedLoad& unit;

    [[nodiscard]] const Scene& scene() const { return elements.scene(); }
    [[nodiscard]] LinearReading nothing() const {
        return {Eigen::VectorXd::Zero(std::ssize(numbering.free_places())), 0.0};
    }

    /// `weights`: on all unknowns of the mesh. Of K = L L^T in the interior, w . K^-1 f is the product of two reduced
    /// loads.
    [[nodiscard]] LinearReading displacement(const Eigen::VectorXd& weights) const {
        const ReducedLoad reduced = leaf.reduce(gather(weights, numbering.unknowns()));
        LinearReading reading{reduced.boundary, reduced.interior.dot(unit.interior)};
        for (const PrescribedUnknown& p : scene().prescribed) reading.per_load_factor += weights[p.unknown] * p.value;
        return reading;
    }

    /// `shares`: of the force on each prescribed unknown in the sum.
    [[nodiscard]] LinearReading force(const Eigen::VectorXd& shares) const {
        Eigen::VectorXd moved = Eigen::VectorXd::Zero(scene().enriched.unknowns);
        for (std::size_t k = 0; k < scene().prescribed.size(); ++k)
            moved[scene().prescribed[k].unknown] = shares[static_cast<Eigen::Index>(k)];
        return {leaf.reduce(-gather(load_of_imposed(elements, moved), numbering.unknowns())).boundary,
                shares.dot(forces_on_prescribed(elements, gamma_held()))};
    }

    /// Displacement of the whole mesh at the load factor 1 with Gamma held.
    [[nodiscard]] Eigen::VectorXd gamma_held() const {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(scene().enriched.unknowns);
        u(numbering.unknowns()) = leaf.expand(unit, Eigen::VectorXd::Zero(std::ssize(numbering.free_places())));
        impose(scene().prescribed, 1.0, u);
        return u;
    }
};

}  // namespace

// Of imposed displacements the reactions do the work; loads on the same unknowns do none of their own.
CondensedLoads::CondensedLoads(const CoarseElements& elements, const LeafNumbering& numbering, const Substructure& leaf)
    : unit_(reduce_unit_load(elements, numbering, leaf)) {
    const Scene& scene = elements.scene();
    const Reader reader{elements, numbering, leaf, unit_};
    mean_displacement_ = reader.displacement(scene.mean_displacement);
    Eigen::VectorXd force = scene.unit_force, imposed(std::ssize(scene.prescribed));
    for (std::size_t k = 0; k < scene.prescribed.size(); ++k) {
        imposed[static_cast<Eigen::Index>(k)] = scene.prescribed[k].value;
        force[scene.prescribed[k].unknown] = 0.0;
    }
    load_displacement_ = reader.displacement(force);
    imposed_force_ = imposed.isZero(0.0) ? reader.nothing() : reader.force(imposed);
    holding_force_ = scene.pull.isZero(0.0) ? reader.nothing() : reader.force(scene.pull);
    unit_energy_ = load_displacement_.per_load_factor + imposed_force_.per_load_factor;
}

// With the interior in equilibrium: u . K u = u_b . S u_b + 2 lambda m . u_b + lambda^2 e, where m, what imposed
// displacements pull at the free places u_b, is the reduced load less that of the forces alone.
double CondensedLoads::stored_energy(const Eigen::MatrixXd& tangent, const Eigen::VectorXd& u,
                                     double load_factor) const {
    const Eigen::VectorXd pull = load_displacement_.weights - unit_.boundary;
    return 0.5 * (u.dot(tangent * u) + load_factor * (2.0 * pull.dot(u) + load_factor * unit_energy_));
}

}  // namespace stria::coarse
