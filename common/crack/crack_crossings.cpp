#include "common/crack/crack_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "common/crack/straight_way.hpp"
#include "common/error.hpp"
#include "common/geometry/clipping.hpp"
#include "common/geometry/segment.hpp"
#include "common/geometry/vec2.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

constexpr double edge_fraction = 1e-6;  // how near a point is put onto an edge: what it would cut off is no element

std::pair<int, int> edge_key(int a, int b) { return std::minmax(a, b); }

bool same_place(const Crossing& a, const Crossing& b) {
    if (a.node >= 0 && b.node >= 0) return a.node == b.node;
    if (a.edge != nullptr && b.edge != nullptr) return a.edge == b.edge && std::abs(a.fraction - b.fraction) < 1e-9;
    return false;
}

/// Of the way along an edge, where the crossing lies on it.
std::optional<double> fraction(const Crossing& crossing, int from, int to) {
    if (from == crossing.edge->first && to == crossing.edge->second) return crossing.fraction;
    if (from == crossing.edge->second && to == crossing.edge->first) return 1.0 - crossing.fraction;
    return std::nullopt;
}

/// Onto one of an element's corners, or else onto an edge; a corner found before stays.
void snap(const Mesh& mesh, const std::array<int, 4>& element, const Vec2& x, Vec2& snapped) {
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 &node = mesh.nodes[at(element[k])], &next = mesh.nodes[at(element[(k + 1) % 4])],
                   &last = mesh.nodes[at(element[(k + 3) % 4])];
        const Vec2 edge = next - node;
        if ((x - node).norm() < snap_fraction * std::min(edge.norm(), (last - node).norm())) {
            snapped = node;
            return;
        }
        const double along = (x - node).dot(edge) / edge.squaredNorm();
        if (snapped != x || along < snap_fraction || along > 1.0 - snap_fraction) continue;
        const Vec2 normal = Vec2(-edge.y(), edge.x()).normalized();
        const double distance = (x - node).dot(normal);
        if (std::abs(distance) < edge_fraction * edge.norm()) snapped = x - distance * normal;
    }
}

/// An end that lies on the outline to rounding is a mouth. On a slanted edge few places are numbers: it is put a little
/// beyond.
void reach_outline(const Mesh& mesh, Vec2& end) {
    constexpr double rounding = 1e-9;  // of an edge
    for (const auto& [name, edges] : mesh.boundary)
        for (const BoundaryEdge& edge : edges) {
            const std::array<int, 4>& nodes = mesh.elements[at(edge.element)];
            const Vec2 &from = mesh.nodes[at(nodes[at(edge.edge)])],
                       &to = mesh.nodes[at(nodes[at((edge.edge + 1) % 4)])];
            const double length = (to - from).norm(), distance = distance_to_segment(end, from, to);
            if (distance > rounding * length || orientation(from, to, end) <= 0) continue;
            end += (distance / length + rounding) * Vec2(to.y() - from.y(), from.x() - to.x());
            return;
        }
}

/// An element, and a part of its diagonal more.
Eigen::AlignedBox2d box_about(const Mesh& mesh, int element, double part) {
    Eigen::AlignedBox2d box;
    for (const int node : mesh.elements[at(element)]) box.extend(mesh.nodes[at(node)]);
    const double margin = part * box.diagonal().norm();
    return box.extend(Vec2(box.min() - Vec2::Constant(margin))).extend(Vec2(box.max() + Vec2::Constant(margin)));
}

std::vector<Eigen::AlignedBox2d> boxes_of_segments(const std::vector<Vec2>& points) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (std::size_t k = 1; k < points.size(); ++k)
        boxes.emplace_back(points[k - 1].cwiseMin(points[k]), points[k - 1].cwiseMax(points[k]));
    return boxes;
}

bool are_on(const Crossing& a, const Crossing& b, const MeshEdge& edge) {
    const auto on = [&](const Crossing& c) {
        return c.edge == &edge || (c.node >= 0 && (c.node == edge.first || c.node == edge.second));
    };
    return on(a) && on(b);
}

}  // namespace

std::vector<Vec2> snapped_onto_mesh(const BodyMesh& mesh, const std::vector<Vec2>& points) {
    std::vector<Vec2> snapped = points;
    const std::vector<Eigen::AlignedBox2d> places(points.begin(), points.end());
    for (const int e : mesh.elements_near(places)) {
        const Eigen::AlignedBox2d box = box_about(mesh, e, snap_fraction);
        for (std::size_t k = 0; k < points.size(); ++k)
            if (box.contains(points[k])) snap(mesh, mesh->elements[at(e)], points[k], snapped[k]);
    }
    reach_outline(mesh, snapped.front());
    reach_outline(mesh, snapped.back());
    snapped.erase(std::ranges::unique(snapped).begin(), snapped.end());
    return snapped.size() > 1 ? snapped : points;
}

