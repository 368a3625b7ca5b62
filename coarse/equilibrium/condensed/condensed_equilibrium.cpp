#include "coarse/equilibrium/condensed/condensed_equilibrium.hpp"

#include <algorithm>
#include <utility>

#include "coarse/equilibrium/zone_residual.hpp"
#include "common/error.hpp"
#include "common/linear/lower_triangle.hpp"

namespace stria::coarse {
namespace {

double largest(const Eigen::VectorXd& v) { return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0; }

/// Of a symmetric sum the lower triangle: half of the way through memory.
template <class Zone> Eigen::MatrixXd sum_of(const Eigen::MatrixXd& structure, const Zone& zone, Symmetry symmetry) {
    const Eigen::Index n = structure.rows();
    Eigen::MatrixXd sum(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        const Eigen::Index rows = symmetry == Symmetry::Symmetric ? n - j : n;
        sum.col(j).tail(rows) = structure.col(j).tail(rows) + zone.col(j).tail(rows);
    }
    return sum;
}

}  // namespace

CondensedEquilibrium::CondensedEquilibrium(const Structure& structure, coupling::FineScale* fine,
                                           EquilibriumSections input, const Eigen::VectorXd& committed,
                                           const LoadFactors& factors)
    : structure_(structure), tolerance_(input.tolerance),
      largest_forces_(structure.scene(), structure.elements().initial().load), supports_(structure),
      states_({gather(committed, structure.gamma()), factors.main, factors.cases}, remembered_increments(input.steps)),
      zone_(fine, std::move(input.coupling)), expanded_(structure) {}

// Ends every change of the trial state.
void CondensedEquilibrium::impose_supports() {
    expanded_.forget();
    supports_.impose(states_.trial());
}

void CondensedEquilibrium::begin(const Target& target, const Predictor& predictor) {
    control_ = ControlEquation(target, structure_.loads(), std::ssize(structure_.free_places()));
    zone_.begin(predictor, target.held);
    factor_reuse_ = FactorReuse(tolerance_);
    near_wanted_ = false;
    states_.begin(predictor, target.cases);
    if (control_.is_load_factor()) states_.trial().load_factor = control_.load_factor(target.cases);
    impose_supports();
}

Residual CondensedEquilibrium::linearise() {
    const GammaState& trial = states_.trial();
    const Eigen::VectorXd u = structure_.on_free_places(trial.displacement);
    residual_ = structure_.boundary_load(trial.factors());
    off_target_ = control_.off_target(u, trial.factors());
    Residual result;
    result.scale = largest_forces_.under(trial.factors());
    result.target = control_.relative(off_target_, largest(trial.displacement), trial.load_factor);
    if (!zone_.exists()) return result;
    ask_zone(u);
    structure_residual_ = residual_;
    residual_ -= structure_.on_free_places(zone_.answer().force);
    result.boundary = largest(residual_);
    result.nodal = largest(structure_residual_ + structure_.on_free_places(zone_.answer().due));
    add_zone(result, zone_.answer());
    add_structure_work(result);
    expect_next(result);
    return result;
}

// `u`: the trial state on the free places. The structure's part needs no answer and is found meanwhile.
void CondensedEquilibrium::ask_zone(const Eigen::VectorXd& u) {
    zone_.ask(states_.trial(), [&] {
        residual_ -= times_lower(structure_.tangent(), u);
        if (near_wanted_) (void)near_displacement();
    });
}

// Whether the factor serves once more, and whether the next state may be the last: Newton's method squares what is
// left.
void CondensedEquilibrium::expect_next(const Residual& result) {
    factor_reuse_.add(result);
    zone_.settle_below(factor_reuse_.below(), result.scale * tolerance_);
    const double left = result.largest() / result.scale;
    near_wanted_ = result.keeps_factor || left * left <= 0.1 * tolerance_;
}

/// Of the residual, by the load factor: loads on both sides, less what the zone's held unknowns pull along.
Eigen::VectorXd CondensedEquilibrium::load_derivative() const {
    Eigen::VectorXd derivative =
        structure_.loads().unit().boundary + structure_.on_free_places(zone_.answer().unit_load);
    supports_.add_pull(zone_.tangent(), derivative);
    return derivative;
}

/// Of structure and zone, on the free places.
CondensedTangent CondensedEquilibrium::tangent() const {
    const std::vector<int>& free = structure_.free_places();  // ascending: a lower triangle stays one
    const auto& [zone, symmetry] = zone_.tangent();
    if (supports_.empty()) return {sum_of(structure_.tangent(), zone, symmetry), symmetry};
    return {sum_of(structure_.tangent(), zone(free, free), symmetry), symmetry};
}

double CondensedEquilibrium::solve() {
    if (!zone_.exists()) return 0.0;
    if (!zone_.has_new_tangent()) {
        ++work_.gamma_factors_reused;
    } else {
        ++work_.gamma_factored;
        system_.factor([this] { return tangent(); }, control_.controlled());
    }
    correction_ = system_.solve(residual_, off_target_, load_derivative(), control_.controlled());
    const Eigen::VectorXd& du = correction_.displacement;
    if (!du.allFinite())
        throw NumericalFailure("the tangent of the structure is singular: a part of the body moves freely");
    return largest(du) /
           std::max({largest(states_.trial().displacement), largest(du), zone_.answer().interior_displacement, 1e-300});
}

// Where the load factor is an unknown too, its equation has no part in any work.
void CondensedEquilibrium::add_structure_work(Residual& result) const {
    if (zone_.is_first_iterate() || !control_.is_load_factor()) {
        result.along = result.along_before = 0.0;
        return;
    }
    result.along += taken_.correction.displacement.dot(structure_residual_);
    result.along_before += taken_.work_before;
}

void CondensedEquilibrium::apply() {
    if (!zone_.exists()) return;
    taken_ = {correction_, correction_.displacement.dot(structure_residual_)};
    move(1.0, false);
}

void CondensedEquilibrium::apply_further(double part) {
    if (zone_.exists()) move(part, true);
}

void CondensedEquilibrium::move(double part, bool further) {
    GammaState& trial = states_.trial();
    trial.displacement(structure_.free_places()) += part * taken_.correction.displacement;
    trial.load_factor += part * taken_.correction.load_factor;
    zone_.move(part, further);
    impose_supports();
}

void CondensedEquilibrium::put_aside() {
    states_.put_aside();
    zone_.put_aside();
}

coupling::StepReport CondensedEquilibrium::commit(const coupling::Commit& what) {
    states_.commit();
    return zone_.commit(what);
}

void CondensedEquilibrium::rollback() {
    states_.rollback();
    expanded_.forget();
    zone_.rollback();
}

EquilibriumState CondensedEquilibrium::state() const {
    EquilibriumState state;
    state.load_factor = states_.committed().load_factor;
    state.cases = states_.committed().cases;
    state.displacement = states_.committed().displacement;
    for (const GammaState& increment : states_.increments()) {
        state.increments.push_back(increment.displacement);
        state.load_increments.push_back(increment.load_factor);
    }
    return state;
}

void CondensedEquilibrium::restore(const EquilibriumState& state) {
    std::deque<GammaState> increments;
    for (std::size_t k = 0; k < state.increments.size(); ++k)
        increments.push_back({state.increments[k], state.load_increments.at(k)});
    states_.restore({state.displacement, state.load_factor, state.cases}, increments);
    expanded_.forget();
}

CoarseEffort CondensedEquilibrium::effort() const {
    CoarseEffort effort = zone_.effort();
    effort.work += work_;
    effort.work += expanded_.work();
    return effort;
}

MachineReading CondensedEquilibrium::machine_reading() const {
    const LoadFactors factors = states_.trial().factors();
    const Eigen::VectorXd u = structure_.on_free_places(states_.trial().displacement);
    const CondensedLoads& loads = structure_.loads();
    MachineReading reading{loads.displacement_reading().at(u, factors), loads.holding_force().at(u, factors),
                           loads.work().imposed_force.at(u, factors),
                           Eigen::VectorXd::Zero(std::ssize(loads.work_of_cases()))};
    for (Eigen::Index k = 0; k < std::ssize(loads.work_of_cases()); ++k)
        reading.imposed_forces_of_cases[k] = loads.work_of_cases()[at(k)].imposed_force.at(u, factors);
    if (zone_.has_answered()) supports_.add_reactions(zone_.answer().force, reading);
    return reading;
}

}  // namespace stria::coarse
