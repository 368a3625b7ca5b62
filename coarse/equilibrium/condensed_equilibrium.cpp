#include "coarse/equilibrium/condensed_equilibrium.hpp"

#include <algorithm>
#include <utility>

#include "coarse/equilibrium/zone_residual.hpp"
#include "common/error.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {
namespace {

double largest(const Eigen::VectorXd& v) { return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0; }

}  // namespace

CondensedEquilibrium::CondensedEquilibrium(const Structure& structure, coupling::FineScale* fine,
                                           EquilibriumSections input, const Eigen::VectorXd& committed,
                                           const LoadFactors& factors)
    : structure_(structure), fine_(fine), input_(std::move(input)),
      largest_unit_force_(largest(structure.scene().unit_force)),
      largest_initial_force_(largest(structure.elements().initial().load)), committed_{gather(committed,
                                                                                              structure.gamma()),
                                                                                       factors.main, factors.cases},
      trial_(committed_), increments_(remembered_increments(input_.steps)), expanded_(structure) {
    const Scene& scene = structure.scene();
    for (const Eigen::VectorXd& force : scene.case_forces) largest_case_forces_.push_back(largest(force));
    for (std::size_t k = 0; k < scene.prescribed.size(); ++k) {
        const PrescribedUnknown& prescribed = scene.prescribed[k];
        const auto found = std::ranges::lower_bound(structure.gamma(), prescribed.unknown);
        if (found == structure.gamma().end() || *found != prescribed.unknown) continue;
        held_.push_back({found - structure.gamma().begin(), &prescribed, scene.pull[static_cast<Eigen::Index>(k)]});
    }
}

Eigen::VectorXd CondensedEquilibrium::on_free(const Eigen::VectorXd& gamma) const {
    return gather(gamma, structure_.free_places());
}

// Ends every change of the trial state.
void CondensedEquilibrium::impose_held() {
    expanded_.forget();
    for (const Held& held : held_) trial_.displacement[held.place] = held.prescribed->under(trial_.factors());
}

void CondensedEquilibrium::begin(const Target& target, const Predictor& predictor) {
    const auto n = std::ssize(structure_.free_places());
    controlled_ =
        target.control == Control::Load ? LinearReading::load_factor(n) : structure_.loads().mean_displacement();
    target_ = target.value;
    request_ = {
        .predictor = predictor, .put_aside = std::exchange(put_aside_, false), .held = target.held, .boundary = {}};
    factor_reuse_ = FactorReuse(input_.tolerance);
    near_wanted_ = false;
    if (!predictor.goes_on) trial_ = committed_;
    if (const GammaState* earlier = increments_.find(predictor)) {
        trial_.displacement += predictor.factor * earlier->displacement;
        trial_.load_factor += predictor.factor * earlier->load_factor;
    }
    trial_.cases = target.cases;
    if (controlled_.is_load_factor()) {
        const LoadFactors rest(0.0, target.cases);
        trial_.load_factor = (target_ - controlled_.at(Eigen::VectorXd::Zero(n), rest)) / controlled_.per_load_factor;
    }
    impose_held();
}

double CondensedEquilibrium::largest_applied_force() const {
    double force = std::max(std::abs(trial_.load_factor) * largest_unit_force_, largest_initial_force_);
    for (std::size_t k = 0; k < largest_case_forces_.size(); ++k)
        force =
            std::max(force, std::abs(trial_.factors().of_case(static_cast<Eigen::Index>(k))) * largest_case_forces_[k]);
    return force;
}

Residual CondensedEquilibrium::linearise() {
    const Eigen::VectorXd u = on_free(trial_.displacement);
    residual_ = structure_.boundary_load(trial_.factors());
    off_target_ = target_ - controlled_.at(u, trial_.factors());
    Residual result;
    result.scale = largest_applied_force();
    result.target =
        std::abs(off_target_) / std::max({std::abs(target_), largest(trial_.displacement),
                                          std::abs(controlled_.per_load_factor * trial_.load_factor), 1e-300});
    if (fine_ == nullptr) return result;
    ask_zone(u);
    if (!response_.same_tangent) {
        zone_tangent_ = std::move(response_.tangent);
        factor_is_due_ = true;
    }
    structure_residual_ = residual_;
    residual_ -= on_free(response_.force);
    result.boundary = largest(residual_);
    result.nodal = largest(structure_residual_ + on_free(response_.due));
    add_zone(result, response_);
    add_structure_work(result);
    const double tolerance = input_.tolerance, left = result.largest() / result.scale;
    factor_reuse_.add(result);
    request_.settled_below = factor_reuse_.below();
    request_.last_below = result.scale * tolerance;
    // Newton's method squares what is left.
    near_wanted_ = result.keeps_factor || left * left <= 0.1 * tolerance;
    return result;
}

// `u`: the trial state on the free places. The structure's part needs no answer and is found meanwhile.
void CondensedEquilibrium::ask_zone(const Eigen::VectorXd& u) {
    const Stopwatch watch(effort_.exchange_s);
    request_.load_factor = trial_.load_factor;
    request_.cases = trial_.cases;
    request_.boundary = trial_.displacement;
    fine_->request(request_);
    request_.check_rest = false;
    residual_ -= structure_.tangent() * u;
    if (near_wanted_) (void)near_displacement();
    response_ = fine_->collect();
    if (input_.coupling.state == "newton") (void)fine_->state();  // the user pays for seeing every iterate cross
}