CrackCrossings::CrackCrossings(BodyMesh mesh, const std::vector<Vec2>& points)
    : mesh_(std::move(mesh)), points_(points) {
    for (const HangingNode& h : mesh_->hanging) middle_[edge_key(h.ends[0], h.ends[1])] = h.node;
    arc_.push_back(0.0);
    for (std::size_t k = 1; k < points.size(); ++k) arc_.push_back(arc_.back() + (points[k] - points[k - 1]).norm());
    collect_edges();
    collect();
}

void CrackCrossings::collect_edges() {
    std::map<std::pair<int, int>, std::size_t> index;
    for (const int e : mesh_.elements_near(boxes_of_segments(points_))) {
        if (!meets_crack(box_about(mesh_, e, 1e-9))) continue;
        const auto add = [&](int from, int to) {
            const auto key = edge_key(from, to);
            const auto [found, added] = index.try_emplace(key, edges_.size());
            if (added)
                edges_.push_back({key.first, key.second, {e, -1}});
            else
                edges_[found->second].elements[1] = e;
        };
        for (std::size_t k = 0; k < 4; ++k) {
            const std::array<int, 4>& nodes = mesh_->elements[at(e)];
            const int from = nodes[k], to = nodes[(k + 1) % 4], middle = middle_of(from, to);
            add(from, middle >= 0 ? middle : to);
            if (middle < 0) continue;
            add(middle, to);
            hanging_near_.insert(middle);
        }
    }
}

int CrackCrossings::middle_of(int a, int b) const {
    const auto found = middle_.find(edge_key(a, b));
    return found != middle_.end() ? found->second : -1;
}

bool CrackCrossings::meets_crack(const Eigen::AlignedBox2d& box) const {
    for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
        Eigen::AlignedBox2d segment(points_[k]);
        if (box.intersects(segment.extend(points_[k + 1]))) return true;
    }
    return false;
}

void CrackCrossings::collect() {
    for (const MeshEdge& edge : edges_) {
        const Vec2 &a = node(edge.first), &b = node(edge.second);
        for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
            const auto common = intersect(points_[k], points_[k + 1], a, b);
            if (!common) continue;
            add(edge, k, common->first);
            if (common->first != common->second) add(edge, k, common->second);
        }
    }
    add_hanging_nodes();
    add_bends_on_edges();
    std::ranges::stable_sort(crossings_, {}, &Crossing::s);
    merge();
}

// On the side of the larger element no edge ends at them: a crack along its edge, by rounding on that side, meets none.
void CrackCrossings::add_hanging_nodes() {
    for (const auto& [middle, ends, larger] : mesh_->hanging) {
        if (!hanging_near_.contains(middle)) continue;
        const Vec2& x = node(middle);
        const double rounding = 1e-9 * (node(ends[1]) - node(ends[0])).norm();
        for (std::size_t k = 0; k + 1 < points_.size(); ++k)
            if (distance_to_segment(x, points_[k], points_[k + 1]) <= rounding)
                crossings_.push_back({arc_[k] + (x - points_[k]).norm(), x, middle, nullptr, 0.0});
    }
}

// Of a crack that runs along an edge and leaves it there, or comes to it: by rounding the bend may lie beside the edge.
void CrackCrossings::add_bends_on_edges() {
    for (const MeshEdge& edge : edges_) {
        const Vec2 &a = node(edge.first), along = node(edge.second) - a;
        const double rounding = 1e-9 * along.norm();
        for (std::size_t k = 1; k + 1 < points_.size(); ++k) {
            if (distance_to_segment(points_[k], a, a + along) > rounding) continue;
            for (const std::size_t segment : {k - 1, k}) {
                const Vec2 way = points_[segment + 1] - points_[segment];
                if (std::abs(cross(along, way)) <= rounding * way.norm()) add(edge, segment, points_[k]);
            }
        }
    }
}

// An intersection moves by rounding with the end of the crack. Where that has grown along a rounded direction, the edge
// meets the line through what does not move: a crack that grows straight on leaves what it has cut the same to the bit.
double CrackCrossings::fraction_of(const MeshEdge& edge, std::size_t segment, const Vec2& found) const {
    constexpr double nearly_along = 1e-5;
    const Vec2 &a = node(edge.first), along = node(edge.second) - a;
    const bool at_start = segment == 0 && points_.size() > 2;
    const Vec2 &before = points_[at_start ? 1 : segment], &end = points_[at_start ? 0 : segment + 1];
    const Vec2 direction = rounded_direction(end - before);
    const double across = cross(direction, along);
    if (on_rounded_way(before, end) != end || std::abs(across) < nearly_along * along.norm())
        return (found - a).dot(along) / along.squaredNorm();
    return cross(direction, before - a) / across;
}

