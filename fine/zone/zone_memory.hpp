// What a zone remembers besides the history of its points and the statuses of its faces: committed unknowns, the
// increments that led there, and what the growth of its cracks has left behind.
#pragma once

#include "common/predictor.hpp"
#include "coupling/messages.hpp"
#include "coupling/zone_snapshot.hpp"
#include "fine/contact/contact_interface.hpp"
#include "fine/growth/frozen_tips.hpp"
#include "fine/growth/opening_faces.hpp"

namespace stria::fine {

struct ZoneUnknowns {
    Eigen::VectorXd displacement;  // of all unknowns of the mesh, mm
    Eigen::VectorXd traction;      // of all multipliers, MPa: ContactInterface

    [[nodiscard]] FaceOperators::End at_faces() const { return {displacement, traction}; }
};

struct ZoneMemory {
    ZoneUnknowns committed = {};
    IncrementMemory<ZoneUnknowns> increments;  // for predictors
    FrozenTips frozen = {};
    OpeningFaces opening = {};
};

/// `next`, with longer cracks on the same elements, is to follow `before`, whose displacement is `u`: adds that of the
/// functions which `next` lacks to what is frozen (docs/method.md, section 7).
void freeze_what_is_left(FrozenTips& frozen, const Eigen::VectorXd& u, const EnrichedMesh& before,
                         const coupling::Patch& next);

/// Turns the committed state to the unknowns of a new mesh and of its faces. `old_contact`: null at the start, when
/// nothing is carried.
void carry_unknowns(ZoneMemory& memory, const EnrichedMesh& before, const ContactInterface* old_contact,
                    const coupling::Patch& next, ContactInterface& contact);

/// Increments go along with the tips (MovedField), or are forgotten where they cannot. `contact`: the old one where
/// the mesh is the same, but for its tips.
void carry_increments(ZoneMemory& memory, const EnrichedMesh& before, const ContactInterface& old_contact,
                      const coupling::Patch& next, const ContactInterface& contact);

/// From where slips count on the faces of `next`, at the displacement `now`, mm; and beyond it what those of `before`
/// had been held at, beside where they were committed. So a growth lets go of functions and not of what faces have
/// slid, until equilibrium is found.
[[nodiscard]] Eigen::VectorXd slips_to_hold(const ContactInterface& before, const Eigen::VectorXd& committed,
                                            const ContactInterface& next, const Eigen::VectorXd& now);
[[nodiscard]] Eigen::VectorXd settled_slips_in(const coupling::ZoneSnapshot& snapshot);

/// Writes all of it, and of each multiplier its place, its committed status and its rest.
void write(const ZoneMemory& memory, const ContactInterface& contact, coupling::ZoneSnapshot& out);

/// Takes up all but the frozen tips, which the faces have to know before. Throws std::logic_error where the multipliers
/// of a snapshot are not those of `contact`.
void take_up(ZoneMemory& memory, ContactInterface& contact, const EnrichedMesh& mesh,
             const coupling::ZoneSnapshot& snapshot);

}  // namespace stria::fine
