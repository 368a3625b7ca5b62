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

/// One per tip of the mesh.
[[nodiscard]] std::vector<coupling::TipReport> report_tips(const CommittedZone& zone);

/// The rings of a patch about a tip, and those stations of its crack's faces near it that may touch.
struct TipRings {
    RingSums sums;
    std::vector<int> numbers;  // coupling::Ring::number
    std::vector<FaceStation> stations;
    EnergyDensity density;
};
/// One per tip of the patch, which must outlive them. `cracks`: those that the run began with. `subcells`: of the
/// faces.
[[nodiscard]] std::vector<TipRings> rings_of(const coupling::Patch& patch, const Materials& materials,
                                             const std::vector<CrackSection>& cracks, int subcells);

/// One per ring of the patch, tip by tip.
[[nodiscard]] std::vector<coupling::RingReport> report_rings(const CommittedZone& zone, std::vector<TipRings>& rings);

/// One per station that may touch, by crack and arc length.
[[nodiscard]] std::vector<coupling::FaceSample> report_faces(const CommittedZone& zone);

/// Length in contact, mm, one per crack. `cracks`: of the case.
[[nodiscard]] std::vector<double> contact_lengths(const CommittedZone& zone, std::size_t cracks);

/// Opening where each crack meets the boundary, mm: NaN where it has two tips, or the zone does not hold that end.
[[nodiscard]] std::vector<double> mouth_openings(const CommittedZone& zone, std::size_t cracks);

}  // namespace stria::fine
