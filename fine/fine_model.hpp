// The zone as a nonlinear superelement: displacement of its boundary in, condensed force and tangent out.
#pragma once

#include <memory>
#include <vector>

#include "common/substructure/front_tree.hpp"
#include "coupling/fine_scale.hpp"
#include "fine/contact/contact_block.hpp"
#include "fine/zone_system.hpp"

namespace stria::fine {

/// Bulk unknowns are condensed by a tree of fronts onto the jumps of faces that touch, or lie beside such, and the
/// boundary; those jumps and the closed multipliers are eliminated in a small dense block (DESIGN section 1). Faces far
/// from touching are bulk like any other; where one closes, the tree is planted anew with its jumps at the root. The
/// interior follows each boundary displacement through the last factor, so the iterates are those of Newton's method on
/// the whole system.
class FineModel : public coupling::FineScale {
public:
    explicit FineModel(const Case& input);

    void set_patch(const coupling::Patch& patch) override;
    void request(const coupling::PatchDisplacement& displacement) override;
    coupling::PatchResponse collect() override;
    coupling::StepReport commit(bool reversal) override;
    void rollback() override;
    coupling::ZoneState state() override;
    coupling::ZoneSnapshot snapshot() override;
    void restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) override;

    [[nodiscard]] const ZoneSystem& system() const { return system_; }

private:
    void plant_tree();
    void keep_touching_to_root();
    void advance_interior();
    [[nodiscard]] bool last_factor_serves(const coupling::PatchResponse& response) const;
    void factor();
    void condense(coupling::PatchResponse& response);

    ZoneSystem system_;
    std::unique_ptr<FrontTree> tree_;
    std::vector<char> at_root_, committed_at_root_;  // per multiplier: its jumps are kept to the root of the tree
    std::vector<int> root_jumps_;   // such jumps that are not on the boundary, as indices into jump_unknowns()
    std::vector<int> kept_;         // boundary of the tree: these jumps, then Gamma
    std::vector<int> kept_column_;  // of each jump unknown: its place in kept_, -1 where it has none
    std::vector<int> touching_;     // multipliers in the block
    ContactBlock block_;
    ReducedLoad reduced_, reduced_unit_;  // of what is to be removed, and of the zone's own loads
    coupling::PatchDisplacement asked_;
    double factor_s_ = 0.0;
    bool all_changed_ = true;
    std::vector<char> changed_;  // per element: its tangent is not that of the last factor
    coupling::WorkCounts work_;  // of condensing
};

}  // namespace stria::fine
