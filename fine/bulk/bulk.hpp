// The bulk of the zone under plasticity: internal forces and tangents of its elements, committed and trial.
#pragma once

#include <memory>
#include <vector>

#include "common/index_set.hpp"
#include "coupling/work_counts.hpp"
#include "coupling/zone_snapshot.hpp"
#include "fine/bulk/bulk_elements.hpp"
#include "fine/bulk/points/element_kernels.hpp"
#include "fine/bulk/points/element_values.hpp"
#include "fine/bulk/points/point_history.hpp"
#include "fine/bulk/resting_elements.hpp"
#include "fine/bulk/standing_points.hpp"

namespace stria::fine {

/// What J takes for W. A tip that stands: the stress work so far, the potential of metal that has only been loaded. A
/// tip that has grown: the elastic energy. Its wake is full of what loops have dissipated, and J of a ring that holds
/// wake would be less by what growth dissipates per mm. With the elastic energy J is the same on all contours between
/// which plastic strain does not change along the tip (docs/equations.md).
enum class EnergyDensity { StressWork, Elastic };

/// A point yields where its trial increment meets the yield criterion; it is plastic where it has yielded before.
/// Displacements are those of all unknowns of the mesh, mm; forces on them are per thickness, N/mm.
/// Points are moved only where they might flow (StandingPoints).
class Bulk {
public:
    /// Elements that `old` (may be null) holds too keep their points, with weights fitted anew where the crack has
    /// newly cut them, and the points' states; the others start from the initial stress + C eps(displacement)
    /// (docs/equations.md, growth). `displacement`: committed. `laws`: one per material. `old` is of no more use
    /// afterwards: its operators are taken over.
    Bulk(const EnrichedMesh& mesh, const Materials& materials, MaterialLaws laws, const IntegrationRule& rule,
         Bulk* old, const Eigen::VectorXd& displacement);

    /// As a snapshot has it, which holds all elements of the mesh, its displacement among it. Throws std::logic_error
    /// where it does not.
    Bulk(const EnrichedMesh& mesh, const Materials& materials, MaterialLaws laws, const IntegrationRule& rule,
         const coupling::ZoneSnapshot& snapshot);

    /// The same elements on which tips have moved on (same_but_for_tips()). None may rest. changed(): those whose
    /// tangent was not elastic.
    void move_tips(std::vector<Tip> tips);

    /// Writes all that is committed, but for the displacements.
    void remember(coupling::ZoneSnapshot& out) const;

    /// Stresses, internal forces and tangents at committed state + (u - committed u). Repeatable: same u, same bits.
    /// `elastic`: as if no point flowed. Elements that flow by less than `slight`, a plastic strain, keep their elastic
    /// tangent.
    void evaluate(const Eigen::VectorXd& u, bool elastic = false, double slight = 0.0);
    /// The same of some of the elements, where they are not at rest; `u` differs from what has been evaluated in
    /// unknowns of no others. The sums over elements stay until sum_forces().
    void evaluate_again(const std::vector<int>& elements, const Eigen::VectorXd& u);
    void sum_forces();

    /// Trial becomes committed. `reversal`: with this increment a half cycle ends; plastic extents start anew after it.
    /// `counts`: as one of the load's, which tells what will flow the next time.
    void commit(bool reversal, bool counts = true);

    [[nodiscard]] const BulkElements& elements() const { return elements_; }
    [[nodiscard]] const std::vector<ElementOperator>& operators() const { return elements_.operators(); }
    [[nodiscard]] const PointHistory& history() const { return history_; }
    [[nodiscard]] const RestingElements& resting() const { return resting_; }
    [[nodiscard]] const StandingPoints& standing() const { return stand_; }

    [[nodiscard]] const Eigen::VectorXd& committed_displacement() const { return committed_u_; }
    [[nodiscard]] const Eigen::VectorXd& internal_force() const { return force_; }
    /// Sum over elements of |nodal force|, per unknown: the scale against which a residual is small.
    [[nodiscard]] const Eigen::VectorXd& force_scale() const { return force_scale_; }
    /// Of an element, in the order of its unknowns.
    [[nodiscard]] auto trial_force(int e) const { return trial_force_.of(e); }
    /// Of an element, 2f x 2f where it has f functions.
    [[nodiscard]] const Eigen::MatrixXd& tangent(int e) const {
        return softened_.contains(e) ? tangents_[at(e)] : elements_.stiffness()[at(e)];
    }
    /// Elements whose tangent is not their elastic matrix.
    [[nodiscard]] const ElementSet& softened() const { return softened_; }
    /// Elements whose tangent differs from that of the evaluation before.
    [[nodiscard]] const ElementSet& changed() const { return changed_; }

    /// The last commit has moved the points of an element.
    [[nodiscard]] bool has_new_points(int e) const { return !proven_.contains(e) && !resting_.contains(e); }
    /// What it has stored from where they stand to its committed displacement, or that at which it came to rest, N.
    [[nodiscard]] double stored_ahead_of_points(int e) const;

