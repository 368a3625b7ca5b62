#include "fine/bulk/bulk.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/error.hpp"
#include "common/integration/moment_fit.hpp"
#include "fine/bulk/points/history_rows.hpp"

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
    for (int e = 0; e < elements_.count(); ++e)
        if (!elements_.has_stayed(e)) stand_.stand_at(e, gather(e, committed_u_), elements_, history_);
}

Bulk::Bulk(const EnrichedMesh& mesh, const Materials& materials, MaterialLaws laws, const IntegrationRule& rule,
           const coupling::ZoneSnapshot& snapshot)
    : Bulk(BulkElements(mesh, materials, rule,
                        [&, rows = histories_of_elements(snapshot)](int e, const CrackPiece*) {
                            return points_of(snapshot, rows.at(at(e)));
                        }),
           std::move(laws), snapshot.displacement) {
    require(std::ranges::equal(snapshot.element, mesh.element_ids),
            "a snapshot has the elements of its zone, in its order");
    read_rows(snapshot, operators(), history_);
    history_.set_half_cycle_ended(snapshot.half_cycle_ended);
    history_.rollback();
    const double* stand = snapshot.stand.data();
    ElementSet resting(elements_.count());
    for (int e = 0; e < elements_.count(); ++e) {
        const auto unknowns = std::ssize(elements_.op(e).unknowns);
        require(snapshot.unknowns[at(e)] == unknowns, "a snapshot has the unknowns of its elements");
        stand_.stand_at(e, Eigen::Map<const Eigen::VectorXd>(stand, unknowns), elements_, history_);
        stand += unknowns;
        resting_.set_recent_flow(e, snapshot.recent_flow[at(e)]);
        if (snapshot.resting[at(e)] != 0) resting.insert(e);
    }
    rest(resting, snapshot.rest_displacement);
}

Bulk::Bulk(BulkElements elements, MaterialLaws laws, const Eigen::VectorXd& displacement, const Bulk* old)
    : elements_(std::move(elements)), history_(std::move(laws), elements_.mesh().material, operators()),
      resting_(elements_, displacement), stand_(elements_, old != nullptr ? &old->stand_ : nullptr),
      proven_(elements_.count(), true), trial_force_(operators()), committed_u_(displacement), trial_u_(displacement),
      increment_(Eigen::VectorXd::Zero(elements_.mesh().unknowns)), force_(increment_), force_scale_(increment_),
      tangents_(at(elements_.count())), changed_(elements_.count(), true),
      softened_(elements_.count()), counts_{.elements_built = elements_.built()} {}

// As a bulk that begins: every tangent is elastic.
void Bulk::move_tips(std::vector<Tip> tips) {
    elements_.move_tips(std::move(tips));
    changed_ = std::exchange(softened_, ElementSet(elements_.count()));
}

void Bulk::remember(coupling::ZoneSnapshot& out) const {
    out.element = elements_.mesh().element_ids.copy();
    out.rank.assign(out.element.size(), 0);
    for (const ElementOperator& op : operators()) out.points.push_back(static_cast<std::int32_t>(op.points.size()));
    write_rows(operators(), history_, out);
    out.half_cycle_ended = history_.half_cycle_ended();
    out.recent_flow = resting_.recent_flow();
    for (int e = 0; e < elements_.count(); ++e) {
        out.resting.push_back(resting_.contains(e) ? 1 : 0);
        out.unknowns.push_back(static_cast<std::int32_t>(std::ssize(elements_.op(e).unknowns)));
        const auto stand = stand_.displacement(e);
        out.stand.insert(out.stand.end(), stand.begin(), stand.end());
    }
    out.rest_displacement = resting_.displacement();
}

void Bulk::begin_elastic(int e) {
    const ElementOperator& op = elements_.op(e);
    const Eigen::VectorXd u = gather(e, committed_u_);
    for (std::size_t q = 0; q < op.points.size(); ++q)
        history_.begin(e, q, op.strain(u, q), elements_.initial_stress(e, op.points[q].x));
}

void Bulk::carry_history(Bulk& old) {
    history_.set_half_cycle_ended(old.history_.half_cycle_ended());
    carry_stayed(old);
    for (int e = 0; e < elements_.count(); ++e) {
        if (elements_.has_stayed(e)) continue;
        const std::optional<int> found = old.elements_.find(elements_.mesh(), e);
        if (!found || !elements_.materials().may_yield()) {
            begin_elastic(e);
            continue;
        }
        resting_.set_recent_flow(e, old.resting_.recent_flow()[at(*found)]);
        old.stand_.bring_to(*found, old.committed_u_, old.elements_, old.history_);
        mix_history(old, *found, e);
    }
    counts_ += old.counts();
}

