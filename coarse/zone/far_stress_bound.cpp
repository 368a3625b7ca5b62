#include "coarse/zone/far_stress_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coarse/zone/structure_stresses.hpp"

namespace stria::coarse {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double worth_a_mode = 0.01;       // what a remainder adds to the stress
constexpr std::ptrdiff_t most_states = 24;  // then all but the pivot is learnt anew

}  // namespace

FarStressBound::FarStressBound(const Structure& structure)
    : structure_(&structure), far_(structure.factors().far), affine_(structure.scene().initial_stress().any()),
      response_(largest_far_response(structure)) {
    const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(std::ssize(structure.gamma()));
    for (Eigen::Index k = 0; k < std::ssize(structure.loads().cases()); ++k) {
        const Eigen::VectorXd u = structure.expand(at_rest, LoadFactors::of_one_case(k));
        pivots_of_cases_.push_back(
            {gather(u, structure.rim()), largest_far_stress(structure, u, StressPart::OfDisplacement)});
    }
}

bool FarStressBound::turn_to(const Structure& structure) {
    if (structure.factors().far != far_) return false;
    structure_ = &structure;
    return true;
}

/// Coordinates of a state; leaves its remainder in `displacement`. Twice over the modes, so that rounding of the first
/// pass does not stay in it.
FarStressBound::Coordinates FarStressBound::resolve(Eigen::VectorXd& displacement, const LoadFactors& factors) const {
    Coordinates place{factors, std::vector<double>(modes_.size(), 0.0), 0.0};
    if (factors.main != 0.0) displacement -= factors.main * pivot_;
    for (std::size_t k = 0; k < pivots_of_cases_.size(); ++k)
        displacement -= factors.of_case(static_cast<Eigen::Index>(k)) * pivots_of_cases_[k].displacement;
    for (int pass = 0; pass < 2; ++pass) {
        for (std::size_t k = 0; k < modes_.size(); ++k) {
            const double more = modes_[k].far_force.dot(displacement);
            place.along[k] += more;
            displacement -= more * modes_[k].displacement;
        }
    }
    place.remainder = stress_of(displacement);
    return place;
}

double FarStressBound::stress_of(const Eigen::VectorXd& remainder) const {
    const double twice_energy = remainder.dot(structure_->far_force(remainder));
    return std::sqrt(response_ * std::max(0.0, twice_energy));
}

double FarStressBound::bound_beside(const Known& known, double scale, const Coordinates& place) const {
    double bound = std::abs(scale) * (known.largest_stress + known.place.remainder) + place.remainder +
                   std::abs(place.factors.main - scale * known.place.factors.main) * pivot_stress_;
    for (std::size_t k = 0; k < pivots_of_cases_.size(); ++k) {
        const auto of = static_cast<Eigen::Index>(k);
        bound += std::abs(place.factors.of_case(of) - scale * known.place.factors.of_case(of)) *
                 pivots_of_cases_[k].largest_stress;
    }
    for (std::size_t k = 0; k < modes_.size(); ++k) {
        const double there = k < known.place.along.size() ? known.place.along[k] : 0.0;
        bound += std::abs(place.along[k] - scale * there) * modes_[k].largest_stress;
    }
    return bound;
}

double FarStressBound::at(const Eigen::VectorXd& rim_displacement, const LoadFactors& factors) const {
    if (response_ == 0.0) return 0.0;
    const double load_factor = factors.main;
    if (load_factor != 0.0 && pivot_.size() == 0) return infinite;
    Eigen::VectorXd remainder = rim_displacement;
    const Coordinates place = resolve(remainder, factors);
    double bound = affine_ ? infinite : bound_beside({}, 0.0, place);
    for (const Known& known : known_) {
        if (affine_ || !pivots_of_cases_.empty()) bound = std::min(bound, bound_beside(known, 1.0, place));
        if (affine_) continue;
        const bool loaded = known.place.factors.main != 0.0;
        if (!loaded && load_factor != 0.0) continue;
        bound = std::min(bound, bound_beside(known, loaded ? load_factor / known.place.factors.main : 1.0, place));
    }
    return bound;
}

double FarStressBound::stress_of_mode(const Eigen::VectorXd& displacement) const {
    return largest_far_stress(*structure_, structure_->expand_far(displacement), StressPart::OfDisplacement);
}

void FarStressBound::learn_pivot(const Eigen::VectorXd& rim_displacement, double largest_stress) {
    pivot_ = rim_displacement;
    pivot_stress_ = largest_stress;
}

void FarStressBound::learn(const Eigen::VectorXd& rim_displacement, const LoadFactors& factors, double largest_stress) {
    const double load_factor = factors.main;
    if (load_factor != 0.0 && pivot_.size() == 0) {
        const bool alone = factors.cases.isZero(0.0);
        if (!affine_ && alone) learn_pivot(rim_displacement / load_factor, largest_stress / std::abs(load_factor));
        return;
    }
    if (std::ssize(known_) == most_states) {
        modes_.clear();
        known_.clear();
    }
    Eigen::VectorXd remainder = rim_displacement;
    Coordinates place = resolve(remainder, factors);
    if (place.remainder > worth_a_mode * largest_stress) {
        Eigen::VectorXd force = structure_->far_force(remainder);
        const double norm = std::sqrt(remainder.dot(force));
        remainder /= norm;
        force /= norm;
        const double stress = stress_of_mode(remainder);
        modes_.push_back({std::move(remainder), std::move(force), stress});
        place.along.push_back(norm);
        place.remainder = 0.0;
    }
    known_.push_back({std::move(place), largest_stress});
}

}  // namespace stria::coarse
