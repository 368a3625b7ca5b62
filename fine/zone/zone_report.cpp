#include "fine/zone/zone_report.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "common/case/case_questions.hpp"
#include "common/crack/crack_crossings.hpp"
#include "common/crack/crack_end.hpp"
#include "common/crack/notch.hpp"
#include "common/index.hpp"

namespace stria::fine {
namespace {

// At a station that is not one of the contact's own, which hold what is fixed themselves.
double opening(const FrozenTips& frozen, const Eigen::VectorXd& displacement, const FaceStation& station) {
    const Vec2 jump = station.jump(displacement) + frozen.jump(station.crack, station.x);
    return jump.dot(station.normal);
}

double opening(const CommittedZone& zone, const FaceStation& station) {
    return opening(zone.frozen, zone.displacement, station);
}

coupling::FaceSample sample_at(const CommittedZone& zone, const FaceStation& station) {
    return {.crack = station.crack,
            .s = station.s,
            .x = station.x.x(),
            .y = station.x.y(),
            .opening = station.opening(zone.displacement),
            .slip = station.slip(zone.displacement)};
}

coupling::FaceSample touching_sample_at(const CommittedZone& zone, const FaceStation& station,
                                        const ContactInterface::FaceTraction& traction) {
    const auto& [pressure, shear, slides] = traction;
    coupling::FaceSample sample = sample_at(zone, station);
    sample.pressure = pressure;
    sample.shear = shear;
    sample.status = pressure > 0.0 ? (slides ? 2 : 1) : 0;
    sample.in_wake = zone.summary.has_flowed(station.element);
    return sample;
}

void add_tractions(RingSums& sums, const CommittedZone& zone, const std::vector<FaceStation>& stations) {
    const Eigen::VectorXd& u = zone.displacement;
    for (const FaceStation& station : stations) {
        const auto [pressure, shear, slides] = zone.contact.traction_at(station, zone.traction);
        if (!(pressure > 0.0)) continue;
        // The faces follow all of the jump: of closed ones the unknowns open as much as the frozen functions shut.
        const Vec2 frozen = zone.frozen.slope(station.crack, station.x);
        sums.add_faces(station, {.pressure = pressure,
                                 .shear = shear,
                                 .opening_slope = station.opening_slope(u) + frozen.dot(station.normal),
                                 .slip_slope = station.slip_slope(u) + frozen.dot(station.tangent),
                                 .in_wake = zone.summary.has_flowed(station.element)});
    }
}

/// By more than a mesh moves a tip onto a node: by a thousandth of an edge that meets there (docs/method.md, section
/// 2). Such an edge may be longer than the `element`, a square of its size, mm. All ranks are told the same one.
bool has_grown(const Tip& tip, const CrackSection& at_first, double element) {
    constexpr double seen = 4.0 * snap_fraction;
    return (tip.position - end_of(at_first, tip)).norm() > seen * element;
}

/// Up to the middle of a crack with two tips: beyond it they belong to the other tip.
FacesBehind faces_behind(const std::vector<Tip>& tips, std::size_t t, double distance) {
    FacesBehind part{.crack = tips[t].crack, .tip = tips[t].s, .from = distance};
    for (const Tip& other : tips)
        if (other.crack == part.crack && other.upper != tips[t].upper) part.to = 0.5 * part.distance(other.s);
    return part;
}

}  // namespace

double opening_behind(const coupling::Patch& patch, const FrozenTips& frozen, const Eigen::VectorXd& displacement,
                      std::size_t t) {
    const FaceStation station = face_station_behind(patch.mesh, patch.mesh.tips[t], patch.opening_at[t]);
    return station.terms.empty() ? std::numeric_limits<double>::quiet_NaN() : opening(frozen, displacement, station);
}

void put_faces(const TrialFaces& faces, coupling::Digest& digest) {
    const auto& [patch, contact, frozen, displacement, traction, jumps, smallest_slip] = faces;
    const std::vector<Tip>& tips = patch.mesh.tips;
    digest.status.clear();
    for (const FaceStatus status : contact.statuses()) digest.status.push_back(static_cast<std::int8_t>(status));
    digest.multiplier.assign(traction.begin(), traction.begin() + contact.multipliers());
    digest.status_changes = contact.status_changes();
    digest.contact.assign(patch.contact_at.size(), {});
    for (std::size_t t = 0; t < patch.contact_at.size(); ++t)
        for (const double distance : patch.contact_at[t])
            digest.contact[t].push_back(
                contact.contact_behind(faces_behind(tips, t, distance), traction, jumps, displacement));
    digest.opening.clear();
    for (std::size_t t = 0; t < patch.opening_at.size(); ++t)
        digest.opening.push_back(opening_behind(patch, frozen, displacement, t));
    digest.nearest.assign(patch.slip_at.size(), {});
    for (std::size_t t = 0; t < patch.slip_at.size(); ++t)
        for (const double distance : patch.slip_at[t])
            digest.nearest[t].push_back(
                contact.nearest_behind(faces_behind(tips, t, distance), traction, jumps, smallest_slip));
}

std::vector<TipRings> rings_of(const coupling::Patch& patch, const Materials& materials,
                               const std::vector<CrackSection>& cracks, int subcells, std::vector<TipRings> before) {
    std::vector<TipRings> all;
    std::vector<int> elements(patch.mesh.elements.size());
    std::iota(elements.begin(), elements.end(), 0);
    for (int t = 0; t < std::ssize(patch.mesh.tips); ++t) {
        const Tip& tip = patch.mesh.tips[at(t)];
        std::vector<Annulus> annuli;
        std::vector<int> numbers;
        double element = 0.0;
        for (const coupling::Ring& ring : patch.rings) {
            if (ring.tip != t) continue;
            annuli.push_back({ring.inner_radius, ring.outer_radius});
            numbers.push_back(ring.number);
            element = ring.element;
        }
        const bool with_inside = materials.initial_stress().any() || materials.count() > 1;
        const CrackSection& crack = cracks[at(tip.crack)];
        const EnergyDensity density =
            has_grown(tip, crack, element) ? EnergyDensity::Elastic : EnergyDensity::StressWork;
        all.push_back(
            {.sums = {patch.mesh, tip, materials.elastic(tip.material), std::move(annuli), elements, with_inside},
             .numbers = std::move(numbers),
             .stations = {},
             .density = density,
             .answers = at(t) < before.size() ? std::move(before[at(t)].answers) : ElasticAnswers()});
        if (!may_touch(crack)) continue;
        std::vector<FaceStation>& stations = all.back().stations = face_stations_about(patch.mesh, tip, subcells, 4);
        const Notch notch = notch_of(crack, patch.mesh.grown_at_start_of(tip.crack));
        std::erase_if(stations, [&](const FaceStation& station) { return notch.holds(station.s); });
    }
    return all;
}

namespace {

/// One per tip of the mesh.
std::vector<coupling::TipReport> report_tips(const CommittedZone& zone) {
    const EnrichedMesh& mesh = zone.patch.mesh;
    std::vector<coupling::TipReport> reports(mesh.tips.size());
    std::vector<BulkSummary::PlasticExtent> extents = zone.summary.plastic_extents(mesh);
    for (std::size_t t = 0; t < reports.size(); ++t) {
        reports[t].CTOD = opening_at_intercept(mesh, mesh.tips[t],
                                               [&](const FaceStation& station) { return opening(zone, station); });
        if (!zone.patch.opening_at.empty())
            reports[t].opening = opening_behind(zone.patch, zone.frozen, zone.displacement, t);
        reports[t].flow = std::move(extents[t].flow);
        reports[t].flow_ever = std::move(extents[t].flow_ever);
    }
    return reports;
}

/// One per ring of the patch, tip by tip.
std::vector<coupling::RingReport> report_rings(const CommittedZone& zone, std::vector<TipRings>& rings) {
    std::vector<coupling::RingReport> reports;
    for (int t = 0; t < std::ssize(rings); ++t) {
        auto& [sums, numbers, stations, density, answers] = rings[at(t)];
        if (numbers.empty()) continue;
        sums.clear();
        add_to(sums, zone.bulk, density, answers);
        add_tractions(sums, zone, stations);
        for (std::size_t k = 0; k < numbers.size(); ++k) reports.push_back({t, numbers[k], sums.values()[k]});
    }
    return reports;
}

using Tractions = std::vector<ContactInterface::FaceTraction>;  // of the contact's stations

/// One per station that may touch, by crack and arc length, and those of free faces behind them.
std::vector<coupling::FaceSample> report_faces(const CommittedZone& zone, const Tractions& tractions) {
    std::vector<coupling::FaceSample> samples;
    const FaceOperators& faces = zone.contact.operators();
    for (std::size_t k = 0; k < tractions.size(); ++k)
        samples.push_back(touching_sample_at(zone, faces.stations()[k], tractions[k]));
    for (const FaceStation& station : faces.free_stations()) samples.push_back(sample_at(zone, station));
    return samples;
}

/// Length that bears load, mm, one per crack: faces of a body that is free of load touch, and rounding presses them.
std::vector<double> contact_lengths(const CommittedZone& zone, const Tractions& tractions, std::size_t cracks) {
    std::vector<double> lengths(cracks, 0.0);
    for (std::size_t k = 0; k < tractions.size(); ++k) {
        const FaceStation& station = zone.contact.operators().stations()[k];
        if (tractions[k].pressure > zone.rounding) lengths[at(station.crack)] += station.weight;
    }
    return lengths;
}

/// Opening where each crack meets the boundary, mm: NaN where it has two tips, or the zone does not hold that end.
std::vector<double> mouth_openings(const CommittedZone& zone, std::size_t cracks) {
    const EnrichedMesh& mesh = zone.patch.mesh;
    std::vector<double> openings(cracks, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t crack = 0; crack < cracks; ++crack) {
        const FaceStation mouth = face_station_at_mouth(mesh, static_cast<int>(crack));
        if (!mouth.terms.empty()) openings[crack] = opening(zone, mouth);
    }
    return openings;
}

}  // namespace

void report_on(const CommittedZone& zone, std::vector<TipRings>& rings, std::size_t cracks,
               const coupling::Commit& what, coupling::StepReport& report) {
    report.tips = report_tips(zone);
    const Tractions tractions = zone.contact.tractions_at_stations(zone.traction);
    report.contact_length = contact_lengths(zone, tractions, cracks);
    report.mouth_opening = mouth_openings(zone, cracks);
    if (!what.brief) report.rings = report_rings(zone, rings);
    if (!what.no_faces) report.faces = report_faces(zone, tractions);
}

}  // namespace stria::fine
