#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "coarse/mesh_file/mesh_file.hpp"
#include "coarse/specimen/compact_tension.hpp"
#include "coarse/specimen/crack_rows.hpp"
#include "coarse/specimen/handbook.hpp"
#include "coarse/specimen/structured.hpp"
#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

constexpr std::array catalogue{
    Specimen{"sent", rectangle, rectangle_mesh, sent_K, sent_limit_load},  // a crack from the left edge
    Specimen{"mt", rectangle, rectangle_mesh, mt_K, mt_limit_load},        // one across the middle of the width
    Specimen{"ct", compact_tension, compact_tension_mesh, ct_K, ct_limit_load},
    Specimen{"plate", rectangle, rectangle_mesh, nullptr, nullptr},  // cracks anywhere
};

std::string text_of(const Body& body) {
    return fmt::format("[{}, {}] x [{}, {}] mm", body.low.x(), body.high.x(), body.low.y(), body.high.y());
}

/// Does the segment run through the interior? Liang and Barsky's clipping; what is left must have a middle inside.
bool crosses_interior(const Vec2& from, const Vec2& to, const Body& body) {
    double enter = 0.0, leave = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double step = to[axis] - from[axis];
        if (step == 0.0) continue;
        const double at_low = (body.low[axis] - from[axis]) / step, at_high = (body.high[axis] - from[axis]) / step;
        enter = std::max(enter, std::min(at_low, at_high));
        leave = std::min(leave, std::max(at_low, at_high));
    }
    const Vec2 middle = from + 0.5 * (enter + leave) * (to - from);
    return enter < leave && body.holds_inside(middle);
}

/// What no mesh can tell from nothing: a crack, or what of it lies in the body, shorter than rounding lets it be.
void require_length(const CrackSection& crack, const std::string& key, const Body& body) {
    const double least = smallest_edge * (body.high - body.low).maxCoeff();
    double length = length_of(crack.points);
    for (const Vec2& end : {crack.points.front(), crack.points.back()})
        if (body.holds_inside(end))
            length = std::min({length, (end - body.low).minCoeff(), (body.high - end).minCoeff()});
    if (length < least)
        throw CaseError(fmt::format("{}: the crack is {:.3g} mm long in the body, less than an element at its tip can "
                                    "be, {:.3g} mm",
                                    key, length, least));
}

void require_in_body(const CrackSection& crack, const std::string& key, const Body& body) {
    bool meets_body = false;
    for (std::size_t k = 0; k < crack.points.size(); ++k) {
        const Vec2& point = crack.points[k];
        const bool end = k == 0 || k + 1 == crack.points.size();
        if (!end && !body.holds(point)) {
            throw CaseError(
                fmt::format("{}: point {} ({}, {}) is outside the body {}; only the first and the last point may be (a "
                            "mouth)",
                            key, k, point.x(), point.y(), text_of(body)));
        }
        if (k > 0) meets_body = meets_body || crosses_interior(crack.points[k - 1], point, body);
    }
    require_length(crack, key, body);
    if (!meets_body) {
        throw CaseError(fmt::format("{}: the crack does not run through the body {}", key, text_of(body)));
    }
}

/// The insert stays elastic and is never in the zone: what a crack needs.
void spare_insert(const CrackSection& crack, const std::string& key, const Mesh& mesh) {
    for (const int element : mesh.insert) {
        const auto corners = corners_of_element(mesh, element);
        Body cell{corners[0], corners[0]};  // elements beside a hole are no rectangles
        for (const Vec2& corner : corners) cell = {cell.low.cwiseMin(corner), cell.high.cwiseMax(corner)};
        for (std::size_t k = 1; k < crack.points.size(); ++k) {
            if (!crosses_interior(crack.points[k - 1], crack.points[k], cell)) continue;
            throw CaseError(fmt::format("{}: the crack runs through the insert of a pin, near ({:.4g}, {:.4g})", key,
                                        cell.low.x(), cell.low.y()));
        }
    }
}

std::vector<Vec2> points_in(const Body& body, const std::vector<BoundarySection>& boundaries) {
    std::vector<Vec2> points;
    for (const BoundarySection& boundary : boundaries)
        if (boundary.on == "point" && boundary.at && body.holds(*boundary.at)) points.push_back(*boundary.at);
    return points;
}

/// Points that are all nodes already change nothing. Lines through others would move a node that is where it is by
/// chance: then all get theirs.
Mesh mesh_with_points(const Specimen& specimen, const MeshSection& section, MeshLines lines,
                      const std::vector<Vec2>& points) {
    Mesh mesh = specimen.mesh(section, lines);
    const auto is_node = [&](const Vec2& point) { return is_at(mesh, nearest_node(mesh, point), point); };
    if (std::ranges::all_of(points, is_node)) return mesh;
    for (const Vec2& point : points)
        for (const int axis : {0, 1}) lines[at(axis)].push_back(point[axis]);
    keep_each_once(lines);
    return specimen.mesh(section, lines);
}

}  // namespace

const Specimen& find_specimen(std::string_view name) {
    const auto found =
        std::find_if(catalogue.begin(), catalogue.end(), [&](const Specimen& s) { return s.name == name; });
    if (found != catalogue.end()) return *found;
    std::vector<std::string_view> names;
    for (const Specimen& specimen : catalogue) names.push_back(specimen.name);
    throw CaseError(
        fmt::format("mesh.specimen: \"{}\" is not in the catalogue, available: {}", name, fmt::join(names, ", ")));
}

Mesh make_mesh(const MeshSection& section, const std::vector<CrackSection>& cracks,
               const std::vector<RegionSection>& regions, const std::vector<BoundarySection>& boundaries) {
    if (section.file) return read_mesh_file(*section.file);
    const Specimen& specimen = find_specimen(section.specimen);
    const Body body = specimen.body(section);
    Mesh mesh = mesh_with_points(specimen, section, lines_of(regions), points_in(body, boundaries));
    for (std::size_t k = 0; k < cracks.size(); ++k) {
        const std::string key = fmt::format("crack.{}.points", k);
        require_in_body(cracks[k], key, body);
        spare_insert(cracks[k], key, mesh);
    }
    move_off_bends(mesh, cracks);
    return mesh;
}

}  // namespace stria::coarse
