#include "fine/zone/fine_model.hpp"

#include <algorithm>
#include <utility>

#include "common/index.hpp"
#include "common/stopwatch.hpp"
#include "fine/zone/right_hand_side.hpp"
#include "fine/zone/tree_layout.hpp"

namespace stria::fine {
FineModel::FineModel(const ZoneSections& input) : system_(input) {}

// After elements were split another zone follows.
void FineModel::set_patch(const coupling::Patch& patch) {
    if (patch.anew) {  // its counts go on
        work_ += system_.work();
        system_ = ZoneSystem(system_.sections());
    }
    tree_.turn_to(system_.set_patch(patch));
    rest_is_due_ = true;
    if (patch.part_of.empty()) begin_rest(true);
}

Eigen::MatrixXd FineModel::increments() {
    const std::deque<ZoneUnknowns>& known = system_.increments();
    Eigen::MatrixXd increments(system_.patch().mesh.unknowns, std::ssize(known));
    for (std::size_t k = 0; k < known.size(); ++k) increments.col(static_cast<Eigen::Index>(k)) = known[k].displacement;
    return increments;
}

void FineModel::request(const coupling::PatchDisplacement& displacement) {
    if (displacement.wanted != Wanted::Rest) asked_ = displacement;
    asked_.wanted = displacement.wanted;
    asked_.keeps_factor = displacement.keeps_factor;
}

coupling::PatchResponse FineModel::collect() {
    if (asked_.wanted != Wanted::Rest) evaluate();
    if (asked_.wanted == Wanted::Residuals) return response_;
    condense(response_);
    return std::move(response_);
}

void FineModel::evaluate() {
    begin_rest_where_due();
    if (asked_.iteration == 0) {
        if (asked_.put_aside) system_.put_aside();
        system_.predict(asked_.predictor);
        correction_ = {};
    } else {
        if (!asked_.further) correct();
        system_.move(asked_.step * correction_.displacement, asked_.step * correction_.traction);
    }
    system_.bear({asked_.load_factor, asked_.cases, asked_.held, asked_.elastic});
    system_.set_boundary(asked_.boundary);
    // New faces send the stress where no half cycle before has sent it: every iterate looks at what rests.
    const bool opens = system_.opens_faces() || asked_.opens_faces;
    const bool looked = some_rest_ && opens && asked_.iteration > 0 && !asked_.elastic;
    if (looked) (void)wake_what_would_yield();
    linearise();
    response_ = system_.measure();
    const bool unseen = some_rest_ && !looked;
    response_.provisional = unseen && !is_time_to_check_rest(response_);
    if (unseen && !response_.provisional) {
        const bool woken = wake_what_would_yield();
        if (woken) {
            linearise();
            response_ = system_.measure();
        } else {
            system_.measure_faces(response_.digest);
        }
        response_.woken = woken;
    }
    response_.along = work_along_correction();
    response_.along_before = correction_.work_before;
    response_.may_keep_factor = may_keep_factor();
    response_.opens_faces = system_.opens_faces();
    response_.due = gather(system_.load(), system_.patch().boundary);
}

void FineModel::linearise() {
    system_.linearise();
    if (some_rest_) system_.add_response(tree_.fronts().response(system_.moved_since_rest()));
    tree_.find_changes();
}

// Subtrees of elements that may rest become leaves: their points and fronts are not looked at any more, until one
// would yield.
void FineModel::begin_rest(bool after_patch) {
    rest_is_due_ = false;
    tree_.plant_where_due();
    const Resting may_rest = system_.may_rest();
    some_rest_ = !may_rest.elements.none();
    FrontTree& fronts = tree_.fronts();
    if (!some_rest_ && !fronts.resting().none()) fronts.rest(ElementSet(tree_.changed().size()));
    if (!some_rest_) return;
    if (tree_.is_new() || after_patch) {
        tree_.find_changes();
        tree_.factor();
    }
    ElementSet still = tree_.ids_of(may_rest);
    for (const int id : tree_.changed().members()) still.erase(id);
    fronts.rest(still);
    system_.rest(tree_.resting(), fronts.inside());
    fronts.carry(system_.rest_load());
}

// Not before it is asked for: a growth, which may come first, wakes all.
void FineModel::begin_rest_where_due() {
    if (rest_is_due_) begin_rest(false);
}

// As a snapshot has it. Where the tree is another one, what does not fill a subtree of it is awake.
void FineModel::rest_again(const coupling::ZoneSnapshot& snapshot) {
    Resting still{ElementSet::of_flags({snapshot.resting.begin(), snapshot.resting.end()}),
                  MultiplierSet(snapshot.multipliers.size())};
    for (std::size_t k = 0; k < snapshot.multipliers.size(); ++k)
        if (snapshot.multipliers[k].resting != 0) still.multipliers.insert(k);
    const ElementSet ids = tree_.ids_of(still);
    some_rest_ = !ids.none();
    if (!some_rest_) return;
    tree_.find_changes();
    tree_.factor();
    wake_all_but(ids);
}

void FineModel::wake_all_but(const ElementSet& still) {
    FrontTree& fronts = tree_.fronts();
    fronts.rest(still);
    system_.wake_all_but(tree_.resting(), fronts.inside());
    fronts.carry(system_.rest_load());
}

// Where this may be the last iterate: generously, for the structure, which decides, knows larger forces too. It asks
// where it is taken by surprise.
bool FineModel::is_time_to_check_rest(const coupling::PatchResponse& response) const {
    constexpr double margin = 10.0;
    if (asked_.elastic) return false;
    const double residual = std::max(response.interior_residual, response.contact_residual);
    return asked_.check_rest ||
           residual <= margin * std::max(system_.tolerance() * response.interior_force, asked_.last_below);
}

// True where something has been woken: then the trial state is to be evaluated again. Where nothing has moved yet there
// is nothing to see: what lies on the yield surface would flow by what the last increment has left out of balance.
bool FineModel::wake_what_would_yield() {
    const Eigen::VectorXd moved = system_.moved_since_rest();
    if (moved.isZero(0.0)) return false;
    const Restless restless = system_.follow(tree_.fronts().follow(moved));
    if (restless.elements.empty() && restless.multipliers.empty()) return false;
    Resting still = tree_.resting();
    const int before = still.elements.count();
    for (const int e : restless.elements) still.elements.erase(e);
    for (const int k : restless.multipliers) still.multipliers.erase(k);
    wake_all_but(tree_.ids_of(still));
    work_.elements_woken += before - tree_.resting().elements.count();
    return true;
}

bool FineModel::may_keep_factor() const { return !tree_.is_new() && !tree_.some_status_changed(); }

// One of several ranks does as all do, but where none of its tangents has changed.
bool FineModel::keeps_factor() const {
    if (asked_.wanted == Wanted::Rest) return asked_.keeps_factor || (!tree_.is_new() && tree_.changed().none());
    return response_.may_keep_factor && asked_.settled_below > 0.0 &&
           std::max(response_.interior_residual, response_.contact_residual) <= asked_.settled_below;
}

void FineModel::condense(coupling::PatchResponse& response) {
    const Stopwatch watch(factor_s_);
    const FrontTree& fronts = tree_.fronts();
    response.keeps_factor = response.same_tangent = keeps_factor();
    if (response.same_tangent) {
        ++work_.factors_reused;
    } else {
        tree_.factor();
        response.tangent = {fronts.lower_tangent(), fronts.symmetry()};
    }
    reduced_ = fronts.reduce(right_hand_side_of(system_));
    response.force = -reduced_.boundary;
    response.unit_load = Eigen::VectorXd::Zero(reduced_.boundary.size());
    reduced_unit_ = {Eigen::VectorXd::Zero(reduced_.interior.size()), response.unit_load};
    if (system_.patch().unit_load.isZero(0.0)) return;
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(reduced_.interior.size() + reduced_.boundary.size());
    unit.head(system_.patch().unit_load.size()) = system_.patch().unit_load;
    reduced_unit_ = fronts.reduce(unit);
    response.unit_load = reduced_unit_.boundary;
}

// The interior's share of Newton's correction.
void FineModel::correct() {
    const Eigen::VectorXd step = asked_.boundary - gather(system_.displacement(), system_.patch().boundary);
    const double load_step = asked_.load_factor - system_.load_factor();
    const ReducedLoad moving{reduced_.interior + load_step * reduced_unit_.interior, reduced_.boundary};
    const Eigen::VectorXd whole = tree_.fronts().expand(moving, step);
    correction_.displacement = whole.head(system_.displacement().size());
    correction_.traction = whole.tail(system_.traction().size());
    correction_.work_before = work_along_correction();
}

// What rests follows the others: nothing is out of balance inside it.
double FineModel::work_along_correction() const {
    const Eigen::VectorXd& move = correction_.displacement;
    const UnknownSet& resting = tree_.fronts().inside();
    double work = 0.0;
    for (Eigen::Index i = 0; i < move.size(); ++i)
        if (!resting.contains(i)) work += system_.load()[i] * move[i];
    return work;
}

coupling::StepReport FineModel::commit(const coupling::Commit& what) {
    coupling::StepReport report = system_.commit(what);
    if (what.reversal) {
        system_.wake_all();
        rest_is_due_ = true;
    }
    report.factor_s = factor_s_;
    report.work += work_;
    report.work += tree_.work();
    return report;
}

coupling::ZoneState FineModel::state() { return system_.state(); }

coupling::ZoneSnapshot FineModel::snapshot() {
    begin_rest_where_due();
    return system_.snapshot();
}

void FineModel::restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) {
    system_.restore(patch, snapshot);
    rest_is_due_ = false;
    tree_.plant();
    rest_again(snapshot);
}

}  // namespace stria::fine
