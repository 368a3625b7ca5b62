#include "coarse/fracture/face_tractions.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "common/case/case_questions.hpp"
#include "common/index.hpp"
#include "common/integration/crack_faces.hpp"

namespace stria::coarse {
namespace {

constexpr int points_per_piece = 4;  // of an interface element, as in a zone

}  // namespace

FaceTractions tractions_of(std::vector<coupling::FaceSample> faces) {
    std::ranges::sort(faces, {}, [](const coupling::FaceSample& face) { return std::tuple(face.crack, face.s); });
    FaceTractions tractions;
    for (const coupling::FaceSample& face : faces) {
        tractions.crack.push_back(face.crack);
        tractions.s.push_back(face.s);
        tractions.pressure.push_back(face.pressure);
        tractions.shear.push_back(face.shear);
        tractions.in_wake.push_back(face.in_wake ? 1 : 0);
    }
    return tractions;
}

FaceTractions::Traction FaceTractions::at(int of_crack, double place) const {
    const auto [from, to] = std::ranges::equal_range(crack, of_crack);
    if (from == to) return {};
    const auto first = s.begin() + (from - crack.begin()), last = s.begin() + (to - crack.begin());
    const auto next = std::clamp(std::lower_bound(first, last, place), first, last - 1);
    const std::size_t k = stria::at(next - s.begin()), before = next == first || place > *next ? k : k - 1;
    const double way = before == k ? 0.0 : (place - s[before]) / (s[k] - s[before]);
    return {std::lerp(pressure[before], pressure[k], way), std::lerp(shear[before], shear[k], way)};
}

void leave_out_wedges(FaceTractions& tractions, const EnrichedMesh& mesh, const Eigen::VectorXd& u) {
    for (std::size_t k = 0; k < tractions.s.size(); ++k) {
        if (tractions.in_wake[k] == 0 || tractions.pressure[k] == 0.0) continue;
        const bool overlaps = face_station_at(mesh, tractions.crack[k], tractions.s[k]).opening(u) < 0.0;
        if (!overlaps) tractions.pressure[k] = 0.0;
    }
}

Eigen::VectorXd forces_of(const FaceTractions& tractions, const Scene& scene) {
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    const int subcells = subcells_at_crack(scene.input.fine);
    for (int crack = 0; crack < std::ssize(scene.input.cracks); ++crack)
        for (const FaceStation& station : face_stations(scene.enriched, crack, subcells, points_per_piece)) {
            const auto [pressure, shear] = tractions.at(crack, station.s);
            const Vec2 force = station.weight * (pressure * station.normal - shear * station.tangent);
            for (const FaceStation::Term& term : station.terms) forces.segment<2>(term.unknown) += term.value * force;
        }
    return forces;
}

DomainIntegral interactions_of(const FaceTractions& tractions, const Scene& scene, int tip, const Annulus& ring) {
    const Tip& about = scene.enriched.tips[at(tip)];
    RingSums sums(scene.enriched, about, scene.elastic(about), {ring}, {});
    const int subcells = subcells_at_crack(scene.input.fine);
    for (const FaceStation& station : face_stations_about(scene.enriched, about, subcells, points_per_piece)) {
        const auto [pressure, shear] = tractions.at(station.crack, station.s);
        sums.add_faces(station, {.pressure = pressure, .shear = shear, .opening_slope = 0.0, .slip_slope = 0.0});
    }
    return sums.values().front();
}

}  // namespace stria::coarse
