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

ReducedLoad reduce_initial_load(const CoarseElements& elements, const LeafNumbering& numbering,
                                const Substructure& leaf, const ReducedLoad& unit) {
    const Eigen::VectorXd& load = elements.initial().load;
    if (load.size() > 0) return leaf.reduce(gather(load, numbering.unknowns()));
    return {Eigen::VectorXd::Zero(unit.interior.size()), Eigen::VectorXd::Zero(unit.boundary.size())};
}

/// Condenses readings: what they make of the load factor is seen with Gamma held.
struct Reader {
    const CoarseElements& elements;
    const LeafNumbering& numbering;
    const Substructure& leaf;
    const ReducedLoad &unit, &initial;

    [[nodiscard]] const Scene& scene() const { return elements.scene(); }
    [[nodiscard]] LinearReading nothing() const {
        return {Eigen::VectorXd::Zero(std::ssize(numbering.free_places())), 0.0, 0.0};
    }

    /// `weights`: on all unknowns of the mesh. Of K = L L^T in the interior, w . K^-1 f is the product of two reduced
    /// loads.
    [[nodiscard]] LinearReading displacement(const Eigen::VectorXd& weights) const {
        const ReducedLoad reduced = leaf.reduce(gather(weights, numbering.unknowns()));
        LinearReading reading{reduced.boundary, reduced.interior.dot(unit.interior),
                              reduced.interior.dot(initial.interior)};
        for (const PrescribedUnknown& p : scene().prescribed) reading.per_load_factor += weights[p.unknown] * p.value;
        return reading;
    }

    /// `shares`: of the force on each prescribed unknown in the sum.
    [[nodiscard]] LinearReading force(const Eigen::VectorXd& shares) const {
        Eigen::VectorXd moved = Eigen::VectorXd::Zero(scene().enriched.unknowns);
        for (std::size_t k = 0; k < scene().prescribed.size(); ++k)
            moved[scene().prescribed[k].unknown] = shares[static_cast<Eigen::Index>(k)];
        LinearReading reading{leaf.reduce(-gather(load_of_imposed(elements, moved), numbering.unknowns())).boundary,
                              shares.dot(forces_on_prescribed(elements, gamma_held(unit, 1.0))), 0.0};
        if (elements.initial().load.size() == 0) return reading;
        reading.constant = shares.dot(forces_on_prescribed(elements, gamma_held(initial, 0.0)));
        for (std::size_t k = 0; k < scene().prescribed.size(); ++k)
            reading.constant -=
                shares[static_cast<Eigen::Index>(k)] * elements.initial().load[scene().prescribed[k].unknown];
        return reading;
    }

    /// Displacement of the whole mesh under a load with Gamma held.
    [[nodiscard]] Eigen::VectorXd gamma_held(const ReducedLoad& load, double load_factor) const {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(scene().enriched.unknowns);
        u(numbering.unknowns()) = leaf.expand(load, Eigen::VectorXd::Zero(std::ssize(numbering.free_places())));
        impose(scene().prescribed, load_factor, u);
        return u;
    }
};

}  // namespace

// Of imposed displacements the reactions do the work; loads on the same unknowns do none of their own.
CondensedLoads::CondensedLoads(const CoarseElements& elements, const LeafNumbering& numbering, const Substructure& leaf)
    : unit_(reduce_unit_load(elements, numbering, leaf)),
      initial_(reduce_initial_load(elements, numbering, leaf, unit_)) {
    const Scene& scene = elements.scene();
    const Reader reader{elements, numbering, leaf, unit_, initial_};
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
    initial_energy_ = elements.initial().energy - 0.5 * initial_.interior.squaredNorm();
}

// With the interior in equilibrium: u . K u = u_b . S u_b + 2 lambda m . u_b + lambda^2 e, where m, what imposed
// displacements pull at the free places u_b, is the reduced load less that of the forces alone. An initial stress does
// work on what Gamma and the supports move: minus g_0 . u_b, and lambda times the force that it needs to be held. What
// it has let go of inside, with Gamma held, is (1/2) f_0 . K^-1 f_0.
double CondensedLoads::stored_energy(const Eigen::MatrixXd& tangent, const Eigen::VectorXd& u,
                                     double load_factor) const {
    const Eigen::VectorXd pull = load_displacement_.weights - unit_.boundary;
    const double elastic = 0.5 * (u.dot(tangent * u) + load_factor * (2.0 * pull.dot(u) + load_factor * unit_energy_));
    return elastic + initial_energy_ - initial_.boundary.dot(u) + load_factor * imposed_force_.constant;
}

}  // namespace stria::coarse