/// Of the residual, by the load factor: loads on both sides, less what the zone's held unknowns pull along.
Eigen::VectorXd CondensedEquilibrium::load_derivative() const {
    Eigen::VectorXd derivative = structure_.loads().unit().boundary + on_free(response_.unit_load);
    for (const Held& held : held_)
        if (const double value = held.prescribed->value; value != 0.0)
            derivative -= value * on_free(zone_tangent_.matrix.col(held.place));
    return derivative;
}

/// Of structure and zone, on the free places.
Eigen::MatrixXd CondensedEquilibrium::tangent() const {
    const std::vector<int>& free = structure_.free_places();
    if (held_.empty()) return structure_.tangent() + zone_tangent_.matrix;
    return structure_.tangent() + zone_tangent_.matrix(free, free);
}

double CondensedEquilibrium::solve() {
    if (fine_ == nullptr) return 0.0;
    if (!std::exchange(factor_is_due_, false)) {
        ++effort_.work.gamma_factors_reused;
    } else {
        ++effort_.work.gamma_factored;
        system_.factor([this] { return tangent(); }, zone_tangent_.symmetry, controlled_);
    }
    correction_ = system_.solve(residual_, off_target_, load_derivative(), controlled_);
    const Eigen::VectorXd& du = correction_.displacement;
    if (!du.allFinite())
        throw NumericalFailure("the tangent of the structure is singular: a part of the body moves freely");
    return largest(du) / std::max({largest(trial_.displacement), largest(du), response_.interior_displacement, 1e-300});
}

// Where the load factor is an unknown too, its equation has no part in any work.
void CondensedEquilibrium::add_structure_work(Residual& result) const {
    if (request_.iteration == 0 || !controlled_.is_load_factor()) {
        result.along = result.along_before = 0.0;
        return;
    }
    result.along += taken_.correction.displacement.dot(structure_residual_);
    result.along_before += taken_.work_before;
}

void CondensedEquilibrium::apply() {
    if (fine_ == nullptr) return;
    taken_ = {correction_, correction_.displacement.dot(structure_residual_)};
    move(1.0);
    request_.further = false;
}

void CondensedEquilibrium::apply_further(double part) {
    if (fine_ == nullptr) return;
    move(part);
    request_.further = true;
}

void CondensedEquilibrium::move(double part) {
    const std::vector<int>& free = structure_.free_places();
    trial_.displacement(free) += part * taken_.correction.displacement;
    trial_.load_factor += part * taken_.correction.load_factor;
    request_.step = part;
    impose_held();
    ++request_.iteration;
}

void CondensedEquilibrium::put_aside() {
    increments_.put_aside({trial_.displacement - committed_.displacement, trial_.load_factor - committed_.load_factor});
    put_aside_ = true;
}

void CondensedEquilibrium::begin_commit(const coupling::Commit& what) {
    if (fine_ != nullptr) fine_->begin_commit(what);
}

coupling::StepReport CondensedEquilibrium::commit(const coupling::Commit& what) {
    increments_.push({trial_.displacement - committed_.displacement, trial_.load_factor - committed_.load_factor});
    committed_ = trial_;
    if (fine_ == nullptr) return {};
    const Stopwatch watch(effort_.exchange_s);
    coupling::StepReport report = fine_->commit(what);
    if (input_.coupling.state == "auto")
        ++effort_.work.states_not_sent;
    else
        (void)fine_->state();
    return report;
}

void CondensedEquilibrium::rollback() {
    trial_ = committed_;
    expanded_.forget();
    if (fine_ != nullptr) fine_->rollback();
}

EquilibriumState CondensedEquilibrium::state() const {
    EquilibriumState state;
    state.load_factor = committed_.load_factor;
    state.cases = committed_.cases;
    state.displacement = committed_.displacement;
    for (const GammaState& increment : increments_.all()) {
        state.increments.push_back(increment.displacement);
        state.load_increments.push_back(increment.load_factor);
    }
    return state;
}

void CondensedEquilibrium::restore(const EquilibriumState& state) {
    committed_ = trial_ = {state.displacement, state.load_factor, state.cases};
    expanded_.forget();
    increments_.clear();
    for (std::size_t back = state.increments.size(); back-- > 0;)
        increments_.push({state.increments[back], state.load_increments.at(back)});
}

CoarseEffort CondensedEquilibrium::effort() const {
    CoarseEffort effort = effort_;
    effort.work += expanded_.work();
    return effort;
}

MachineReading CondensedEquilibrium::machine_reading() const {
    const Eigen::VectorXd u = on_free(trial_.displacement);
    const CondensedLoads& loads = structure_.loads();
    const LoadFactors factors = trial_.factors();
    MachineReading reading{loads.mean_displacement().at(u, factors), loads.holding_force().at(u, factors),
                           loads.work().imposed_force.at(u, factors),
                           Eigen::VectorXd::Zero(std::ssize(loads.work_of_cases()))};
    Eigen::VectorXd& of_cases = reading.imposed_forces_of_cases;
    for (Eigen::Index k = 0; k < of_cases.size(); ++k)
        of_cases[k] = loads.work_of_cases()[at(k)].imposed_force.at(u, factors);
    const bool has_answered = fine_ != nullptr && response_.force.size() > 0;  // not where the first iterate has failed
    if (!has_answered) return reading;
    for (const auto& [place, prescribed, share] : held_) {
        reading.force += share * response_.force[place];
        reading.imposed_force += prescribed->value * response_.force[place];
        for (Eigen::Index k = 0; k < std::ssize(prescribed->in_cases); ++k)
            of_cases[k] += prescribed->in_case(k) * response_.force[place];
    }
    return reading;
}

}  // namespace stria::coarse
