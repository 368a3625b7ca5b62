// The bulk of the fine zone: sub-quadrangle points with their history, internal forces and element tangents.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/fem/domain_integral.hpp"
#include "common/fem/element_operator.hpp"
#include "common/material/elasticity.hpp"
#include "coupling/messages.hpp"
#include "fine/material/material_law.hpp"

namespace stria::fine {

class Zone {
public:
    Zone(const EnrichedMesh& mesh, std::unique_ptr<MaterialLaw> law, const Elasticity& elastic,
         const IntegrationRule& rule);

    /// Elements that `old` holds too keep their points' states; the others start from sigma = C eps(u) (DESIGN section
    /// 4).
    void start(const Zone* old, const Eigen::VectorXd& displacement);

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

    /// Integrals of the committed state.
    [[nodiscard]] double dissipation() const;
    /// Adds the share of the zone's bulk to the domain integrals of a tip.
    void add_to(RingSums& rings) const;
    /// Largest distance from the tip to a point that has ever flowed.
    [[nodiscard]] double plastic_reach(const Tip& tip) const;
    /// Largest distance from the tip to a point that flowed since the last reversal; `half_angle` about the line ahead.
    [[nodiscard]] double plastic_extent(const Tip& tip, double half_angle) const;
    void describe(coupling::ZoneState& out) const;

private:
    template <class Kernel> void evaluate_element(std::size_t e, const Kernel& kernel);
    [[nodiscard]] double committed(int component, int point) const {
        return committed_[static_cast<std::size_t>(component) * static_cast<std::size_t>(points_) +
                          static_cast<std::size_t>(point)];
    }
    [[nodiscard]] Mandel committed_mandel(int component, int point) const;

    EnrichedMesh mesh_;
    std::unique_ptr<MaterialLaw> law_;
    Elasticity elastic_;
    std::vector<ElementOperator> operators_;
    std::vector<int> first_point_;
    std::vector<Eigen::MatrixXd> elastic_stiffness_;
    int points_ = 0;

    // Per point, component by component (material_law.hpp).
    std::vector<double> committed_, trial_, strain_, tangent_;
    std::vector<unsigned char> yielding_, flowed_;
    bool half_cycle_ended_ = false;

    Eigen::VectorXd committed_u_, trial_u_, force_, force_scale_;
    std::vector<Eigen::MatrixXd> tangents_;
    std::vector<char> changed_, was_plastic_;
};

}  // namespace stria::fine
