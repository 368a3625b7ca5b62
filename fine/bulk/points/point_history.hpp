// What the points of the zone remember, committed and trial. It alone knows where a number of a point's state stands.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "common/index_set.hpp"
#include "common/integration/element_operator.hpp"
#include "common/shared_list.hpp"
#include "fine/material/material_law.hpp"

namespace stria::fine {

/// A point is known by its element e and its number q there. Fields are stored component by component over all points
/// (material_law.hpp), so that laws work on packs of neighbouring points. A component that its law does not store is
/// zero.
class PointHistory {
public:
    /// All zero. `laws`: one per material; `material`: of each element, empty: all are of material 0.
    PointHistory(MaterialLaws laws, SharedList<int> material, const std::vector<ElementOperator>& operators);

    [[nodiscard]] const MaterialLaw& law(int e) const { return *laws_[at(material_of(e))]; }
    /// Components of a state: those of the law with the most.
    [[nodiscard]] int state_size() const { return state_size_; }
    /// Of all elements; the stride between two components of a field.
    [[nodiscard]] int points() const { return first_.back(); }
    [[nodiscard]] int points(int e) const { return first_[at(e) + 1] - first_[at(e)]; }
    /// Numbers that all points store beyond their stresses.
    [[nodiscard]] std::int64_t values_beyond_stress() const {
        return static_cast<std::int64_t>(points()) * (state_size_ - state::plastic_strain);
    }
    /// Points that the law has been asked for so far.
    [[nodiscard]] std::int64_t evaluated() const { return evaluated_; }

    // Trial and committed.

    /// Trial states and tangents of the elements begin ... end - 1: committed ones plus a displacement increment, given
    /// on all unknowns, mm. Throws NumericalFailure where the return mapping fails.
    void update(std::span<const ElementOperator> operators, int begin, int end, const Eigen::VectorXd& increment);
    /// The same of one element, by its own increments in the order of its unknowns, mm.
    void update(const ElementOperator& op, int e, const Eigen::VectorXd& increment);
    /// The same behind a way on which it stays elastic. What is committed stays as it is.
    void update(const ElementOperator& op, int e, const Eigen::VectorXd& elastic_way, const Eigen::VectorXd& increment);
    /// Trial becomes committed, but for elements that have no trial states. `reversal`: with this a half cycle ends.
    void commit(bool reversal, const ElementSet& without_trial);
    /// Of the elements begin ... end - 1, whatever the others do.
    void commit(int begin, int end) { copy(begin, end, trial_, committed_); }
    void rollback(int e) { copy(e, e + 1, committed_, trial_); }
    void rollback() { trial_ = committed_; }

    [[nodiscard]] Mandel stress(int e, std::size_t q) const { return tensor(committed_, state::stress, e, q); }
    [[nodiscard]] Mandel trial_stress(int e, std::size_t q) const { return tensor(trial_, state::stress, e, q); }
    [[nodiscard]] Mandel plastic_strain(int e, std::size_t q) const;
    [[nodiscard]] double accumulated(int e, std::size_t q) const { return committed(state::accumulated, e, q); }
    /// Densities, N/mm2.
    [[nodiscard]] double dissipation(int e, std::size_t q) const { return committed(state::dissipation, e, q); }
    [[nodiscard]] double work(int e, std::size_t q) const { return law(e).work(first_committed(e) + q, points()); }
    [[nodiscard]] double stored_energy(int e, std::size_t q) const {
        return law(e).stored_energy(first_committed(e) + q, points());
    }
    /// Consistent, of the trial state.
    [[nodiscard]] MandelMatrix tangent(int e, std::size_t q) const;

    /// The first stress component of an element's first point; its others follow, components are points() apart.
    [[nodiscard]] const double* stresses(int e) const { return &committed_[place(state::stress, e, 0)]; }
    [[nodiscard]] const double* trial_stresses(int e) const { return &trial_[place(state::stress, e, 0)]; }

    /// The smallest change of the von Mises stress that makes a point of the element yield, MPa.
    [[nodiscard]] double elastic_margin(int e) const {
        return law(e).elastic_margin(points(e), points(), first_committed(e));
    }
    /// The same behind an elastic way, in the order of its unknowns, mm, with the elastic stiffness of its points;
    /// below zero: it would yield there. Its law is not asked. Throws NumericalFailure where its stress is not finite.
    /// Trial states are the committed ones afterwards.
    [[nodiscard]] double elastic_margin_behind(const ElementOperator& op, int e, const Eigen::VectorXd& way,
                                               const MandelMatrix& elastic);

