#include "fine/bulk/bulk.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/error.hpp"
#include "common/integration/moment_fit.hpp"
#include "fine/bulk/history_rows.hpp"

namespace stria::fine {

Bulk::Bulk(const EnrichedMesh& mesh, const Materials& materials, MaterialLaws laws, const IntegrationRule& rule,
           Bulk* old, const Eigen::VectorXd& displacement)
    : Bulk(BulkElements(mesh, materials, rule, old != nullptr ? &old->elements_ : nullptr), std::move(laws),
           displacement, old) {
    if (old != nullptr)
        carry_history(*old);
    else
        for (int e = 0; e < elements_.count(); ++e) begin_elastic(e);
    history_.rollback();
    settle();
}

Bulk::Bulk(const EnrichedMesh& mesh, const Materials& materials, MaterialLaws laws, const IntegrationRule& rule,
           const coupling::ZoneSnapshot& snapshot)
    : Bulk(BulkElements(mesh, materials, rule,
                        [&, rows = histories_of_elements(snapshot)](int e, const CrackPiece*) {
                            return points_of(snapshot, rows.at(at(e)));
                        }),
           std::move(laws), snapshot.displacement) {
    require(snapshot.element == mesh.element_ids, "a snapshot has the elements of its zone, in its order");
    read_rows(snapshot, operators(), history_);
    history_.set_half_cycle_ended(snapshot.half_cycle_ended);
    history_.rollback();
    settle();
    ElementSet resting(elements_.count());
    for (int e = 0; e < elements_.count(); ++e) {
        resting_.set_recent_flow(e, snapshot.recent_flow[at(e)]);
        if (snapshot.resting[at(e)] != 0) resting.insert(e);
    }
    rest(resting, snapshot.rest_displacement);
}

Bulk::Bulk(BulkElements elements, MaterialLaws laws, const Eigen::VectorXd& displacement, const Bulk* old)
    : elements_(std::move(elements)), history_(std::move(laws), elements_.mesh().material, operators()),
      resting_(elements_, displacement), proven_(elements_.count(), true),  // no force is known yet
      committed_force_(operators()), trial_force_(operators()), committed_u_(displacement), trial_u_(displacement),
      increment_(Eigen::VectorXd::Zero(elements_.mesh().unknowns)), force_(increment_), force_scale_(increment_),
      tangents_(at(elements_.count())), changed_(elements_.count(), true),
      yielded_(elements_.count()), counts_{.elements_built = elements_.built()} {
    bound_.reserve(operators());
    for (int e = 0; e < elements_.count(); ++e) {
        if (old != nullptr && elements_.has_stayed(e))
            bound_.add_element_of(old->bound_, elements_.was(e), elements_.op(e));
        else
            bound_.add_element(elements_.op(e), VonMisesForm(elements_.elastic_stiffness(e)));
    }
}

// As a bulk that begins: every tangent is elastic.
void Bulk::move_tips(std::vector<Tip> tips) {
    elements_.move_tips(std::move(tips));
    changed_ = std::exchange(yielded_, ElementSet(elements_.count()));
}

void Bulk::remember(coupling::ZoneSnapshot& out) const {
    out.element = elements_.mesh().element_ids;
    out.rank.assign(out.element.size(), 0);
    for (const ElementOperator& op : operators()) out.points.push_back(static_cast<std::int32_t>(op.points.size()));
    write_rows(operators(), history_, out);
    out.half_cycle_ended = history_.half_cycle_ended();
    out.recent_flow = resting_.recent_flow();
    for (int e = 0; e < elements_.count(); ++e) out.resting.push_back(resting_.contains(e) ? 1 : 0);
    out.rest_displacement = resting_.displacement();
}

void Bulk::begin_elastic(int e) {
    const ElementOperator& op = elements_.op(e);
    const Eigen::VectorXd u = gather(committed_u_, op.unknowns);
    for (std::size_t q = 0; q < op.points.size(); ++q)
        history_.begin(e, q, op.strain(u, q), elements_.initial_stress(e, op.points[q].x));
}

void Bulk::carry_history(const Bulk& old) {
    counts_ += old.counts();
    history_.set_half_cycle_ended(old.history_.half_cycle_ended());
    carry_stayed(old);
    for (int e = 0; e < elements_.count(); ++e) {
        if (elements_.has_stayed(e)) continue;
        const std::optional<int> found = old.elements_.find(elements_.mesh(), e);
        if (found) resting_.set_recent_flow(e, old.resting_.recent_flow()[at(*found)]);
        if (found)
            mix_history(old, *found, e);
        else
            begin_elastic(e);
    }
}

// In as long blocks as there are. The forces of what has stayed are known.
void Bulk::carry_stayed(const Bulk& old) {
    for (int begin = 0, end = 0; begin < elements_.count(); begin = std::max(end, begin + 1)) {
        const int was = elements_.was(begin);
        for (end = begin; end < elements_.count() && was >= 0 && elements_.was(end) == was + end - begin; ++end) {
            const int own = elements_.was(end);
            resting_.set_recent_flow(end, old.resting_.recent_flow()[at(own)]);
            trial_force_.of(end) = old.committed_force_.of(own);
            proven_.erase(end);
        }
        if (end > begin) history_.take(begin, end, old.history_, was);
    }
}

// Old points come first and in their order; one that is new has a mean history of those around it on its side. What
// the functions no longer say of the displacement's gradient is kept beside them.
void Bulk::mix_history(const Bulk& old, int old_element, int element) {
    constexpr double rounding = 1e-14;
    const ElementOperator &before = old.elements_.op(old_element), &now = elements_.op(element);
    const Eigen::VectorXd old_u = gather(old.committed_u_, before.unknowns), u = gather(committed_u_, now.unknowns);
    for (std::size_t q = 0; q < now.points.size(); ++q) {
        Eigen::Matrix2d untold = -now.displacement_gradient(u, q);
        for (const auto& [from, share] : history_of(now.points, q, before.points)) {
            history_.add_share(element, q, share, old.history_, old_element, from);
            untold += share * old.gradient(old_element, from, old_u);
        }
        if (history_.has_frozen_gradients() || untold.cwiseAbs().maxCoeff() >= rounding)
            history_.freeze_gradient(element, q, untold);
    }
}

Eigen::Matrix2d Bulk::gradient(int e, std::size_t q, const Eigen::VectorXd& element_u) const {
    return elements_.op(e).displacement_gradient(element_u, q) + history_.frozen_gradient(e, q);
}

void Bulk::evaluate(const Eigen::VectorXd& u, bool elastic) {
    trial_u_ = u;
    increment_ = u - committed_u_;
    for (const int e : resting_.awake()) {
        if (!elastic && !bound_.proves(e, increment_)) {
            proven_.erase(e);
            continue;
        }
        proven_.insert(e);
        with_kernel(elements_.op(e), [&](const auto& kernel) { find_elastic_force(e, kernel); });
    }
    update_points(false);
    force_.setZero();
    force_scale_.setZero();
    counts_.points_at_rest += history_.points();
    for (const int e : resting_.awake()) {
        counts_.points_at_rest -= history_.points(e);
        with_kernel(elements_.op(e), [&](const auto& kernel) {
            find_trial_force(e, kernel);
            add_trial_force(e);
            find_tangent(e, kernel);
        });
    }
}

template <class Kernel> void Bulk::find_elastic_force(int e, const Kernel& kernel) {
    const auto force = kernel.elastic_force(elements_.stiffness()[at(e)], increment_);
    const auto committed = committed_force_.of(e);
    auto trial = trial_force_.of(e);
    for (Eigen::Index k = 0; k < trial.size(); ++k) trial[k] = committed[k] + force.data()[k];
}

// In as long blocks as there are.
void Bulk::update_points(bool proven) {
    int begin = 0, end = 0;
    for (const int e : resting_.awake()) {
        if (proven_.contains(e) != proven) continue;
        if (e != end) history_.update(operators(), std::exchange(begin, e), end, increment_);
        end = e + 1;
    }
    history_.update(operators(), begin, end, increment_);
}

template <class Kernel> void Bulk::find_trial_force(int e, const Kernel& kernel) {
    if (proven_.contains(e)) {
        history_.set_elastic(e);
        counts_.points_proven_elastic += history_.points(e);
        return;
    }
    const auto force = kernel.force(history_.trial_stresses(e), history_.points());
    std::copy_n(force.data(), force.size(), trial_force_.of(e).data());
}

void Bulk::add_trial_force(int e) {
    const auto force = trial_force_.of(e);
    const std::vector<int>& unknowns = elements_.op(e).unknowns;
    for (Eigen::Index k = 0; k < force.size(); ++k) {
        force_[unknowns[at(k)]] += force[k];
        force_scale_[unknowns[at(k)]] += std::abs(force[k]);
    }
}

// The elastic matrix plus what yielding takes away at the points that yield, but for idle ones.
template <class Kernel> void Bulk::find_tangent(int e, const Kernel& kernel) {
    const bool yields = history_.yields(e), yielded = yielded_.contains(e);
    if (yields || yielded)
        changed_.insert(e);
    else
        changed_.erase(e);
    if (!yields) {
        yielded_.erase(e);
        ++counts_.elastic_tangents_reused;
        return;
    }
    yielded_.insert(e);
    ++counts_.tangents_computed;
    typename Kernel::Matrix K = elements_.stiffness()[at(e)];
    for (std::size_t q = 0; q < at(history_.points(e)); ++q)
        if (history_.yields(e, q) && !idle_.contain(e, elements_.op(e).points[q]))
            kernel.add_stiffness(history_.tangent(e, q) - elements_.elastic_stiffness(e), q, K);
    tangents_[at(e)] = K;
}

void Bulk::commit(bool reversal, bool counts) {
    update_points(true);
    history_.commit(reversal, resting_.elements());
    committed_u_ = trial_u_;
    increment_.setZero();
    settle();
    if (reversal && counts) resting_.note_half_cycle(history_);
}

// Where the points were not looked at before the commit, the forces are now those of their stresses.
void Bulk::settle() {
    for (const int e : proven_.members()) find_committed_force(e);
    proven_ = ElementSet(elements_.count());
    committed_force_ = trial_force_;
    for (const int e : resting_.awake()) bound_.set_margin(e, history_.elastic_margin(e));
}

void Bulk::find_committed_force(int e) {
    with_kernel(elements_.op(e), [&](const auto& kernel) {
        const auto force = kernel.force(history_.stresses(e), history_.points());
        std::copy_n(force.data(), force.size(), trial_force_.of(e).data());
    });
}

Mandel Bulk::trial_stress(int e, std::size_t q) const {
    if (!proven_.contains(e)) return history_.trial_stress(e, q);
    const ElementOperator& op = elements_.op(e);
    return history_.stress(e, q) + elements_.elastic_stiffness(e) * op.strain(gather(increment_, op.unknowns), q);
}

std::vector<Bulk::PointState> Bulk::committed_states(int e) const {
    std::vector<PointState> states;
    for_each_committed_state(e, [&](std::size_t, const PointState& state) { states.push_back(state); });
    return states;
}

ElementSet Bulk::may_rest() const { return resting_.may_rest(elements_, history_, yielded_); }

void Bulk::rest(const ElementSet& elements, const Eigen::VectorXd& displacement) {
    resting_.rest(elements, displacement, bound_);
    for (const int e : elements.members()) {
        proven_.erase(e);
        changed_.erase(e);
        yielded_.erase(e);
        history_.set_elastic(e);
    }
}

Eigen::VectorXd Bulk::rest_load() const {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(elements_.mesh().unknowns);
    for (const int e : resting_.elements().members()) {
        const double* force = committed_force_.of(e).data();
        for (const int unknown : elements_.op(e).unknowns) load[unknown] -= *force++;
    }
    return load;
}

std::vector<int> Bulk::would_yield(const Eigen::VectorXd& u) {
    trial_u_ = u;  // what rests has followed since evaluate()
    return resting_.would_yield(u, elements_, history_, bound_);
}

void Bulk::wake_all_but(const ElementSet& still) {
    const Eigen::VectorXd moved = committed_u_ - resting_.displacement();
    ElementSet waking = resting_.elements();
    for (const int e : still.members()) waking.erase(e);
    for_each_run(waking, true, [&](int begin, int end) {
        history_.update(operators(), begin, end, moved);
        history_.commit(begin, end);
    });
    resting_.wake(waking);
    for (const int e : waking.members()) {
        find_committed_force(e);
        committed_force_.of(e) = trial_force_.of(e);
        bound_.set_margin(e, history_.elastic_margin(e));
    }
}

coupling::WorkCounts Bulk::counts() const {
    return counts_ + coupling::WorkCounts{.points_evaluated = history_.evaluated()};
}

}  // namespace stria::fine
