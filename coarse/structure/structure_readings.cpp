// A structure's loads, condensed, and what a testing machine reads and does work on.
#include "coarse/structure/elastic_force.hpp"
#include "coarse/structure/structure.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {}  // namespace

void Structure::condense_loads() {
    Eigen::VectorXd imposed = Eigen::VectorXd::Zero(scene_.enriched.unknowns);
    for (const PrescribedUnknown& p : scene_.prescribed) imposed[p.unknown] = p.value;
    reduced_ = leaf_->reduce(gather(scene_.unit_force, leaf_unknowns_) + load_of_imposed(imposed));
    near_load_ = reduced_.interior.tail(reduced_.interior.size() - far_count_);
    condense_readings();
    find_near_supports();
}

/// What displacements of prescribed unknowns (of the whole mesh) do to the leaf's unknowns.
Eigen::VectorXd Structure::load_of_imposed(const Eigen::VectorXd& imposed) const {
    const MandelMatrix elastic = scene_.elastic.stiffness();
    Eigen::VectorXd load = Eigen::VectorXd::Zero(unknowns());
    for (const int element : supported_) {
        visit_operator(element, [&](const auto& op) {
            const auto reaction = (op.stiffness(elastic) * gather(imposed, op.unknowns)).eval();
            for (std::size_t i = 0; i < op.unknowns.size(); ++i) {
                const int row = leaf_index_[at(op.unknowns[i])];
                if (row >= 0) load[row] -= reaction[static_cast<Eigen::Index>(i)];
            }
        });
    }
    return load;
}

/// Linear in Gamma's displacement and the load factor: what they make of the latter is seen with Gamma held.
void Structure::condense_readings() {
    mean_displacement_ = displacement_of(scene_.mean_displacement);
    condense_energy();
    holding_force_.weights = Eigen::VectorXd::Zero(std::ssize(free_places_));
    if (!scene_.pull.isZero(0.0)) holding_force_ = force_of(scene_.pull);
}

/// Weights on all unknowns. Of K = L L^T in the interior, w . K^-1 f is the product of two reduced loads.
Controlled Structure::displacement_of(const Eigen::VectorXd& weights) const {
    const ReducedLoad reduced = leaf_->reduce(gather(weights, leaf_unknowns_));
    Controlled displacement{reduced.boundary, reduced.interior.dot(reduced_.interior)};
    for (const PrescribedUnknown& p : scene_.prescribed) displacement.per_load_factor += weights[p.unknown] * p.value;
    return displacement;
}

/// Shares of the forces on the prescribed unknowns, in their order, summed.
Controlled Structure::force_of(const Eigen::VectorXd& shares) const {
    Eigen::VectorXd moved = Eigen::VectorXd::Zero(scene_.enriched.unknowns);
    for (std::size_t k = 0; k < scene_.prescribed.size(); ++k)
        moved[scene_.prescribed[k].unknown] = shares[static_cast<Eigen::Index>(k)];
    const Eigen::VectorXd gamma_held = expand(Eigen::VectorXd::Zero(std::ssize(gamma_)), 1.0);
    return {leaf_->reduce(-load_of_imposed(moved)).boundary, shares.dot(forces_on_prescribed(gamma_held))};
}

// Of imposed displacements the reactions do the work; loads on the same unknowns do none of their own.
void Structure::condense_energy() {
    Eigen::VectorXd force = scene_.unit_force;
    Eigen::VectorXd imposed(std::ssize(scene_.prescribed));
    for (std::size_t k = 0; k < scene_.prescribed.size(); ++k) {
        imposed[static_cast<Eigen::Index>(k)] = scene_.prescribed[k].value;
        force[scene_.prescribed[k].unknown] = 0.0;
    }
    load_displacement_ = displacement_of(force);
    unit_energy_ = load_displacement_.per_load_factor;
    imposed_force_.weights = Eigen::VectorXd::Zero(std::ssize(free_places_));
    if (imposed.isZero(0.0)) return;
    imposed_force_ = force_of(imposed);
    unit_energy_ += imposed_force_.per_load_factor;
}

// With the interior in equilibrium: u . K u = u_b . S u_b + 2 lambda m . u_b + lambda^2 e, where m, what imposed
// displacements pull at the free places u_b, is the reduced load less that of the forces alone.
double Structure::stored_energy(const Eigen::VectorXd& gamma_displacement, double load_factor) const {
    const Eigen::VectorXd u = on_free_places(gamma_displacement);
    const Eigen::VectorXd pull = load_displacement_.weights - reduced_.boundary;
    return 0.5 * (u.dot(tangent() * u) + load_factor * (2.0 * pull.dot(u) + load_factor * unit_energy_));
}

Eigen::VectorXd Structure::forces_on_prescribed(const Eigen::VectorXd& u) const {
    std::vector<int> row(at(scene_.enriched.unknowns), -1);
    for (std::size_t k = 0; k < scene_.prescribed.size(); ++k)
        row[at(scene_.prescribed[k].unknown)] = static_cast<int>(k);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(std::ssize(scene_.prescribed));
    for (const int element : supported_) {
        visit_operator(element, [&](const auto& op) {
            const auto force = elastic_force(op, gather(u, op.unknowns), scene_.elastic.stiffness());
            for (std::size_t k = 0; k < op.unknowns.size(); ++k) {
                const int own = row[at(op.unknowns[k])];
                if (own >= 0) forces[own] += force[static_cast<Eigen::Index>(k)];
            }
        });
    }
    return forces;
}

}  // namespace stria::coarse
