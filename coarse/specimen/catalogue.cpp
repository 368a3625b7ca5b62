#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "coarse/specimen/specimen.hpp"
#include "coarse/specimen/structured.hpp"
#include "common/error.hpp"

namespace stria::coarse {
namespace {

constexpr std::array catalogue{
    Specimen{"sent", "single-edge-notched plate, crack from the left edge", rectangle_mesh, sent_handbook_K},
    Specimen{"plate", "rectangular plate, cracks anywhere", rectangle_mesh, nullptr},
};

bool strictly_inside(const Point& point, const MeshSection& body) {
    return 0.0 < point.x() && point.x() < body.width && 0.0 < point.y() && point.y() < body.height;
}

bool inside_or_on(const Point& point, const MeshSection& body) {
    return 0.0 <= point.x() && point.x() <= body.width && 0.0 <= point.y() && point.y() <= body.height;
}

/// Does the segment run through the interior? Liang and Barsky's clipping; what is left must have a middle inside.
bool crosses_interior(const Point& from, const Point& to, const MeshSection& body) {
    const Point limit{body.width, body.height};
    double enter = 0.0, leave = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double step = to[axis] - from[axis];
        if (step == 0.0) continue;
        const double at_low = -from[axis] / step, at_high = (limit[axis] - from[axis]) / step;
        enter = std::max(enter, std::min(at_low, at_high));
        leave = std::min(leave, std::max(at_low, at_high));
    }
    const Point middle = from + 0.5 * (enter + leave) * (to - from);
    return enter < leave && strictly_inside(middle, body);
}

void validate(const CrackSection& crack, const std::string& key, const MeshSection& body) {
    if (crack.points.size() < 2) throw CaseError(key + ": a crack is a polyline of two points or more");
    bool meets_body = false;
    for (std::size_t k = 0; k < crack.points.size(); ++k) {
        const Point& point = crack.points[k];
        const bool end = k == 0 || k + 1 == crack.points.size();
        if (!point.allFinite()) throw CaseError(fmt::format("{}: point {} is not finite", key, k + 1));
        if (!end && !inside_or_on(point, body)) {
            throw CaseError(
                fmt::format("{}: point {} ({}, {}) is outside the body [0, {}] x [0, {}] mm; only the first "
                            "and the last point may be (a mouth)",
                            key, k + 1, point.x(), point.y(), body.width, body.height));
        }
        if (k == 0) continue;
        if (point == crack.points[k - 1])
            throw CaseError(fmt::format("{}: point {} repeats the one before", key, k + 1));
        meets_body = meets_body || crosses_interior(crack.points[k - 1], point, body);
    }
    if (!meets_body) {
        throw CaseError(fmt::format("{}: the crack does not run through the body [0, {}] x [0, {}] mm", key, body.width,
                                    body.height));
    }
}

}  // namespace

std::span<const Specimen> specimens() { return catalogue; }

const Specimen& find_specimen(std::string_view name) {
    const auto found =
        std::find_if(catalogue.begin(), catalogue.end(), [&](const Specimen& s) { return s.name == name; });
    if (found != catalogue.end()) return *found;
    std::vector<std::string_view> names;
    for (const Specimen& specimen : catalogue) names.push_back(specimen.name);
    throw CaseError(
        fmt::format("mesh.specimen: \"{}\" is not in the catalogue, available: {}", name, fmt::join(names, ", ")));
}

double sent_handbook_K(double width, double a, double stress) {
    const double x = a / width, half_angle = 0.5 * std::numbers::pi * x;
    const double polynomial = 0.752 + 2.02 * x + 0.37 * std::pow(1.0 - std::sin(half_angle), 3);
    const double F = std::sqrt(std::tan(half_angle) / half_angle) * polynomial / std::cos(half_angle);
    return F * stress * std::sqrt(std::numbers::pi * a);
}

Mesh make_mesh(const Case& scene) {
    Mesh mesh = find_specimen(scene.mesh.specimen).mesh(scene.mesh);
    for (std::size_t k = 0; k < scene.cracks.size(); ++k) {
        validate(scene.cracks[k], fmt::format("crack[{}].points", k + 1), scene.mesh);
    }
    return mesh;
}

}  // namespace stria::coarse
