// The bulk of the fine zone: sub-quadrangle points with their history, internal forces and element tangents.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "common/fracture/domain_integral.hpp"
#include "common/index.hpp"
#include "common/integration/element_operator.hpp"
#include "common/material/elasticity.hpp"
#include "coupling/messages.hpp"
#include "coupling/zone_snapshot.hpp"
#include "fine/bulk/elastic_bound.hpp"
#include "fine/material/material_law.hpp"

namespace stria::fine {

class Zone {
public:
    /// Elements that `old` (may be null) holds too keep their points, with weights fitted anew where the crack has
    /// newly cut them, and the points' states; the others start from sigma = C eps(displacement) (docs/method.md,
    /// section 7). `displacement`: committed, of all unknowns.
    Zone(const EnrichedMesh& mesh, std::unique_ptr<MaterialLaw> law, const Elasticity& elastic,
         const IntegrationRule& rule, const Zone* old, const Eigen::VectorXd& displacement);

    /// As a snapshot has it, which holds all elements of the mesh.
    Zone(const EnrichedMesh& mesh, std::unique_ptr<MaterialLaw> law, const Elasticity& elastic,
         const IntegrationRule& rule, const coupling::ZoneSnapshot& snapshot);

    /// Stresses, internal forces and tangents at committed state + (u - committed u). Repeatable: same u, same bits.
    void evaluate(const Eigen::VectorXd& u);

    /// Trial becomes committed. `reversal`: with this increment a half cycle ends; plastic extents start anew after it.
    void commit(bool reversal);

    [[nodiscard]] const EnrichedMesh& mesh() const { return mesh_; }
    [[nodiscard]] const Eigen::VectorXd& committed_displacement() const { return committed_u_; }
    [[nodiscard]] const Eigen::VectorXd& internal_force() const { return force_; }

    /// Sum over elements of |nodal force|, per unknown: the scale against which a residual is small.
    [[nodiscard]] const Eigen::VectorXd& force_scale() const { return force_scale_; }
    [[nodiscard]] std::span<const Eigen::MatrixXd> tangents() const { return tangents_; }
    /// Elements whose tangent differs from that of the evaluation before.
    [[nodiscard]] std::span<const char> changed() const { return changed_; }

    [[nodiscard]] const std::vector<ElementOperator>& operators() const { return operators_; }
    [[nodiscard]] int points() const { return points_; }
    [[nodiscard]] std::vector<std::int32_t> yielding_points() const;
    [[nodiscard]] double largest_plastic_increment() const;

    /// Integrals of the committed state, N.
    [[nodiscard]] double dissipation() const;
    [[nodiscard]] double stored_energy() const;
    /// Displacement gradient at a point of an element, with what its functions no longer say.
    [[nodiscard]] Eigen::Matrix2d committed_gradient(std::size_t element, std::size_t point) const {
        return total_gradient(element, point, gather(committed_u_, operators_[element].unknowns));
    }
    /// Adds the share of the zone's bulk to the domain integrals of a tip.
    void add_to(RingSums& rings) const;
    /// Largest distance from the tip to a point that has ever flowed.
    [[nodiscard]] double plastic_reach(const Tip& tip) const;
    /// Largest distance from the tip to a point that flowed since the last reversal; `half_angle` about the line ahead.
    [[nodiscard]] double plastic_extent(const Tip& tip, double half_angle) const;
    /// Integral of the normal stress, across the line ahead, over the sector of 45 degrees to either side, N per mm of
    /// thickness; of the trial state.
    [[nodiscard]] double force_ahead(const Tip& tip, double radius) const;
    void describe(coupling::ZoneState& out) const;
    /// All that is committed, but for the displacements.
    void remember(coupling::ZoneSnapshot& out) const;

    // Elements at rest: zone_rest.cpp.

    /// Elements in which nothing has flowed for two half cycles, or ever can.
    [[nodiscard]] std::vector<char> quiet() const;
    /// These are left out of evaluate() from now on: they respond elastically, and who condenses them knows how.
    /// `displacement`: that of their points' states.
    void rest(const std::vector<char>& elements, const Eigen::VectorXd& displacement);
    [[nodiscard]] bool rests(std::size_t element) const { return course_[element] == Course::Resting; }
    /// Whether an element has points within a radius of a place, or could have.
    [[nodiscard]] bool is_near(std::size_t element, const Vec2& place, double radius) const;
    /// Where they came to rest: displacement of all unknowns, minus their nodal forces, and the scale of those.
    [[nodiscard]] const Eigen::VectorXd& rest_displacement() const { return rest_u_; }
    [[nodiscard]] Eigen::VectorXd rest_load() const;
    /// Of those at rest, the ones that would flow at a displacement, which is the trial one from now on; it differs
    /// from that of evaluate() only in what follows them.
    [[nodiscard]] std::vector<std::size_t> would_flow(const Eigen::VectorXd& u);
    /// Brings those that rest, and are not among `still`, to the committed displacement; evaluate() sees them again.
    void wake(const std::vector<char>& still);

