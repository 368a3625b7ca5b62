#include "coarse/fracture/handbook_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/specimen/handbook.hpp"
#include "coarse/specimen/specimen.hpp"
#include "common/case/loads/load_case_checks.hpp"
#include "common/integration/crack_faces.hpp"

namespace stria::coarse {
namespace {

/// Straight, across the width, at mid-height; of mt with both tips equally far from the sides.
bool is_standard_crack(const Scene& scene) {
    if (scene.input.cracks.size() != 1 || scene.enriched.tips.empty()) return false;
    const std::vector<Vec2>& points = scene.input.cracks.front().points;
    const Body body = find_specimen(scene.input.mesh.specimen).body(scene.input.mesh);
    const Vec2 middle = 0.5 * (body.low + body.high);
    const double tolerance = 1e-6 * (body.high.x() - body.low.x());
    const bool level =
        std::ranges::all_of(points, [&](const Vec2& x) { return std::abs(x.y() - middle.y()) <= tolerance; });
    const auto tips = scene.enriched.tips.size();
    if (scene.input.mesh.specimen != "mt") return level && tips == 1 && points.front().x() < points.back().x();
    return level && tips == 2 && std::abs(points.front().x() + points.back().x() - 2.0 * middle.x()) <= tolerance;
}

/// Opposite forces along y at both pins, or opposite uniform tractions along y on both ends; otherwise only points
/// held.
bool is_standard_load(const Scene& scene) {
    double above = 0.0, below = 0.0;
    for (const BoundarySection& section : scene.input.boundaries) {
        if (!is_of_main_load(section)) continue;
        const bool held = section.displacement[0] || section.displacement[1];
        if (section.on == "point" && !section.force) continue;
        const bool top = section.on == "top" || section.on == "pin-top";
        const bool bottom = section.on == "bottom" || section.on == "pin-bottom";
        const bool graded = section.pressure || !section.traction_gradient.isZero(0.0);
        if (held || graded || (!top && !bottom)) return false;
        const Vec2 load = section.force.value_or(section.traction.value_or(Vec2::Zero()));
        if (load.x() != 0.0) return false;
        if ((scene.input.mesh.specimen == "ct") != section.force.has_value()) return false;
        (top ? above : below) += load.y();
    }
    // One end may be held at a point instead.
    return (above > 0.0 || below < 0.0) && above >= 0.0 && below <= 0.0;
}

/// Opening at x, per unit load factor.
double opening_at(const Scene& scene, double x, const Eigen::VectorXd& u) {
    const FaceStation station = face_station_at(scene.enriched, 0, x - scene.input.cracks.front().points.front().x());
    return station.terms.empty() ? std::nan("") : station.opening(u);
}

}  // namespace

std::vector<HandbookLine> compare_with_handbook(const NominalSolution& nominal) {
    const Scene& scene = nominal.structure->scene();
    if (scene.input.mesh.file) return {};
    const std::vector<TipResult>& tips = nominal.tips;
    const Specimen& specimen = find_specimen(scene.input.mesh.specimen);
    const auto loaded = loaded_boundary(scene.mesh, scene.input, scene.loads);
    if (!scene.input.regions.empty()) return {};
    if (specimen.handbook_K == nullptr || !loaded || !is_standard_crack(scene) || !is_standard_load(scene)) return {};

    const double load = loaded->resultant.norm(), width = scene.input.mesh.width, a = tips.front().a;
    const double modulus = scene.elastic(scene.enriched.tips.front()).plane_modulus();
    std::vector<HandbookLine> lines;
    const double K = specimen.handbook_K(width, a, load);
    lines.push_back({"K_I at the load factor 1", "MPa sqrt(mm)", K, tips.front().K_I});
    lines.push_back({"J at the load factor 1", "N/mm", K * K / modulus, tips.front().J});
    if (scene.mesh->load_line) {
        const double per_load = modulus / load;
        lines.push_back({"compliance E' B v / P on the load line", "", ct_load_line_compliance(a / width),
                         per_load * opening_at(scene, 0.0, nominal.fields.unit)});
        lines.push_back({"compliance E' B v / P on the front face", "", ct_front_face_compliance(a / width),
                         per_load * tips.front().CMOD});
    }
    if (scene.input.material.yield_stress) {
        const double limit =
            specimen.limit_load(width, a, *scene.input.material.yield_stress, scene.input.model.plane) / load;
        lines.push_back({"limit load without hardening, as a load factor", "", limit, std::nan("")});
    }
    return lines;
}

}  // namespace stria::coarse
