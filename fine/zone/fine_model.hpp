// The zone as a nonlinear superelement: displacement of its boundary in, condensed force and tangent out.
#pragma once

#include "coupling/fine_scale.hpp"
#include "fine/zone/zone_system.hpp"
#include "fine/zone/zone_tree.hpp"

namespace stria::fine {

/// All unknowns of the zone, multipliers of its contact included, are condensed by a tree of fronts onto the boundary
/// (docs/method.md, section 1). The interior follows each boundary displacement through the last factor, so the
/// iterates are those of Newton's method on the whole system.
class FineModel : public coupling::FineScale {
public:
    explicit FineModel(const ZoneSections& input);

    void set_patch(const coupling::Patch& patch) override;
    [[nodiscard]] Eigen::MatrixXd increments() override;
    void request(const coupling::PatchDisplacement& displacement) override;
    coupling::PatchResponse collect() override;
    coupling::StepReport commit(const coupling::Commit& what) override;
    void rollback() override {}  // the next increment starts from what is committed
    coupling::ZoneState state() override;
    coupling::ZoneSnapshot snapshot() override;
    /// A growth comes next, before which nothing rests.
    void keep() override { keep_snapshot(system_.snapshot()); }
    void restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) override;

    [[nodiscard]] const ZoneSystem& system() const { return system_; }

private:
    void begin_rest(bool after_patch);
    void begin_rest_where_due();
    void rest_again(const coupling::ZoneSnapshot& snapshot);
    void wake_all_but(const ElementSet& still);
    void evaluate();
    void linearise();
    [[nodiscard]] bool is_time_to_check_rest(const coupling::PatchResponse& response) const;
    [[nodiscard]] bool wake_what_would_yield();
    void correct();
    [[nodiscard]] double work_along_correction() const;
    [[nodiscard]] bool may_keep_factor() const;
    [[nodiscard]] bool keeps_factor() const;
    void condense(coupling::PatchResponse& response);

    ZoneSystem system_;
    ZoneTree tree_{system_};
    ReducedLoad reduced_, reduced_unit_;  // of what is to be removed, and of the zone's own loads
    using Wanted = coupling::PatchDisplacement::Wanted;
    coupling::PatchDisplacement asked_;
    coupling::PatchResponse response_;  // to it
    struct Correction {
        Eigen::VectorXd displacement, traction;  // taken whole
        double work_before = 0.0;                // along it, of what was out of balance where it began, N
    } correction_;
    double factor_s_ = 0.0;
    bool some_rest_ = false;
    bool rest_is_due_ = false;  // a half cycle has ended, and nothing has been asked since
    coupling::WorkCounts work_;
};

}  // namespace stria::fine
