#include "app/report/fields/outline.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "common/index.hpp"

namespace stria::report {

namespace {

using Place = std::pair<std::int64_t, std::int64_t>;  // a point, in units of `fineness`
using Edge = std::pair<Place, Place>;                 // the body lies on its left

constexpr double fineness = 1e-7;  // mm: points nearer than that are one

Place place_of(FieldPoint point) { return {std::llround(point.x / fineness), std::llround(point.y / fineness)}; }

FieldPoint point_at(const Place& place) {
    return {fineness * static_cast<double>(place.first), fineness * static_cast<double>(place.second)};
}

double cross(FieldPoint a, FieldPoint b, FieldPoint c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

double area_of(const std::vector<FieldPoint>& polygon) {
    double twice = 0.0;
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k) twice += cross(polygon[0], polygon[k], polygon[k + 1]);
    return 0.5 * twice;
}

/// Without the corners at which it goes straight on.
std::vector<FieldPoint> corners_of(const std::vector<FieldPoint>& polygon) {
    std::vector<FieldPoint> corners;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const FieldPoint &before = polygon[(k + polygon.size() - 1) % polygon.size()], &here = polygon[k],
                         &after = polygon[(k + 1) % polygon.size()];
        const double length = std::hypot(after.x - before.x, after.y - before.y);
        if (std::abs(cross(before, here, after)) > 10.0 * fineness * length) corners.push_back(here);
    }
    return corners;
}

/// Edges less those that another cell passes the other way.
class OpenEdges {
public:
    void pass(const Place& a, const Place& b) {
        if (a == b) return;
        if (const auto back = edges_.find({b, a}); back != edges_.end())
            edges_.erase(back);
        else
            edges_.insert({a, b});
    }

    /// Where nodes hang on an edge, it is passed from node to node.
    void split_at_hanging_nodes() {
        std::set<Place> ends;
        for (const auto& [a, b] : edges_) ends.insert(a);
        OpenEdges parts;
        for (const auto& [a, b] : edges_) {
            Place from = a;
            for (const Place& node : on_edge(a, b, ends)) {
                parts.pass(from, node);
                from = node;
            }
            parts.pass(from, b);
        }
        edges_ = std::move(parts.edges_);
    }

    /// Takes one polygon out; empty when none is left.
    std::vector<FieldPoint> take_polygon() {
        std::vector<FieldPoint> polygon;
        auto edge = edges_.begin();
        while (edge != edges_.end()) {
            polygon.push_back(point_at(edge->first));
            const Place next = edge->second;
            edges_.erase(edge);
            edge = edges_.lower_bound({next, {INT64_MIN, INT64_MIN}});
            if (edge != edges_.end() && edge->first != next) break;
        }
        return polygon;
    }

private:
    /// Strictly inside of it, in their order.
    static std::vector<Place> on_edge(const Place& a, const Place& b, const std::set<Place>& nodes) {
        const FieldPoint from = point_at(a), to = point_at(b);
        const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy);
        const auto along = [&](const Place& node) {
            const FieldPoint point = point_at(node);
            return (point.x - from.x) * dx + (point.y - from.y) * dy;
        };
        std::vector<Place> found;
        const auto first = nodes.lower_bound({std::min(a.first, b.first) - 1, INT64_MIN}),
                   last = nodes.upper_bound({std::max(a.first, b.first) + 1, INT64_MAX});
        for (auto node = first; node != last; ++node) {
            const double t = along(*node) / (length * length);
            if (*node == a || *node == b || t <= 0.0 || t >= 1.0) continue;
            if (std::abs(cross(from, to, point_at(*node))) < 10.0 * fineness * length) found.push_back(*node);
        }
        std::ranges::sort(found, {}, along);
        return found;
    }

    std::set<Edge> edges_;
};

}  // namespace

std::vector<std::vector<FieldPoint>> outline_of(const FieldCells& field, const std::vector<std::size_t>& cells) {
    OpenEdges open;
    for (const std::size_t cell : cells) {
        std::vector<FieldPoint> corners;
        for (const int point : field.cells[cell]) corners.push_back(field.points[at(point)]);
        if (area_of(corners) < 0.0) std::ranges::reverse(corners);
        for (std::size_t k = 0; k < corners.size(); ++k)
            open.pass(place_of(corners[k]), place_of(corners[(k + 1) % corners.size()]));
    }
    open.split_at_hanging_nodes();
    std::vector<std::vector<FieldPoint>> polygons;
    for (auto polygon = open.take_polygon(); !polygon.empty(); polygon = open.take_polygon())
        if (std::abs(area_of(polygon)) > fineness) polygons.push_back(corners_of(polygon));
    return polygons;
}

}  // namespace stria::report