    [[nodiscard]] Mandel trial_stress(int e, std::size_t q) const;
    struct PointState {
        Mandel stress;             // MPa
        double energy;             // density, N/mm2
        Eigen::Matrix2d gradient;  // of the displacement, with what its functions no longer tell (row: component)
    };
    /// Committed, of all points of an element. They follow its displacement elastically.
    [[nodiscard]] std::vector<PointState> committed_states(int e,
                                                           EnergyDensity density = EnergyDensity::StressWork) const;
    /// Calls visit(q, state) of each of them.
    template <class Visit> void for_each_committed_state(int e, EnergyDensity density, Visit&& visit) const;

    /// Elements in and around which nothing is expected to yield in the coming half cycle (RestingElements).
    [[nodiscard]] ElementSet may_rest() const;
    /// These are left out of evaluate() from now on: they respond elastically, and who condenses them knows how.
    /// `displacement`: that of their points' states.
    void rest(const ElementSet& elements, const Eigen::VectorXd& displacement);
    /// Minus the nodal forces of the elements at rest, where they came to rest.
    [[nodiscard]] Eigen::VectorXd rest_load() const;
    /// Of those at rest, the ones that would yield at a displacement, which is the trial one from now on; it differs
    /// from that of evaluate() only in what follows them.
    [[nodiscard]] std::vector<int> would_yield(const Eigen::VectorXd& u);
    /// Of those that rest only `still` do so from now on; evaluate() sees the others again.
    void wake_all_but(const ElementSet& still);

    /// So far, summed over evaluations: of points and elements.
    [[nodiscard]] coupling::WorkCounts counts() const;
    void count_on_from(const coupling::WorkCounts& counts) { counts_ = counts; }

private:
    Bulk(BulkElements elements, MaterialLaws laws, const Eigen::VectorXd& displacement, const Bulk* old = nullptr);
    void carry_history(Bulk& old);
    void carry_stayed(const Bulk& old);
    void mix_history(const Bulk& old, int old_element, int element);
    void begin_elastic(int e);
    [[nodiscard]] Eigen::Matrix2d gradient(int e, std::size_t q, const Eigen::VectorXd& element_u) const;
    template <class Kernel> void find_trial_force(int e, const Kernel& kernel);
    template <class Kernel> void find_tangent(int e, const Kernel& kernel);
    void evaluate_element(int e);
    void add_trial_force(int e);
    void update_points();
    void update_points(int e);
    /// Committed, or that at which an element came to rest.
    [[nodiscard]] const Eigen::VectorXd& standing_displacement(int e) const {
        return resting_.contains(e) ? resting_.displacement() : committed_u_;
    }
    [[nodiscard]] Eigen::VectorXd gather(int e, const Eigen::VectorXd& u) const {
        return stria::gather(u, elements_.op(e).unknowns);
    }

    BulkElements elements_;
    PointHistory history_;
    RestingElements resting_;
    StandingPoints stand_;
    ElementSet proven_;          // elastic in the last evaluation, without a look at their points
    ElementValues trial_force_;  // nodal, of each element; of those at rest where they came to rest
    Eigen::VectorXd committed_u_, trial_u_;
    Eigen::VectorXd increment_;  // trial less committed displacement
    double slight_ = 0.0;        // of the last evaluation
    Eigen::VectorXd force_, force_scale_;
    std::vector<Eigen::MatrixXd> tangents_;  // of those that have softened; the others' are elastic
    ElementSet changed_;
    ElementSet softened_;  // in the last evaluation
    coupling::WorkCounts counts_;
};

template <class Visit> void Bulk::for_each_committed_state(int e, EnergyDensity density, Visit&& visit) const {
    const bool all_work = density == EnergyDensity::StressWork;
    const Elasticity& elastic = elements_.materials().elastic(elements_.mesh().material_of(e));
    with_kernel(elements_.op(e), [&](const auto& kernel) {
        const auto u = kernel.gather(committed_u_);
        const auto moved = (u - kernel.nodal(stand_.displacement(e).data())).eval();
        const bool stands = moved.isZero(0.0);
        for (std::size_t q = 0; q < at(history_.points(e)); ++q) {
            PointState state{history_.stress(e, q), all_work ? history_.work(e, q) : 0.0,
                             kernel.displacement_gradient(u, q)};
            if (history_.has_frozen_gradients()) state.gradient += history_.frozen_gradient(e, q);
            if (!stands) {
                const Mandel strain = kernel.strain(moved, q), change = elements_.elastic_stiffness(e) * strain;
                if (all_work) state.energy += (state.stress + 0.5 * change).dot(strain);
                state.stress += change;
            }
            if (!all_work) state.energy = elastic.energy(state.stress);
            visit(q, state);
        }
    });
}

}  // namespace stria::fine
