// The nonlinear zone before anyone condenses it: bulk and contact, committed and trial unknowns, residuals and reports.
#pragma once

#include <memory>
#include <optional>
#include <utility>

#include "coupling/messages.hpp"
#include "fine/bulk/bulk.hpp"
#include "fine/bulk/soft_jumps.hpp"
#include "fine/contact/contact_interface.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"
#include "fine/zone/taken_over.hpp"
#include "fine/zone/zone_at_rest.hpp"
#include "fine/zone/zone_memory.hpp"
#include "fine/zone/zone_report.hpp"
#include "fine/zone/zone_sections.hpp"

namespace stria::fine {

/// What a zone bears in an iterate, beside the displacement of its boundary.
struct ZoneLoading {
    double load_factor = 0.0;
    Eigen::VectorXd cases = {};  // factors of the load cases; those beyond the end are zero
    double held = 0.0;           // share of the forces on faces that growth has opened that still holds them
    bool elastic = false;        // as if no point flowed
};

class ZoneSystem {
public:
    explicit ZoneSystem(const ZoneSections& input);

    /// A new zone; elements and multipliers that the old one had keep their history. All tangents are elastic.
    TakenOver set_patch(const coupling::Patch& patch);

    /// The first iterate of an increment.
    void predict(const Predictor& predictor);
    /// Remembers the way to the present trial state, as Predictor has it.
    void put_aside();

    /// Of the trial state, until it is told anew.
    void bear(ZoneLoading loading) { loading_ = std::move(loading); }
    [[nodiscard]] double load_factor() const { return loading_.load_factor; }
    /// Growth has opened faces that forces still hold in the committed state.
    [[nodiscard]] bool opens_faces() const { return memory_.opening.any(); }

    /// Moves the trial unknowns: displacements of the zone, tractions of the faces.
    void move(const Eigen::VectorXd& displacement, const Eigen::VectorXd& traction);
    void set_boundary(const Eigen::VectorXd& displacement) { trial_.displacement(patch_.boundary) = displacement; }

    /// Stresses, tangents, gaps and statuses at the trial unknowns.
    void linearise();

    // What rests. Vectors are of all unknowns of the mesh and then of the tractions.

    [[nodiscard]] Resting may_rest() const {
        return fine::may_rest(*bulk_, *contact_, patch_, memory_.opening.held(patch_.mesh.unknowns));
    }
    /// These rest from the committed state on. `inside`: the unknowns that follow the others; neither their loads nor
    /// their residuals are known here.
    void rest(Resting resting, UnknownSet inside);
    /// The trial unknowns inside have `moved` since they came to rest. Those of what rests that would yield there, or
    /// change their status.
    [[nodiscard]] Restless follow(const Eigen::VectorXd& moved);
    /// All but those that still rest are evaluated again.
    void wake_all_but(Resting still, UnknownSet inside);
    void wake_all() {
        wake_all_but({ElementSet(bulk_->elements().count()), MultiplierSet(contact_->multipliers())},
                     UnknownSet(patch_.mesh.unknowns + contact_->tractions()));
    }
    /// What is due on them where they came to rest, and what the unknowns have moved since then.
    [[nodiscard]] const Eigen::VectorXd& rest_load() const { return at_rest_.load(); }
    [[nodiscard]] Eigen::VectorXd moved_since_rest() const;
    /// What they do to the others.
    void add_response(const Eigen::VectorXd& load);

    /// What Newton has to remove from every zone unknown: applied load - (internal force - B^T p + T^T tau), N/mm.
    [[nodiscard]] const Eigen::VectorXd& load() const { return load_; }

    [[nodiscard]] const Bulk& bulk() const { return *bulk_; }
    [[nodiscard]] const ContactInterface& contact() const { return *contact_; }
    [[nodiscard]] const coupling::Patch& patch() const { return patch_; }
    [[nodiscard]] const Eigen::VectorXd& displacement() const { return trial_.displacement; }
    [[nodiscard]] const Eigen::VectorXd& traction() const { return trial_.traction; }
    [[nodiscard]] const FrozenTips& frozen() const { return memory_.frozen; }
    /// Of the multipliers' part of the semismooth system.
    [[nodiscard]] Eigen::VectorXd contact_right_hand_side() const;

