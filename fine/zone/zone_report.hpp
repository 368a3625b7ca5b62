// What the zone reports to the coarse side: of each trial state its faces; committed its tips, its share of the rings,
// and its faces.
#pragma once

#include <vector>

#include "common/fracture/domain_integral.hpp"
#include "coupling/messages.hpp"
#include "fine/bulk/bulk_report.hpp"
#include "fine/bulk/bulk_summary.hpp"
#include "fine/contact/contact_interface.hpp"

namespace stria::fine {

/// What a report looks at, in equilibrium and committed.
struct CommittedZone {
    const coupling::Patch& patch;
    const Bulk& bulk;
    const BulkSummary& summary;
    const ContactInterface& contact;
    const FrozenTips& frozen;
    const Eigen::VectorXd& displacement;  // of all unknowns of the mesh, mm
    const Eigen::VectorXd& traction;      // of all multipliers, MPa: ContactInterface
    double rounding;                      // MPa, of a strain of 1e-12: less is no pressure
};

/// Opening behind tip t, mm, where the patch asks for it, at displacements of all unknowns of its mesh, mm. NaN: the
/// place is not in the zone.
[[nodiscard]] double opening_behind(const coupling::Patch& patch, const FrozenTips& frozen,
                                    const Eigen::VectorXd& displacement, std::size_t t);

/// What a digest tells of a trial state's faces.
struct TrialFaces {
    const coupling::Patch& patch;
    const ContactInterface& contact;
    const FrozenTips& frozen;
    const Eigen::VectorXd &displacement, &traction;  // as in CommittedZone
    const ContactInterface::Jumps& jumps;
    double smallest_slip;  // mm: less is rounding
};
void put_faces(const TrialFaces& faces, coupling::Digest& digest);

/// The rings of a patch about a tip, and those stations of its crack's faces near it that may touch.
struct TipRings {
    RingSums sums;
    std::vector<int> numbers;  // coupling::Ring::number
    std::vector<FaceStation> stations;
    EnergyDensity density;
    ElasticAnswers answers;
};
/// One per tip of the patch, which must outlive them. `cracks`: those that the run began with. `subcells`: of the
/// faces. `before`: empty, or those of the same bulk, from where its tips have moved on.
[[nodiscard]] std::vector<TipRings> rings_of(const coupling::Patch& patch, const Materials& materials,
                                             const std::vector<CrackSection>& cracks, int subcells,
                                             std::vector<TipRings> before = {});

/// Puts into a report what it says of tips, lengths in contact and mouths and, where they are read, of rings and faces.
/// `cracks`: how many the case has.
void report_on(const CommittedZone& zone, std::vector<TipRings>& rings, std::size_t cracks,
               const coupling::Commit& what, coupling::StepReport& report);

}  // namespace stria::fine