// In as long blocks as there are.
void Bulk::carry_stayed(const Bulk& old) {
    for (int begin = 0, end = 0; begin < elements_.count(); begin = std::max(end, begin + 1)) {
        const int was = elements_.was(begin);
        for (end = begin; end < elements_.count() && was >= 0 && elements_.was(end) == was + end - begin; ++end) {
            const int own = elements_.was(end);
            resting_.set_recent_flow(end, old.resting_.recent_flow()[at(own)]);
        }
        if (end > begin) history_.take(begin, end, old.history_, was);
    }
}

// Old points come first and in their order; one that is new has a mean history of those around it on its side. What
// the functions no longer say of the displacement's gradient is kept beside them.
void Bulk::mix_history(const Bulk& old, int old_element, int element) {
    constexpr double rounding = 1e-14;
    const ElementOperator &before = old.elements_.op(old_element), &now = elements_.op(element);
    const Eigen::VectorXd old_u = old.gather(old_element, old.committed_u_), u = gather(element, committed_u_);
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

// Points that will soon have to be looked at are so now, once and not in each iteration of the next increment.
void Bulk::commit(bool reversal, bool counts) {
    constexpr double soon = 0.5;  // of the way to the yield surface
    ElementSet untouched = resting_.elements();
    untouched |= proven_;
    history_.commit(reversal, untouched);
    committed_u_ = trial_u_;
    increment_.setZero();
    for (const int e : resting_.awake()) {
        if (!proven_.contains(e)) {
            stand_.stand_at(e, gather(e, committed_u_), elements_, history_);
        } else if (!stand_.proves_at(e, committed_u_, soon)) {
            stand_.bring_to(e, committed_u_, elements_, history_);
            proven_.erase(e);
        }
    }
    if (reversal && counts) resting_.note_half_cycle(history_);
}

double Bulk::stored_ahead_of_points(int e) const { return stand_.stored(e, standing_displacement(e), elements_); }

Mandel Bulk::trial_stress(int e, std::size_t q) const {
    if (!proven_.contains(e)) return history_.trial_stress(e, q);
    return history_.stress(e, q) +
           elements_.elastic_stiffness(e) * elements_.op(e).strain(stand_.ahead(elements_.op(e), e, trial_u_), q);
}

std::vector<Bulk::PointState> Bulk::committed_states(int e, EnergyDensity density) const {
    std::vector<PointState> states;
    for_each_committed_state(e, density, [&](std::size_t, const PointState& state) { states.push_back(state); });
    return states;
}

ElementSet Bulk::may_rest() const { return resting_.may_rest(elements_, history_, softened_); }

void Bulk::rest(const ElementSet& elements, const Eigen::VectorXd& displacement) {
    resting_.rest(elements, displacement);
    for (const int e : elements.members()) {
        stand_.find_force(e, displacement, elements_, trial_force_);
        proven_.erase(e);
        changed_.erase(e);
        softened_.erase(e);
        history_.set_elastic(e);
    }
}

Eigen::VectorXd Bulk::rest_load() const {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(elements_.mesh().unknowns);
    for (const int e : resting_.elements().members()) {
        const double* force = trial_force_.of(e).data();
        for (const int unknown : elements_.op(e).unknowns) load[unknown] -= *force++;
    }
    return load;
}

std::vector<int> Bulk::would_yield(const Eigen::VectorXd& u) {
    trial_u_ = u;  // what rests has followed since evaluate()
    std::vector<int> found;
    for (int e = 0; e < elements_.count(); ++e)
        if (resting_.contains(e) && stand_.would_yield_at(e, u, elements_, history_)) found.push_back(e);
    return found;
}

// As in a run that is resumed, where no looks are known.
void Bulk::wake_all_but(const ElementSet& still) {
    ElementSet waking = resting_.elements();
    for (const int e : still.members()) waking.erase(e);
    resting_.wake(waking);
    proven_ |= waking;
    for (const int e : waking.members()) stand_.look_back(e, history_);
}

coupling::WorkCounts Bulk::counts() const {
    return counts_ + coupling::WorkCounts{.points_evaluated = history_.evaluated()};
}

}  // namespace stria::fine