    /// Residuals, scales and digest; force and tangent are left to who condenses.
    [[nodiscard]] coupling::PatchResponse measure();
    /// What a digest says of the faces.
    void measure_faces(coupling::Digest& digest) const;
    [[nodiscard]] double tolerance() const { return input_.tolerance; }
    [[nodiscard]] const ZoneSections& sections() const { return input_; }
    /// Counted so far, of points and faces.
    [[nodiscard]] coupling::WorkCounts work() const {
        return contact_work_ + (bulk_ ? bulk_->counts() : coupling::WorkCounts());
    }

    coupling::StepReport commit(const coupling::Commit& what);
    [[nodiscard]] coupling::ZoneState state() const;

    /// As coupling::FineScale has it; roots of trees are the affair of who has a tree.
    [[nodiscard]] coupling::ZoneSnapshot snapshot() const;
    void restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot);

    /// The last ones, for predictors; the last of all first.
    [[nodiscard]] const std::deque<ZoneUnknowns>& increments() const { return memory_.increments.all(); }

private:
    [[nodiscard]] MaterialLaws make_laws() const { return make_material_laws(input_.materials, input_.fine.substeps); }
    TakenOver move_tips(const coupling::Patch& patch);
    TakenOver begin_zone(const coupling::Patch& patch);
    [[nodiscard]] std::unique_ptr<ContactInterface> make_contact(const coupling::Patch& patch,
                                                                 const FrozenTips& frozen) const;
    void begin_with(const coupling::Patch& patch);
    [[nodiscard]] Eigen::VectorXd force_of_faces() const;
    [[nodiscard]] Eigen::VectorXd load_beside(const Eigen::VectorXd& faces) const;
    [[nodiscard]] UnknownSet held_by(const Eigen::VectorXd& faces) const;
    [[nodiscard]] double smallest_slip() const;
    [[nodiscard]] ZoneUnknowns way_to_trial() const {
        return {trial_.displacement - memory_.committed.displacement, trial_.traction - memory_.committed.traction};
    }
    /// Nothing yields: what functions of the past have left behind is let go, for stresses are those of the present.
    [[nodiscard]] bool forgets() const { return !input_.materials.may_yield(); }
    /// Of a bulk and its faces in the committed state, on all unknowns, N/mm.
    [[nodiscard]] Eigen::VectorXd committed_force(Bulk& bulk, const ContactInterface& contact) const;
    /// `force`: of the metal and the faces before, in equilibrium; empty unless the zone forgets().
    void open_new_faces(const EnrichedMesh& before, const Eigen::VectorXd& force);
    [[nodiscard]] coupling::EnergyReport spent_at_faces(bool releases) const;
    void take_over_trial(const coupling::Commit& what);
    void add_energies(const ZoneUnknowns& move, coupling::EnergyReport& energy);
    void put_counts(coupling::StepReport& report) const;

    ZoneSections input_;
    coupling::Patch patch_;
    std::unique_ptr<Bulk> bulk_;
    SoftJumps soft_jumps_;
    std::optional<BulkSummary> summary_;  // of the committed bulk
    std::unique_ptr<ContactInterface> contact_;
    std::vector<TipRings> rings_;  // per tip
    ZoneMemory memory_;
    ZoneUnknowns trial_;
    ZoneLoading loading_;
    Eigen::VectorXd load_;
    ContactInterface::Jumps jumps_;
    ZoneAtRest at_rest_;
    int steps_ = 0;  // of Newton's method in this attempt
    double largest_move_ = 0.0;
    double constitutive_s_ = 0.0, contact_s_ = 0.0;
    coupling::WorkCounts contact_work_;
};

}  // namespace stria::fine