void CrackCrossings::add(const MeshEdge& edge, std::size_t segment, const Vec2& found) {
    const Vec2 &a = node(edge.first), &b = node(edge.second);
    const double t = fraction_of(edge, segment, found);
    const Vec2 x = a + t * (b - a);
    const double s = arc_[segment] + (x - points_[segment]).norm();
    if (t < snap_fraction)
        crossings_.push_back({s, a, edge.first, nullptr, 0.0});
    else if (t > 1.0 - snap_fraction)
        crossings_.push_back({s, b, edge.second, nullptr, 0.0});
    else
        crossings_.push_back({s, x, -1, &edge, t});
}

// A node and a point of an edge that ends there, with no kink between or there: the crack grazes the node (or the whole
// edge), and once snapped onto the node it no longer crosses that edge.
bool CrackCrossings::grazes(const Crossing& a, const Crossing& b) const {
    const Crossing &at_node = a.node >= 0 ? a : b, &on_edge = a.node >= 0 ? b : a;
    if (at_node.node < 0 || on_edge.edge == nullptr || has_kink_between(a.s, b.s) || bends_at(on_edge)) return false;
    return on_edge.edge->first == at_node.node || on_edge.edge->second == at_node.node;
}

void CrackCrossings::merge() {
    std::vector<Crossing> merged;
    for (const Crossing& crossing : crossings_) {
        if (!merged.empty() && same_place(merged.back(), crossing)) continue;
        if (!merged.empty() && grazes(merged.back(), crossing)) {
            if (crossing.node >= 0) merged.back() = crossing;
            if (merged.size() > 1 && same_place(merged[merged.size() - 2], merged.back())) merged.pop_back();
            continue;
        }
        merged.push_back(crossing);
    }
    crossings_ = std::move(merged);
}

bool CrackCrossings::has_kink_between(double s0, double s1) const {
    for (std::size_t k = 1; k + 1 < points_.size(); ++k) {
        if (arc_[k] > s0 + kink_tolerance() && arc_[k] < s1 - kink_tolerance()) return true;
    }
    return false;
}

// An edge met once near the crack may have its other element farther away.
bool CrackCrossings::is_boundary(const MeshEdge& edge) const {
    const std::span<const int> others = mesh_.around()[at(edge.second)];
    return std::ranges::count_if(mesh_.around()[at(edge.first)],
                                 [&](int e) { return std::ranges::find(others, e) != others.end(); }) == 1;
}

double CrackCrossings::place(int e, const Crossing& crossing) const {
    const auto& nodes = mesh_->elements[at(e)];
    for (std::size_t k = 0; k < 4; ++k) {
        const int from = nodes[k], to = nodes[(k + 1) % 4], middle = middle_of(from, to);
        const auto edge = static_cast<double>(k);
        if (crossing.node >= 0 && crossing.node == from) return edge;
        if (crossing.node >= 0 && crossing.node == middle) return edge + 0.5;
        if (crossing.edge == nullptr) continue;
        if (middle < 0) {
            if (const auto t = fraction(crossing, from, to)) return edge + *t;
            continue;
        }
        if (const auto t = fraction(crossing, from, middle)) return edge + 0.5 * *t;
        if (const auto t = fraction(crossing, middle, to)) return edge + 0.5 + 0.5 * *t;
    }
    require(crossing.node < 0 && crossing.edge == nullptr, "a crossing lies on the boundary of its element");
    return -1.0;
}

std::vector<int> CrackCrossings::elements_at(const Crossing& crossing) const {
    std::vector<int> result;
    if (crossing.node >= 0) {
        const std::span<const int> around = mesh_.around()[at(crossing.node)];
        result.assign(around.begin(), around.end());
        return result;
    }
    for (const int e : crossing.edge->elements)
        if (e >= 0) result.push_back(e);
    return result;
}

std::vector<int> CrackCrossings::common_elements(const Crossing& a, const Crossing& b) const {
    std::vector<int> result;
    const std::vector<int> others = elements_at(b);
    for (const int e : elements_at(a))
        if (std::ranges::find(others, e) != others.end()) result.push_back(e);
    return result;
}

bool CrackCrossings::on_one_edge(const Crossing& a, const Crossing& b) const {
    return std::ranges::any_of(edges_, [&](const MeshEdge& edge) { return are_on(a, b, edge); });
}

}  // namespace stria
