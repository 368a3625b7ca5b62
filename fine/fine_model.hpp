// The zone as a nonlinear superelement: displacement of its boundary in, condensed force and tangent out.
#pragma once

#include <Eigen/LU>
#include <memory>

#include "common/substructure/front_tree.hpp"
#include "coupling/fine_scale.hpp"
#include "fine/zone_system.hpp"

namespace stria::fine {

/// Bulk unknowns are condensed by a tree of fronts onto the crack's jump unknowns and the boundary; jumps and contact
/// multipliers, ordered last, are eliminated in a small dense block (DESIGN section 1). The interior follows each
/// boundary displacement through the last factor, so the iterates are those of Newton's method on the whole system.
class FineModel : public coupling::FineScale {
public:
    explicit FineModel(const Case& input);

    void set_patch(const coupling::Patch& patch) override;
    void request(const coupling::PatchDisplacement& displacement) override;
    coupling::PatchResponse collect() override;
    coupling::StepReport commit(bool reversal) override;
    void rollback() override;
    coupling::ZoneState state() override;

private:
    /// Dense block of jumps and multipliers, with its couplings to the boundary.
    struct ContactBlock {
        Eigen::PartialPivLU<Eigen::MatrixXd> factor;
        Eigen::MatrixXd inverse_times_boundary;  // A^-1 A_cb
        Eigen::MatrixXd inverse_times_loads;     // A^-1 (b_j, b_multipliers), and A^-1 (unit load on j, 0)
    };
    void advance_interior();
    void condense(coupling::PatchResponse& response);

    ZoneSystem system_;
    std::unique_ptr<FrontTree> tree_;
    std::vector<int> interior_jumps_;  // jump unknowns that are not on the boundary, as indices into jump_unknowns()
    std::vector<int> kept_;            // boundary of the tree: interior jumps, then Gamma
    ContactBlock block_;
    ReducedLoad reduced_, reduced_unit_;  // of what is to be removed, and of the zone's own loads
    coupling::PatchDisplacement asked_;
    double factor_s_ = 0.0;
    bool all_changed_ = true;
};

}  // namespace stria::fine
