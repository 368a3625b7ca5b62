#include "coarse/structure/condensed_loads.hpp"

#include <algorithm>

#include "coarse/elements/support_forces.hpp"

namespace stria::coarse {
namespace {

/// Forces on the free unknowns, and what imposed displacements pull at them.
ReducedLoad reduce_unit_load(const CoarseElements& elements, const LeafNumbering& numbering, const Substructure& leaf) {
    const Scene& scene = elements.scene();
    Eigen::VectorXd load = gather(scene.unit_force, numbering.unknowns());
    if (std::ranges::all_of(scene.prescribed, [](const PrescribedUnknown& p) { return p.value == 0.0; }))
        return leaf.reduce(load);
    Eigen::VectorXd imposed = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    impose(scene.prescribed, 1.0, imposed);
    return leaf.reduce(load + gather(load_of_imposed(elements, imposed), numbering.unknowns()));
}

/// Likewise of a load case.
ReducedLoad reduce_case(const CoarseElements& elements, const LeafNumbering& numbering, const Substructure& leaf,
                        Eigen::Index k) {
    const Scene& scene = elements.scene();
    Eigen::VectorXd load = scene.case_forces[at(k)], imposed = Eigen::VectorXd::Zero(load.size());
    impose(scene.prescribed, LoadFactors::of_one_case(k), imposed);
    if (!imposed.isZero(0.0)) load += load_of_imposed(elements, imposed);
    return leaf.reduce(gather(load, numbering.unknowns()));
}

std::vector<ReducedLoad> reduce_cases(const CoarseElements& elements, const LeafNumbering& numbering,
                                      const Substructure& leaf) {
    std::vector<ReducedLoad> cases;
    for (Eigen::Index k = 0; k < std::ssize(elements.scene().case_forces); ++k)
        cases.push_back(reduce_case(elements, numbering, leaf, k));
    return cases;
}

ReducedLoad reduce_initial_load(const CoarseElements& elements, const LeafNumbering& numbering,
                                const Substructure& leaf, const ReducedLoad& unit) {
    const Eigen::VectorXd& load = elements.initial().load;
    if (load.size() > 0) return leaf.reduce(gather(load, numbering.unknowns()));
    return {{}, Eigen::VectorXd::Zero(unit.boundary.size())};
}

/// Condenses readings: what they make of the load factor is seen with Gamma held.
struct Reader {
    const CoarseElements& elements;
    const LeafNumbering& numbering;
    const Substructure& leaf;
    const ReducedLoad &unit, &initial;
    const std::vector<ReducedLoad>& cases;

    [[nodiscard]] const Scene& scene() const { return elements.scene(); }
    [[nodiscard]] LinearReading nothing() const {
        return {Eigen::VectorXd::Zero(std::ssize(numbering.free_places())), 0.0, 0.0,
                Eigen::VectorXd::Zero(std::ssize(cases))};
    }

    /// `weights`: on all unknowns of the mesh. Of K = L L^T in the interior, w . K^-1 f is the product of two reduced
    /// loads.
    [[nodiscard]] LinearReading displacement(const Eigen::VectorXd& weights) const {
        return displacement(leaf.reduce(gather(weights, numbering.unknowns())), weights);
    }
    [[nodiscard]] LinearReading displacement(const ReducedLoad& reduced, const Eigen::VectorXd& weights) const {
        LinearReading reading{reduced.boundary, reduced.interior.dot(unit.interior), 0.0};
        if (initial.interior.size() > 0) reading.constant = reduced.interior.dot(initial.interior);
        for (const PrescribedUnknown& p : scene().prescribed) reading.per_load_factor += weights[p.unknown] * p.value;
        reading.per_case.resize(std::ssize(cases));
        for (Eigen::Index k = 0; k < std::ssize(cases); ++k) {
            reading.per_case[k] = reduced.interior.dot(cases[at(k)].interior);
            for (const PrescribedUnknown& p : scene().prescribed)
                reading.per_case[k] += weights[p.unknown] * p.in_case(k);
        }
        return reading;
    }

    /// `shares`: of the internal force on each prescribed unknown in the sum.
    [[nodiscard]] LinearReading force(const Eigen::VectorXd& shares) const {
        Eigen::VectorXd moved = Eigen::VectorXd::Zero(scene().enriched.unknowns);
        for (std::size_t k = 0; k < scene().prescribed.size(); ++k)
            moved[scene().prescribed[k].unknown] = shares[static_cast<Eigen::Index>(k)];
        LinearReading reading{leaf.reduce(-gather(load_of_imposed(elements, moved), numbering.unknowns())).boundary,
                              shares.dot(forces_on_prescribed(elements, gamma_held(unit, 1.0))), 0.0,
                              Eigen::VectorXd(std::ssize(cases))};
        for (Eigen::Index k = 0; k < std::ssize(cases); ++k)
            reading.per_case[k] =
                shares.dot(forces_on_prescribed(elements, gamma_held(cases[at(k)], LoadFactors::of_one_case(k))));
        if (elements.initial().load.size() == 0) return reading;
        reading.constant = shares.dot(forces_on_prescribed(elements, gamma_held(initial, 0.0)) -
                                      loads_on_prescribed(scene(), elements.initial().load));
        return reading;
    }

