#include "coarse/fracture/fracture_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/model/reported_length.hpp"
#include "coarse/model/rings.hpp"
#include "common/case/case_questions.hpp"
#include "common/index.hpp"
#include "common/integration/crack_faces.hpp"
#include "coupling/flow_shells.hpp"

namespace stria::coarse {
namespace {

/// NaN where the zone holds the place, or no crack.
double opening_at(const CoarseElements& structure, const FaceStation& station, const Eigen::VectorXd& u) {
    const bool is_elsewhere = station.terms.empty() || structure.in_zone().contains(station.element);
    return is_elsewhere ? std::nan("") : station.opening(u);
}

TipResult at_place_of(const Scene& scene, const Tip& tip) {
    TipResult result;
    result.a = reported_length(scene, tip);
    result.x = tip.position.x();
    result.y = tip.position.y();
    result.way = way_to_tip(scene, tip);
    result.CTOD = std::nan("");
    return result;
}

/// One ring's parameters.
struct RingValues {
    double J, K_I, K_II, K_I_of_wake, K_II_of_wake, T_stress;
};

RingValues values_of(const DomainIntegral& of_ring, double plane_modulus) {
    const DomainIntegral sum = of_ring.without_rotation();
    const double K = plane_modulus / 2.0;  // of an interaction
    return {.J = sum.J,
            .K_I = K * sum.interaction_I,
            .K_II = K * sum.interaction_II,
            .K_I_of_wake = K * sum.wake_I,
            .K_II_of_wake = K * sum.wake_II,
            .T_stress = plane_modulus * sum.interaction_T};
}

std::vector<RingValues> values_on(int t, const Scene& scene, std::vector<DomainIntegral> total,
                                  const coupling::StepReport& report) {
    for (const coupling::RingReport& share : report.rings) {
        if (share.tip == t) total[at(share.number)] += share.sums;
    }
    const double modulus = scene.elastic(scene.enriched.tips[at(t)]).plane_modulus();
    std::vector<RingValues> values;
    for (const DomainIntegral& of_ring : total) values.push_back(values_of(of_ring, modulus));
    return values;
}

/// Largest less smallest over a scale; nothing to say with fewer than two rings or without a scale.
double spread(std::span<const RingValues> rings, double RingValues::*value, double scale) {
    if (rings.size() < 2 || scale == 0.0) return std::nan("");
    const auto [least, most] = std::ranges::minmax(rings, {}, value);
    return (most.*value - least.*value) / std::abs(scale);
}

/// J from the first ring that tells it, whatever has flowed in it. K and T from the first ring in which nothing has
/// flowed, or, failing that, from the one that begins farthest out, of those that tell K; their spread over such rings
/// alone.
void put_rings(const std::vector<Annulus>& rings, const std::vector<RingValues>& values,
               const std::vector<coupling::FlowShell>& flow_ever, TipResult& result) {
    std::vector<RingValues> for_J, elastic;
    for (std::size_t k = 0; k < rings.size(); ++k) {
        if (rings[k].tells_J) for_J.push_back(values[k]);
        const auto misses = [&](const coupling::FlowShell& shell) {
            return shell.reach <= rings[k].inner || shell.begin >= rings[k].outer;
        };
        if (rings[k].tells_K && std::ranges::all_of(flow_ever, misses)) elastic.push_back(values[k]);
    }
    result.J = for_J.empty() ? std::nan("") : for_J.front().J;
    result.J_spread = spread(for_J, &RingValues::J, result.J);
    result.rings_flow = elastic.empty();
    const auto farthest = std::ranges::max_element(rings, {}, &Annulus::inner) - rings.begin();
    const RingValues& chosen = elastic.empty() ? values[at(farthest)] : elastic.front();
    result.K_I = chosen.K_I;
    result.K_II = chosen.K_II;
    result.K_I_of_wake = chosen.K_I_of_wake;
    result.K_II_of_wake = chosen.K_II_of_wake;
    result.T_stress = chosen.T_stress;
    const double K = std::hypot(chosen.K_I, chosen.K_II);
    result.K_spread = std::max(spread(elastic, &RingValues::K_I, K), spread(elastic, &RingValues::K_II, K));
}

/// What a zone reports of a tip, and openings where the structure holds them.
void put_openings(const CoarseElements& structure, int t, const Eigen::VectorXd& u, const coupling::StepReport& report,
                  std::span<const double> behind, TipResult& result) {
    const EnrichedMesh& mesh = structure.scene().enriched;
    const Tip& tip = mesh.tips[at(t)];
    result.CMOD = opening_at(structure, face_station_at_mouth(mesh, tip.crack), u);
    if (!behind.empty()) result.opening = opening_at(structure, face_station_behind(mesh, tip, behind[at(t)]), u);
    if (report.tips.empty()) {
        const double intercept = opening_at_intercept(mesh, tip, u);
        if (intercept >= 0.0) result.CTOD = intercept;
        return;
    }
    const coupling::TipReport& zone = report.tips[at(t)];
    if (zone.CTOD >= 0.0) result.CTOD = zone.CTOD;
    if (std::isfinite(zone.opening)) result.opening = zone.opening;
    const coupling::FlowShell own = coupling::shell_at_tip(zone.flow, tip_element_size(mesh, tip));
    result.plastic_zone = own.reach;
    result.plastic_zone_axis = own.axis;
    result.contact_length = report.contact_length[at(tip.crack)];
    if (std::isfinite(report.mouth_opening[at(tip.crack)])) result.CMOD = report.mouth_opening[at(tip.crack)];
}

}  // namespace

std::vector<double> openings(const std::vector<TipResult>& tips) {
    std::vector<double> openings;
    for (const TipResult& tip : tips) openings.push_back(tip.opening);
    return openings;
}

std::vector<TipResult> fracture_parameters(const Structure& structure, const Eigen::VectorXd& u,
                                           const coupling::StepReport& report) {
    const StructureRings rings(structure.elements());
    return fracture_parameters(rings, u, rings.integrals(u), report);
}

std::vector<TipResult> fracture_parameters(const StructureRings& rings, const Eigen::VectorXd& u,
                                           const RingIntegrals& own, const coupling::StepReport& report,
                                           std::span<const double> behind) {
    const Scene& scene = rings.elements().scene();
    std::vector<TipResult> results;
    for (int t = 0; t < std::ssize(scene.enriched.tips); ++t) {
        TipResult result = at_place_of(scene, scene.enriched.tips[at(t)]);
        put_openings(rings.elements(), t, u, report, behind, result);
        const auto flow_ever = report.tips.empty() ? std::vector<coupling::FlowShell>() : report.tips[at(t)].flow_ever;
        put_rings(rings.about(t).rings(), values_on(t, scene, own[at(t)], report), flow_ever, result);
        results.push_back(result);
    }
    return results;
}

std::vector<TipResult> nominal_K(const StructureRings& rings, const Eigen::VectorXd& u, const FaceTractions* on_faces) {
    const Scene& scene = rings.elements().scene();
    std::vector<TipResult> results;
    for (int t = 0; t < std::ssize(scene.enriched.tips); ++t) {
        const Tip& tip = scene.enriched.tips[at(t)];
        DomainIntegral sum = rings.about(t).of_K(u);
        const std::vector<Annulus>& annuli = rings.about(t).rings();
        if (on_faces != nullptr) sum += interactions_of(*on_faces, scene, t, annuli[first_for_K(annuli)]);
        const RingValues values = values_of(sum, scene.elastic(tip).plane_modulus());
        results.push_back(at_place_of(scene, tip));
        results.back().J = results.back().J_spread = results.back().K_spread = results.back().CMOD = std::nan("");
        results.back().K_I = values.K_I;
        results.back().K_II = values.K_II;
        results.back().T_stress = values.T_stress;
    }
    return results;
}

std::vector<coupling::FaceSample> face_samples(const Structure& structure, const Eigen::VectorXd& u,
                                               const coupling::StepReport& report) {
    const EnrichedMesh& mesh = structure.scene().enriched;
    std::vector<coupling::FaceSample> samples = report.faces;
    for (int crack = 0; crack < static_cast<int>(structure.scene().input.cracks.size()); ++crack) {
        for (const FaceStation& station : face_stations(mesh, crack, 1, 4)) {
            if (structure.in_zone().contains(station.element)) continue;
            samples.push_back({.crack = crack,
                               .s = station.s,
                               .x = station.x.x(),
                               .y = station.x.y(),
                               .opening = station.opening(u),
                               .slip = station.slip(u)});
        }
    }
    std::ranges::stable_sort(samples, {}, [](const coupling::FaceSample& s) { return std::tuple(s.crack, s.s); });
    return samples;
}

const coupling::FaceSample* deepest_overlap(const std::vector<coupling::FaceSample>& faces,
                                            const std::vector<CrackSection>& cracks) {
    constexpr double rounding = 1e-9, share = 1e-3, alike = 1e-6;  // mm; shares
    const coupling::FaceSample* deepest = nullptr;
    double largest = 0.0;
    for (const coupling::FaceSample& sample : faces) {
        if (may_touch(cracks[at(sample.crack)])) continue;
        largest = std::max(largest, std::abs(sample.opening));
        if (deepest == nullptr || sample.opening < deepest->opening - alike * std::abs(deepest->opening))
            deepest = &sample;
    }
    return deepest != nullptr && -deepest->opening > std::max(rounding, share * largest) ? deepest : nullptr;
}

}  // namespace stria::coarse