    // Who yields, and who is plastic.

    /// In the trial increment.
    [[nodiscard]] bool yields(int e, std::size_t q) const { return yielding_[place(0, e, q)] != 0; }
    [[nodiscard]] bool yields(int e) const;
    void set_elastic(int e);
    /// Points of an element that yield.
    [[nodiscard]] int yielding_points(int e) const;
    /// Of the accumulated plastic strain, over points of an element that yield.
    [[nodiscard]] double largest_plastic_increment(int e) const;

    /// Of the accumulated plastic strain, in the committed increments since the last half cycle ended.
    [[nodiscard]] double flow(int e, std::size_t q) const { return flow_[place(0, e, q)]; }
    void set_flow(int e, std::size_t q, double flow) { flow_[place(0, e, q)] = flow; }
    /// A point of the element has yielded since then, however little.
    [[nodiscard]] bool is_plastic(int e) const;
    /// The last commit ended a half cycle.
    [[nodiscard]] bool half_cycle_ended() const { return half_cycle_ended_; }
    void set_half_cycle_ended(bool ended) { half_cycle_ended_ = ended; }

    // How a history starts: committed states; rollback() when all are written.

    /// Of a point that has been elastic up to a total strain, from an initial stress on.
    void begin(int e, std::size_t q, const Mandel& strain, const Mandel& initial) {
        law(e).begin(strain, initial, first_committed(e) + q, points());
    }
    /// For the elements begin ... end - 1 all that as many ones, with as many points, from `from` on remember in
    /// another history with the same laws, in the same materials.
    void take(int begin, int end, const PointHistory& other, int from);
    /// Adds a share of the state of a point of another history with the same laws, in the same material.
    void add_share(int e, std::size_t q, double share, const PointHistory& other, int from, std::size_t from_q);
    /// All numbers of a state, in the order of the law.
    [[nodiscard]] double value(int component, int e, std::size_t q) const { return committed_[place(component, e, q)]; }
    void set_value(int component, int e, std::size_t q, double value) { committed_[place(component, e, q)] = value; }

    /// Displacement gradient that the unknowns do not tell, as the functions it was made of are gone (row: component).
    [[nodiscard]] Eigen::Matrix2d frozen_gradient(int e, std::size_t q) const;
    [[nodiscard]] bool has_frozen_gradients() const { return !frozen_gradient_.empty(); }
    void freeze_gradient(int e, std::size_t q, const Eigen::Matrix2d& gradient);

private:
    [[nodiscard]] std::size_t place(int component, int e, std::size_t q) const {
        return at(component) * at(points()) + at(first_[at(e)]) + q;
    }
    [[nodiscard]] double* first_committed(int e) { return &committed_[place(0, e, 0)]; }
    [[nodiscard]] const double* first_committed(int e) const { return &committed_[place(0, e, 0)]; }
    [[nodiscard]] double committed(int component, int e, std::size_t q) const {
        return component < state_size_ ? value(component, e, q) : 0.0;
    }
    [[nodiscard]] Mandel tensor(const std::vector<double>& states, int component, int e, std::size_t q) const {
        return tensor_at(&states[place(component, e, q)], points(), 0);
    }
    void begin_frozen_gradients();
    void return_points(int begin, int end);
    void copy(int begin, int end, const std::vector<double>& from, std::vector<double>& to) const;

    [[nodiscard]] int material_of(int e) const { return material_.empty() ? 0 : material_[at(e)]; }

    MaterialLaws laws_;
    SharedList<int> material_;  // of each element
    int state_size_ = 0;
    bool can_yield_ = false;                        // some point
    std::vector<int> first_{0};                     // point of each element, and behind the last
    std::vector<double> committed_, trial_;         // as many components as a state
    std::vector<double> strain_;                    // 4 components: the increment
    std::vector<double> tangent_;                   // 16 components; empty: no point can yield
    std::vector<unsigned char> yielding_;           // per point
    std::vector<double> flow_;                      // per point, in this half cycle
    bool half_cycle_ended_ = false;                 // the next plastic increment is the first of a half cycle
    std::vector<Eigen::Matrix2d> frozen_gradient_;  // per point; empty: none
    std::int64_t evaluated_ = 0;
};

}  // namespace stria::fine
