#include "coarse/equilibrium/condensed_equilibrium.hpp"

#include <algorithm>
#include <utility>

#include "coarse/equilibrium/zone_residual.hpp"
#include "common/error.hpp"
#include "common/linear/dense_cholesky.hpp"
#include "common/stopwatch.hpp"

namespace stria::coarse {
namespace {

double largest(const Eigen::VectorXd& v) { return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0; }

}  // namespace

CondensedEquilibrium::CondensedEquilibrium(const Structure& structure, coupling::FineScale* fine,
                                           EquilibriumSections input, const Eigen::VectorXd& committed,
                                           double load_factor)
    : structure_(structure), scene_(structure.scene()), fine_(fine), input_(std::move(input)),
      largest_unit_force_(largest(scene_.unit_force)), committed_load_factor_(load_factor), load_factor_(load_factor),
      increments_(remembered_increments(input_.steps)), near_(Eigen::VectorXd::Zero(scene_.enriched.unknowns)) {
    committed_ = gather(committed, structure_.gamma());
    trial_ = committed_;
    for (std::size_t k = 0; k < scene_.prescribed.size(); ++k) {
        const auto& [unknown, value] = scene_.prescribed[k];
        const auto found = std::ranges::lower_bound(structure_.gamma(), unknown);
        if (found == structure_.gamma().end() || *found != unknown) continue;
        held_.emplace_back(found - structure_.gamma().begin(), value);
        pulled_.emplace_back(held_.back().first, scene_.pull[static_cast<Eigen::Index>(k)]);
    }
}

Eigen::VectorXd CondensedEquilibrium::on_free(const Eigen::VectorXd& gamma) const {
    return gather(gamma, structure_.free_places());
}

void CondensedEquilibrium::forget_expansions() {
    expanded_.reset();
    near_known_ = false;
}

// Ends every change of the trial state.
void CondensedEquilibrium::impose_held() {
    forget_expansions();
    for (const auto& [place, value] : held_) trial_[place] = load_factor_ * value;
}

void CondensedEquilibrium::begin(const Target& target, const Predictor& predictor) {
    const auto n = std::ssize(structure_.free_places());
    controlled_ =
        target.control == Control::Load ? LinearReading::load_factor(n) : structure_.loads().mean_displacement();
    target_ = target.value;
    predictor_ = predictor;
    iteration_ = 0;
    step_ = 1.0;
    held_faces_ = target.held;
    check_rest_ = false;
    near_wanted_ = false;
    settled_below_ = 0.0;
    trial_ = committed_;
    load_factor_ = committed_load_factor_;
    if (const Increment* earlier = increments_.find(predictor)) {
        trial_ += predictor.factor * earlier->displacement;
        load_factor_ += predictor.factor * earlier->load_factor;
    }
    if (controlled_.is_load_factor()) load_factor_ = target_ / controlled_.per_load_factor;
    impose_held();
}

Residual CondensedEquilibrium::linearise() {
    const Eigen::VectorXd u = on_free(trial_);
    residual_ = load_factor_ * structure_.loads().unit().boundary;
    off_target_ = target_ - controlled_.at(u, load_factor_);
    Residual result;
    result.scale = std::abs(load_factor_) * largest_unit_force_;
    result.target = std::abs(off_target_) / std::max({std::abs(target_), largest(trial_), 1e-300});
    if (fine_ == nullptr) return result;
    {
        const Stopwatch watch(effort_.exchange_s);
        fine_->request({.iteration = iteration_,
                        .predictor = predictor_,
                        .load_factor = load_factor_,
                        .step = step_,
                        .held = held_faces_,
                        .settled_below = settled_below_,
                        .check_rest = check_rest_,
                        .boundary = trial_});
        check_rest_ = false;
        // Meanwhile the structure's part, which needs no answer.
        residual_ -= structure_.tangent() * u;
        if (near_wanted_) (void)near_displacement();
        response_ = fine_->collect();
        if (input_.coupling.state == "newton") (void)fine_->state();  // the user pays for seeing every iterate cross
    }
    if (!response_.same_tangent) zone_tangent_ = std::move(response_.tangent);
    residual_ -= on_free(response_.force);
    result.boundary = largest(residual_);
    add_zone(result, response_);
    // A factor serves twice, not for ever: the second correction in a row would gain less and less.
    const double tolerance = input_.tolerance, left = result.largest() / result.scale;
    settled_below_ = response_.same_tangent ? 0.0 : tolerance * result.scale;
    near_wanted_ = left * left <= 0.1 * tolerance;  // Newton's method squares what is left
    return result;
}

/// Of the residual, by the load factor: loads on both sides, less what the zone's held unknowns pull along.
Eigen::VectorXd CondensedEquilibrium::load_derivative() const {
    Eigen::VectorXd derivative = structure_.loads().unit().boundary + on_free(response_.unit_load);
    for (const auto& [place, value] : held_)
        if (value != 0.0) derivative -= value * on_free(zone_tangent_.matrix.col(place));
    return derivative;
}

// A du - b dlambda = R and w . du + k dlambda = r. At a limit load A is singular along what is controlled: sigma w
// times the second equation, added to the first, makes it definite again and changes no solution. (Load control: w = 0,
// k = 1.)
void CondensedEquilibrium::factor_tangent() {
    ++effort_.work.gamma_factored;
    const Eigen::MatrixXd tangent = bordered_tangent();
    definite_ = zone_tangent_.symmetry == Symmetry::Symmetric && factor_.factor(tangent);
    if (!definite_) general_factor_.compute(tangent);
}

Eigen::MatrixXd CondensedEquilibrium::bordered_tangent() {
    const std::vector<int>& free = structure_.free_places();
    Eigen::MatrixXd bordered = structure_.tangent();
    if (held_.empty())
        bordered += zone_tangent_.matrix;
    else
        bordered += zone_tangent_.matrix(free, free);
    const Eigen::VectorXd& w = controlled_.weights;
    sigma_ = controlled_.is_load_factor() ? 0.0 : bordered.diagonal().mean() / w.squaredNorm();
    if (sigma_ != 0.0) bordered.noalias() += sigma_ * w * w.transpose();
    return bordered;
}

double CondensedEquilibrium::solve() {
    if (fine_ == nullptr) return 0.0;
    const auto& [w, k] = controlled_;
    if (response_.same_tangent)
        ++effort_.work.gamma_factors_reused;
    else
        factor_tangent();
    const double sigma = sigma_;
    Eigen::MatrixXd right(w.size(), 2);
    right << residual_ + sigma * off_target_ * w, load_derivative() - sigma * k * w;
    const Eigen::MatrixXd x = definite_ ? factor_.solve(right) : Eigen::MatrixXd(general_factor_.solve(right));
    load_correction_ = (off_target_ - w.dot(x.col(0))) / (k + w.dot(x.col(1)));
    correction_ = x.col(0) + load_correction_ * x.col(1);
    if (!correction_.allFinite())
        throw NumericalFailure("the tangent of the structure is singular: a part of the body moves freely");
    return largest(correction_) /
           std::max({largest(trial_), largest(correction_), response_.interior_displacement, 1e-300});
}

void CondensedEquilibrium::apply(double step) {
    if (fine_ == nullptr) return;
    for (std::size_t k = 0; k < structure_.free_places().size(); ++k)
        trial_[structure_.free_places()[k]] += step * correction_[static_cast<Eigen::Index>(k)];
    load_factor_ += step * load_correction_;
    step_ = step;
    impose_held();
    ++iteration_;
}

void CondensedEquilibrium::begin_commit(bool reversal) {
    if (fine_ != nullptr) fine_->begin_commit(reversal);
}

coupling::StepReport CondensedEquilibrium::commit(bool reversal) {
    increments_.push({trial_ - committed_, load_factor_ - committed_load_factor_});
    committed_ = trial_;
    committed_load_factor_ = load_factor_;
    if (fine_ == nullptr) return {};
    const Stopwatch watch(effort_.exchange_s);
    coupling::StepReport report = fine_->commit(reversal);
    if (input_.coupling.state == "auto")
        ++effort_.work.states_not_sent;
    else
        (void)fine_->state();
    return report;
}

void CondensedEquilibrium::rollback() {
    trial_ = committed_;
    load_factor_ = committed_load_factor_;
    forget_expansions();
    if (fine_ != nullptr) fine_->rollback();
}

EquilibriumState CondensedEquilibrium::state() const {
    EquilibriumState state;
    state.load_factor = committed_load_factor_;
    state.displacement = committed_;
    for (const Increment& increment : increments_.all()) {
        state.increments.push_back(increment.displacement);
        state.load_increments.push_back(increment.load_factor);
    }
    return state;
}

void CondensedEquilibrium::restore(const EquilibriumState& state) {
    committed_ = trial_ = state.displacement;
    committed_load_factor_ = load_factor_ = state.load_factor;
    expanded_.reset();
    increments_.clear();
    for (std::size_t back = state.increments.size(); back-- > 0;)
        increments_.push({state.increments[back], state.load_increments.at(back)});
}

Eigen::VectorXd CondensedEquilibrium::structure_displacement() const {
    if (!expanded_) {
        expanded_ = structure_.expand(trial_, load_factor_);
        ++effort_.work.structure_solves_full;
    }
    return *expanded_;
}

const Eigen::VectorXd& CondensedEquilibrium::near_displacement() const {
    if (!near_known_) {
        structure_.expand_near(trial_, load_factor_, near_);
        ++effort_.work.structure_solves_near;
    }
    near_known_ = true;
    return near_;
}

MachineReading CondensedEquilibrium::machine_reading() const {
    const Eigen::VectorXd u = on_free(trial_);
    const CondensedLoads& loads = structure_.loads();
    MachineReading reading{loads.mean_displacement().at(u, load_factor_), loads.holding_force().at(u, load_factor_),
                           loads.imposed_force().at(u, load_factor_)};
    if (fine_ == nullptr) return reading;
    for (const auto& [place, share] : pulled_) reading.force += share * response_.force[place];
    for (const auto& [place, value] : held_) reading.imposed_force += value * response_.force[place];
    return reading;
}

}  // namespace stria::coarse
