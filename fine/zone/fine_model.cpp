#include "fine/zone/fine_model.hpp"

#include <algorithm>
#include <utility>

#include "common/index.hpp"
#include "common/stopwatch.hpp"
#include "fine/zone/right_hand_side.hpp"
#include "fine/zone/tree_layout.hpp"

namespace stria::fine {
FineModel::FineModel(const ZoneSections& input) : system_(input) {}

void FineModel::set_patch(const coupling::Patch& patch) {
    const std::vector<Vec2> busy = tree_ ? busy_places(system_.patch().mesh) : std::vector<Vec2>();
    const bool stays = system_.set_patch(patch);
    if (!stays || busy != busy_places(patch.mesh)) plant_tree();
    begin_rest(true);
}

Eigen::MatrixXd FineModel::increments() {
    const std::deque<ZoneUnknowns>& known = system_.increments();
    Eigen::MatrixXd increments(system_.patch().mesh.unknowns, std::ssize(known));
    for (std::size_t k = 0; k < known.size(); ++k) increments.col(static_cast<Eigen::Index>(k)) = known[k].displacement;
    return increments;
}

void FineModel::plant_tree() {
    const ContactInterface& contact = system_.contact();
    tree_ = std::make_unique<FrontTree>(layout_of_tree(system_));
    changed_ = ElementSet(system_.bulk().elements().count() + contact.multipliers(), true);
    all_changed_ = true;
    in_tree_.assign(at(contact.multipliers()), none);
    multiplier_matrices_.resize(in_tree_.size());
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
        rest_was_checked_ = false;
        correction_ = {};
    } else {
        if (!asked_.further) correct();
        system_.move(asked_.step * correction_.displacement, asked_.step * correction_.traction);
    }
    system_.set_held(asked_.held);
    system_.set_elastic(asked_.elastic);
    system_.set_load_factor(asked_.load_factor);
    system_.set_cases(asked_.cases);
    system_.set_boundary(asked_.boundary);
    // New faces send the stress where no half cycle before has sent it: every iterate looks at what rests.
    const bool looked = some_rest_ && system_.opens_faces() && asked_.iteration > 0;
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
    if (system_.patch().shared) response_.due = gather(system_.load(), system_.patch().boundary);
}

void FineModel::linearise() {
    system_.linearise();
    if (some_rest_) system_.add_response(tree_->response(system_.moved_since_rest()));
    find_changes();
}

// Subtrees of elements that may rest become leaves: their points and fronts are not looked at any more, until one
// would yield.
void FineModel::begin_rest(bool after_patch) {
    rest_is_due_ = false;
    const Resting may_rest = system_.may_rest();
    some_rest_ = !may_rest.elements.none();
    if (!some_rest_ && !tree_->resting().none()) tree_->rest(ElementSet(changed_.size()));
    if (!some_rest_) return;
    if (all_changed_ || after_patch) {
        find_changes();
        factor();
    }
    ElementSet in_tree(changed_.size());
    const auto add = [&](int element) {
        if (!changed_.contains(element)) in_tree.insert(element);
    };
    for (const int e : may_rest.elements.members()) add(e);
    for (const int k : may_rest.multipliers.members()) add(may_rest.elements.size() + k);
    tree_->rest(in_tree);
    system_.rest(resting(), tree_->inside());
    tree_->carry(system_.rest_load());
}

// Not before it is asked for: a growth, which may come first, wakes all.
void FineModel::begin_rest_where_due() {
    if (rest_is_due_) begin_rest(false);
}

// As a snapshot has it. Where the tree is another one, what does not fill a subtree of it is awake.
void FineModel::rest_again(const coupling::ZoneSnapshot& snapshot) {
    ElementSet in_tree(changed_.size());
    for (std::size_t e = 0; e < snapshot.resting.size(); ++e)
        if (snapshot.resting[e] != 0) in_tree.insert(e);
    for (std::size_t k = 0; k < snapshot.multipliers.size(); ++k)
        if (snapshot.multipliers[k].resting != 0) in_tree.insert(snapshot.resting.size() + k);
    some_rest_ = !in_tree.none();
    if (!some_rest_) return;
    find_changes();
    factor();
    wake_all_but(in_tree);
}

// The tree's elements are those of the bulk, then the multipliers.
Resting FineModel::resting() const {
    const int elements = system_.bulk().elements().count();
    Resting resting{ElementSet(elements), MultiplierSet(system_.contact().multipliers())};
    for (const int id : tree_->resting().members()) {
        if (id < elements)
            resting.elements.insert(id);
        else
            resting.multipliers.insert(id - elements);
    }
    return resting;
}

void FineModel::wake_all_but(const ElementSet& still) {
    tree_->rest(still);
    system_.wake_all_but(resting(), tree_->inside());
    tree_->carry(system_.rest_load());
}

// Once as soon as the state is roughly known, so that what is woken has iterations to come; and where this may be the
// last one: generously, for the structure, which decides, knows larger forces too. It asks where it is taken by
// surprise.
bool FineModel::is_time_to_check_rest(const coupling::PatchResponse& response) const {
    constexpr double roughly = 1e-2, margin = 10.0;
    const double residual = std::max(response.interior_residual, response.contact_residual);
    if (asked_.elastic) return false;
    const bool last = residual <= margin * std::max(system_.tolerance() * response.interior_force, asked_.last_below);
    const bool early = !rest_was_checked_ && asked_.iteration > 0 && response.digest.status_changes == 0 &&
                       residual <= roughly * response.interior_force;
    return asked_.check_rest || last || early;
}