    /// What a machine pulls with at the loaded boundary: tractions beside it act on its corner nodes, too.
    [[nodiscard]] LinearReading holding_force() const {
        const Eigen::VectorXd& shares = scene().pull;
        if (shares.isZero(0.0)) return nothing();
        LinearReading reading = force(shares);
        reading.per_load_factor -= shares.dot(loads_on_prescribed(scene(), scene().unit_force));
        for (Eigen::Index k = 0; k < std::ssize(cases); ++k)
            reading.per_case[k] -= shares.dot(loads_on_prescribed(scene(), scene().case_forces[at(k)]));
        return reading;
    }

    /// Displacement of the whole mesh under a load with Gamma held.
    [[nodiscard]] Eigen::VectorXd gamma_held(const ReducedLoad& load, const LoadFactors& factors) const {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(scene().enriched.unknowns);
        u(numbering.unknowns()) = leaf.expand(load, Eigen::VectorXd::Zero(std::ssize(numbering.free_places())));
        impose(scene().prescribed, factors, u);
        return u;
    }

    /// Of a load case. Forces on prescribed unknowns are no load of the free ones: its own reduced load serves, where
    /// nothing is imposed.
    [[nodiscard]] WorkReadings work_of_case(Eigen::Index k) const {
        Eigen::VectorXd force = scene().case_forces[at(k)], imposed(std::ssize(scene().prescribed));
        for (std::size_t i = 0; i < scene().prescribed.size(); ++i) {
            imposed[static_cast<Eigen::Index>(i)] = scene().prescribed[i].in_case(k);
            force[scene().prescribed[i].unknown] = 0.0;
        }
        if (imposed.isZero(0.0)) return {displacement(cases[at(k)], force), nothing()};
        return {displacement(force), this->force(imposed)};
    }
};

}  // namespace

// Of imposed displacements the reactions do the work; loads on the same unknowns do none of their own.
CondensedLoads::CondensedLoads(const CoarseElements& elements, const LeafNumbering& numbering, const Substructure& leaf)
    : unit_(reduce_unit_load(elements, numbering, leaf)),
      initial_(reduce_initial_load(elements, numbering, leaf, unit_)), cases_(reduce_cases(elements, numbering, leaf)) {
    const Scene& scene = elements.scene();
    const Reader reader{elements, numbering, leaf, unit_, initial_, cases_};
    displacement_reading_ = reader.displacement(scene.displacement_weights);
    Eigen::VectorXd force = scene.unit_force, imposed(std::ssize(scene.prescribed));
    for (std::size_t k = 0; k < scene.prescribed.size(); ++k) {
        imposed[static_cast<Eigen::Index>(k)] = scene.prescribed[k].value;
        force[scene.prescribed[k].unknown] = 0.0;
    }
    const bool nothing_imposed = imposed.isZero(0.0);  // then the load is that of the forces alone
    work_.displacement = nothing_imposed ? reader.displacement(unit_, force) : reader.displacement(force);
    work_.imposed_force = nothing_imposed ? reader.nothing() : reader.force(imposed);
    holding_force_ = reader.holding_force();
    for (Eigen::Index k = 0; k < std::ssize(cases_); ++k) work_of_cases_.push_back(reader.work_of_case(k));
    unit_energy_ = work_.displacement.per_load_factor + work_.imposed_force.per_load_factor;
    initial_energy_ = elements.initial().energy - 0.5 * initial_.interior.squaredNorm();
}

// With the interior in equilibrium: u . K u = u_b . S u_b + 2 lambda m . u_b + lambda^2 e, where m, what imposed
// displacements pull at the free places u_b, is the reduced load less that of the forces alone. An initial stress does
// work on what Gamma and the supports move: minus g_0 . u_b, and lambda times the force that it needs to be held. What
// it has let go of inside, with Gamma held, is (1/2) f_0 . K^-1 f_0.
double CondensedLoads::stored_energy(const Eigen::MatrixXd& tangent, const Eigen::VectorXd& u,
                                     const LoadFactors& factors) const {
    const Eigen::VectorXd pull = work_.displacement.weights - unit_.boundary;
    const double lambda = factors.main;
    const double elastic = 0.5 * (u.dot(tangent * u) + lambda * (2.0 * pull.dot(u) + lambda * unit_energy_));
    return elastic + initial_energy_ - initial_.boundary.dot(u) + lambda * work_.imposed_force.constant +
           energy_of_cases(u, factors);
}

// What load cases add. The energy of a pair of unit loads, u_k . K u_j, is what the forces of j do on the displacement
// of k, and the imposed displacements of k against the reactions of j.
double CondensedLoads::energy_of_cases(const Eigen::VectorXd& u, const LoadFactors& factors) const {
    double energy = 0.0;
    for (Eigen::Index k = 0; k < std::ssize(cases_); ++k) {
        const double factor = factors.of_case(k);
        if (factor == 0.0) continue;
        const auto& [displacement, imposed] = work_of_cases_[at(k)];
        const Eigen::VectorXd pull = displacement.weights - cases_[at(k)].boundary;
        double pairs = factors.main * (work_.displacement.per_case[k] + imposed.per_load_factor);
        for (Eigen::Index j = 0; j < std::ssize(cases_); ++j)
            pairs += 0.5 * factors.of_case(j) * (work_of_cases_[at(j)].displacement.per_case[k] + imposed.per_case[j]);
        energy += factor * (pull.dot(u) + pairs + imposed.constant);
    }
    return energy;
}

}  // namespace stria::coarse
