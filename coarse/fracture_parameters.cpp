#include "coarse/fracture_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "coarse/zone_selection.hpp"
#include "common/fem/crack_faces.hpp"

namespace stria::coarse {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// From the load line where the specimen has one; else arc length from the mouth, or half of it with two tips.
double crack_length(const Scene& scene, const Tip& tip) {
    if (scene.mesh.load_line) return tip.position.x() - *scene.mesh.load_line;
    const EnrichedMesh& mesh = scene.enriched;
    double first = 1e300, last = -1e300;
    int tips = 0;
    for (const CrackPiece& piece : mesh.pieces) {
        if (piece.crack != tip.crack) continue;
        first = std::min(first, piece.s.front());
        last = std::max(last, piece.s.back());
    }
    for (const Tip& other : mesh.tips) tips += other.crack == tip.crack ? 1 : 0;
    return (last - first) / tips;
}

/// Opening at the crack's first point in the body, where the structure holds it.
double mouth_opening(const Structure& structure, int crack, const Eigen::VectorXd& u) {
    for (const CrackPiece& piece : structure.scene().enriched.pieces) {
        if (piece.crack != crack) continue;
        if (structure.in_zone()[at(piece.element)] != 0 || piece.entry < 0.0) break;
        return face_station_at(structure.scene().enriched, crack, piece.s.front()).opening(u);
    }
    return std::nan("");
}

}  // namespace

std::vector<TipResult> fracture_parameters(const Structure& structure, const Eigen::VectorXd& u,
                                           const coupling::StepReport& report) {
    const Scene& scene = structure.scene();
    const EnrichedMesh& mesh = scene.enriched;
    const double half_modulus = scene.elastic.plane_modulus() / 2.0;
    std::vector<TipResult> results;
    for (int t = 0; t < static_cast<int>(mesh.tips.size()); ++t) {
        const Tip& tip = mesh.tips[at(t)];
        const double outer = largest_ring(scene, t);
        const Eigen::VectorXd q = ring_weight(mesh.nodes, tip, ring_inner_fraction * outer, outer);
        DomainIntegral sum = structure.ring_integral(tip, q, u, true, true);
        TipResult result;
        result.a = crack_length(scene, tip);
        result.CTOD = std::nan("");
        result.CMOD = mouth_opening(structure, tip.crack, u);
        if (!report.tips.empty()) {
            const coupling::TipReport& zone = report.tips[at(t)];
            sum += {zone.J, zone.interaction_I, zone.interaction_II};
            if (zone.CTOD >= 0.0) result.CTOD = zone.CTOD;
            result.plastic_zone = zone.plastic_zone;
            result.plastic_zone_axis = zone.plastic_zone_axis;
            result.contact_length = report.contact_length[at(tip.crack)];
            if (std::isfinite(report.mouth_opening[at(tip.crack)])) result.CMOD = report.mouth_opening[at(tip.crack)];
        } else {
            const double opening = opening_at_intercept(mesh, tip, u);
            if (opening >= 0.0) result.CTOD = opening;
        }
        result.J = sum.J;
        result.K_I = half_modulus * sum.interaction_I;
        result.K_II = half_modulus * sum.interaction_II;
        results.push_back(result);
    }
    return results;
}

std::vector<coupling::FaceSample> face_samples(const Structure& structure, const Eigen::VectorXd& u,
                                               const coupling::StepReport& report) {
    const EnrichedMesh& mesh = structure.scene().enriched;
    std::vector<coupling::FaceSample> samples = report.faces;
    for (int crack = 0; crack < static_cast<int>(structure.scene().input.cracks.size()); ++crack) {
        for (const FaceStation& station : face_stations(mesh, crack, 1, 4)) {
            if (structure.in_zone()[at(station.element)] != 0) continue;
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

}  // namespace stria::coarse