    /// So far, summed over evaluations: of points and elements.
    [[nodiscard]] const coupling::WorkCounts& counts() const { return counts_; }
    /// Numbers that all points store beyond their stresses.
    [[nodiscard]] std::int64_t history_values() const {
        return static_cast<std::int64_t>(points_) * (law_->state_size() - state::plastic_strain);
    }
    void count_on_from(const coupling::WorkCounts& counts) { counts_ = counts; }

private:
    /// Points that an element has already; none: they are placed anew.
    using KnownPoints =
        std::function<std::optional<std::vector<IntegrationPoint>>(std::size_t element, const CrackPiece* cut)>;
    Zone(const EnrichedMesh& mesh, std::unique_ptr<MaterialLaw> law, const Elasticity& elastic,
         const IntegrationRule& rule, const Eigen::VectorXd& displacement, const KnownPoints& known);
    void make_operators(const IntegrationRule& rule, const KnownPoints& known);
    [[nodiscard]] std::optional<std::vector<IntegrationPoint>> points_kept(std::size_t element, const CrackPiece* cut,
                                                                           const Zone& old) const;
    void start(const Zone* old);
    void take_state(const Zone& old, std::size_t old_element, std::size_t element);
    [[nodiscard]] Eigen::Matrix2d total_gradient(std::size_t e, std::size_t q, const Eigen::VectorXd& element_u) const;
    template <class Kernel> [[nodiscard]] bool proves_elastic(std::size_t e, const Kernel& kernel);
    template <class Kernel> void evaluate_element(std::size_t e, const Kernel& kernel);
    enum class Course : char { Evaluated, Proven, Resting };
    void update_points(Course course);
    void update_block(std::size_t begin, std::size_t end, const Eigen::VectorXd& increment);
    void settle();
    void settle_forces();
    void find_forces(std::size_t e);
    void measure_margin(std::size_t e);
    void copy_state(std::size_t e, const std::vector<double>& from, std::vector<double>& to) const;
    [[nodiscard]] Mandel trial_stress(std::size_t e, std::size_t q) const;
    void count_quiet_half_cycles();
    [[nodiscard]] double energy_since_rest(std::size_t e) const;
    [[nodiscard]] bool flows_at(std::size_t e, const Eigen::VectorXd& u, const Eigen::VectorXd& since_rest);
    void look_from(std::size_t e, const Eigen::VectorXd& u);
    struct PointState {
        Mandel stress;
        double work;
    };
    [[nodiscard]] Eigen::VectorXd moved_since_rest(std::size_t e) const;
    [[nodiscard]] PointState committed_state(std::size_t e, std::size_t q, const Eigen::VectorXd& moved) const;
    /// Zero where the law stores no such component.
    [[nodiscard]] double committed(int component, int point) const {
        const std::size_t place = at(component) * at(points_) + at(point);
        return place < committed_.size() ? committed_[place] : 0.0;
    }
    [[nodiscard]] Mandel committed_mandel(int component, int point) const;

    EnrichedMesh mesh_;
    std::unique_ptr<MaterialLaw> law_;
    Elasticity elastic_;
    std::vector<ElementOperator> operators_;
    std::vector<int> piece_;  // of each element, -1: none
    std::map<int, std::size_t> element_of_id_;
    std::vector<Eigen::Matrix2d> frozen_gradient_;  // per point, of displacements that left the unknowns; empty: none
    std::vector<int> first_point_;
    std::vector<Eigen::MatrixXd> elastic_stiffness_;
    int points_ = 0;

    // Elements that surely stay elastic: their trial force is the committed one plus that of their elastic matrix,
    // their points wait for the commit.
    ElasticBound bound_;
    std::vector<Course> course_;
    std::vector<int> first_force_;                         // per element, in:
    std::vector<double> committed_forces_, trial_forces_;  // nodal, element by element
    Eigen::VectorXd increment_;                            // trial less committed displacement
    coupling::WorkCounts counts_;

    // Per point, component by component (material_law.hpp).
    std::vector<double> committed_, trial_, strain_, tangent_;
    std::vector<unsigned char> yielding_, flowed_;
    bool half_cycle_ended_ = false;
    std::vector<int> quiet_half_cycles_;  // per element: since it has flowed
    Eigen::VectorXd rest_u_;
    std::vector<double> looked_at_u_;  // nodal, element by element: where its margin at rest was measured

    Eigen::VectorXd committed_u_, trial_u_, force_, force_scale_;
    std::vector<Eigen::MatrixXd> tangents_;
    std::vector<char> changed_, was_plastic_;
};

}  // namespace stria::fine