// True where something has been woken: then the trial state is to be evaluated again.
bool FineModel::wake_what_would_yield() {
    rest_was_checked_ = true;
    const Restless restless = system_.follow(tree_->follow(system_.moved_since_rest()));
    if (restless.elements.empty() && restless.multipliers.empty()) return false;
    const int before = resting().elements.count();
    ElementSet still = tree_->resting();
    for (const int e : restless.elements) still.erase(e);
    for (const int k : restless.multipliers) still.erase(system_.bulk().elements().count() + k);
    wake_all_but(still);
    work_.elements_woken += before - resting().elements.count();
    return true;
}

// What differs from the last factor: tangents of elements, and multipliers whose status has changed.
void FineModel::find_changes() {
    const ElementSet& changed = system_.bulk().changed();
    for (int e = 0; e < changed.size(); ++e)
        if (changed.contains(e)) changed_.insert(e);
    const std::vector<FaceStatus>& statuses = system_.contact().statuses();
    for (std::size_t k = 0; k < statuses.size(); ++k) {
        if (in_tree_[k] == statuses[k]) continue;
        in_tree_[k] = statuses[k];
        multiplier_matrices_[k] = system_.contact().matrix_of(static_cast<int>(k));
        changed_.insert(at(changed.size()) + k);
    }
}

bool FineModel::may_keep_factor() const {
    const std::vector<char>& flags = changed_.flags();
    const auto first_multiplier = flags.end() - std::ssize(in_tree_);
    return !all_changed_ && std::find(first_multiplier, flags.end(), 1) == flags.end();
}

// One of several ranks does as all do, but where none of its tangents has changed.
bool FineModel::keeps_factor() const {
    if (asked_.wanted == Wanted::Rest) return asked_.keeps_factor || (!all_changed_ && changed_.none());
    return response_.may_keep_factor && asked_.settled_below > 0.0 &&
           std::max(response_.interior_residual, response_.contact_residual) <= asked_.settled_below;
}

void FineModel::factor() {
    if (all_changed_) changed_ = ElementSet(changed_.size(), true);
    const std::span<const Eigen::MatrixXd> tangents = system_.bulk().tangents();
    const long before = tree_->refactored(), general_before = tree_->refactored_general();
    tree_->factor(
        [&](int element) {
            const auto e = at(element);
            if (e < tangents.size()) return FrontTree::ElementMatrix{tangents[e]};
            const std::size_t k = e - tangents.size();
            return FrontTree::ElementMatrix{multiplier_matrices_[k],
                                            slides(in_tree_[k]) ? Symmetry::General : Symmetry::Symmetric};
        },
        changed_.flags());
    const long refactored = tree_->refactored() - before;
    work_.fronts_refactored += refactored;
    work_.fronts_general += tree_->refactored_general() - general_before;
    work_.fronts_kept += tree_->fronts() - refactored;
    changed_ = ElementSet(changed_.size());
    all_changed_ = false;
}

void FineModel::condense(coupling::PatchResponse& response) {
    const Stopwatch watch(factor_s_);
    response.keeps_factor = response.same_tangent = keeps_factor();
    if (response.same_tangent) {
        ++work_.factors_reused;
    } else {
        factor();
        const bool half = system_.patch().shared;  // half of a symmetric one is enough for who merges ranks
        response.tangent = {half ? tree_->lower_tangent() : tree_->tangent(), tree_->symmetry()};
    }
    reduced_ = tree_->reduce(right_hand_side_of(system_));
    response.force = -reduced_.boundary;
    response.unit_load = Eigen::VectorXd::Zero(reduced_.boundary.size());
    reduced_unit_ = {Eigen::VectorXd::Zero(reduced_.interior.size()), response.unit_load};
    if (system_.patch().unit_load.isZero(0.0)) return;
    Eigen::VectorXd unit = Eigen::VectorXd::Zero(reduced_.interior.size() + reduced_.boundary.size());
    unit.head(system_.patch().unit_load.size()) = system_.patch().unit_load;
    reduced_unit_ = tree_->reduce(unit);
    response.unit_load = reduced_unit_.boundary;
}

// The interior's share of Newton's correction.
void FineModel::correct() {
    const Eigen::VectorXd step = asked_.boundary - gather(system_.displacement(), system_.patch().boundary);
    const double load_step = asked_.load_factor - system_.load_factor();
    const ReducedLoad moving{reduced_.interior + load_step * reduced_unit_.interior, reduced_.boundary};
    const Eigen::VectorXd whole = tree_->expand(moving, step);
    correction_.displacement = whole.head(system_.displacement().size());
    correction_.traction = whole.tail(system_.traction().size());
    correction_.work_before = work_along_correction();
}

// What rests follows the others: nothing is out of balance inside it.
double FineModel::work_along_correction() const {
    const Eigen::VectorXd& move = correction_.displacement;
    const UnknownSet& resting = tree_->inside();
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
    plant_tree();
    rest_again(snapshot);
}

}  // namespace stria::fine
