#include "coarse/elements/near_elements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/model/rings.hpp"
#include "common/fem/elements_about.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

NodeSet nodes_of(const EnrichedMesh& mesh, const ElementSet& elements) {
    NodeSet nodes(mesh.nodes.size());
    for (const int element : elements.members())
        for (const int node : mesh.elements[at(element)]) nodes.insert(node);
    return nodes;
}

/// What is near a tip: within `radius` of the way that it has ahead.
struct Neighbourhood {
    double radius = 0.0, way = 0.0;  // mm

    [[nodiscard]] bool holds(const Tip& tip, const Vec2& x) const {
        const Vec2 from_tip = x - tip.position;
        const double along = std::clamp(from_tip.dot(tip.direction), 0.0, way);
        return (from_tip - along * tip.direction).squaredNorm() <= radius * radius;
    }
};

void add_neighbourhood(const BodyMesh& mesh, const Tip& tip, const Neighbourhood& about, NodeSet& nodes) {
    Eigen::AlignedBox2d box(tip.position);
    box.extend(Vec2(tip.position + about.way * tip.direction));
    const Vec2 beyond = Vec2::Constant(about.radius);
    mesh.visit_near({box.min() - beyond, box.max() + beyond}, [&](int element) {
        for (const int n : mesh->elements[at(element)])
            if (about.holds(tip, mesh->nodes[at(n)])) nodes.insert(n);
    });
}

/// How far from a tip, ahead of it, the zone reaches that is about no other tip, mm.
double reach_of_zone(const EnrichedMesh& mesh, int tip, const NodeSet& nodes_of_zone) {
    const Tip& own = mesh.tips[at(tip)];
    double reach = 0.0;
    for (const int n : nodes_of_zone.members()) {
        const Vec2& x = mesh.nodes[at(n)];
        if ((x - own.position).dot(own.direction) < 0.0) continue;
        const double distance = (x - own.position).norm();
        const auto closer = [&](const Tip& other) { return (x - other.position).norm() < distance; };
        if (std::ranges::none_of(mesh.tips, closer)) reach = std::max(reach, distance);
    }
    return reach;
}

/// Of the far elements: those near are paid for in each increment, and the far ones where a tip has used up its room.
constexpr double most_near = 0.05;

/// A ring grows no faster than its tip advances; a zone goes with its tip. How long the run will be must not show: it
/// may be resumed with more cycles. `most`: of the largest ring's radius.
Neighbourhood with_room(const Scene& scene, int tip, const NodeSet& nodes_of_zone, double most) {
    constexpr int steps = 20;
    const double radius = largest_ring_of_either_body(scene, tip);
    if (!scene.input.growth) return {radius, 0.0};
    const double room = std::min(steps * scene.input.growth->increment.value_or(radius), most * radius);
    return {std::max(radius, reach_of_zone(scene.enriched, tip, nodes_of_zone)) + room, room};
}

/// Nodes about which elements are not plain, in the body or in the nominal one.
NodeSet nodes_with_functions(const Scene& scene) {
    NodeSet nodes(scene.enriched.nodes.size());
    for (const EnrichedMesh* mesh : {&scene.enriched, &nominal_functions(scene)}) {
        for (const int node : mesh->terms.nodes()) nodes.insert(node);
        for (const TiedNode& tie : mesh->tied) nodes.insert(tie.node);
    }
    return nodes;
}

/// Coarse elements that see one of the nodes, and those that are not plain.
ElementSet near_about(const Scene& scene, const ElementSet& in_zone, NodeSet nodes) {
    ElementSet near(in_zone.size());
    nodes |= nodes_with_functions(scene);
    for_each_about(scene.mesh, nodes.members(), [&](int e) {
        if (!in_zone.contains(e)) near.insert(e);
    });
    return near;
}

/// About the zone, which goes with its tip, for so many steps of growth.
Neighbourhood about_zone(const Scene& scene, int tip, const NodeSet& nodes_of_zone, int steps) {
    const double edge = tip_element_edge(scene.enriched, scene.enriched.tips[at(tip)]);
    const double room = steps * scene.input.growth->increment.value_or(edge);
    return {reach_of_zone(scene.enriched, tip, nodes_of_zone) + room, room};
}

/// Elements that have nothing to do with far ones, the zone or these nodes, and that no crack changes.
ElementSet plain_beside(const Scene& scene, const ElementSet& in_zone, const ElementSet& far, const NodeSet& nodes) {
    ElementSet others = near_about(scene, in_zone, nodes);
    others |= in_zone;
    if (far.size() > 0) others |= far;
    return others.complement();
}

/// Whether these elements are factored in much more operations than their rim, which comes with the core in each step:
/// two unknowns a node, about 80 n^(3/2) operations in the plane (nested dissection, George 1973), and m^3 / 3 for a
/// dense rim, four times as fast. What this rule spares: docs/performance.md, a step of growth.
bool spares_work(const EnrichedMesh& mesh, const StillElements& still, const ElementSet& part) {
    const NodeSet inside = nodes_of(mesh, part);
    NodeSet of_core(mesh.nodes.size());
    for (int e = 0; e < part.size(); ++e)
        if (!part.contains(e) && !still.far.holds(e) && !still.middle.holds(e))
            for (const int node : mesh.elements[at(e)]) of_core.insert(node);
    int rim = 0;
    for (int node = 0; node < inside.size(); ++node) rim += inside.contains(node) && of_core.contains(node) ? 1 : 0;
    return std::pow(2.0 * rim, 3) / 3.0 < 4.0 * 80.0 * std::pow(inside.count(), 1.5);
}

ElementSet middle_elements(const Scene& scene, const ElementSet& in_zone, const ElementSet& far,
                           const ElementSet& known) {
    if (!scene.input.growth) return {};
    const EnrichedMesh& mesh = scene.enriched;
    const NodeSet nodes = nodes_of(mesh, in_zone);
    if (known.size() == in_zone.size() && !known.none() && known.is_subset_of(plain_beside(scene, in_zone, far, nodes)))
        return known;
    for (const int steps : {10, 5, 2}) {
        NodeSet with_room = nodes;
        for (int t = 0; t < std::ssize(mesh.tips); ++t)
            add_neighbourhood(scene.mesh, mesh.tips[at(t)], about_zone(scene, t, nodes, steps), with_room);
        const ElementSet middle = plain_beside(scene, in_zone, far, with_room);
        const int core = in_zone.size() - far.count() - in_zone.count() - middle.count();
        if (middle.count() > 2 * core && spares_work(mesh, {.far = far, .middle = {}}, middle)) return middle;
    }
    return {};
}

/// Where functions change in so many steps of growth, and what is next to that.
Neighbourhood about_way(const Scene& scene, int tip, int steps) {
    constexpr double elements_beside = 4.5;  // what sees a function of the elements about a tip: 3 diagonals
    const double edge = tip_element_edge(scene.enriched, scene.enriched.tips[at(tip)]);
    return {elements_beside * edge, steps * scene.input.growth->increment.value_or(edge)};
}

/// Nodes of elements that a split of these changes, and of those beside them: what hangs on an edge may become free.
NodeSet nodes_about_splits(const BodyMesh& body, const EnrichedMesh& mesh, const ElementSet& split) {
    const NodeSet corners = nodes_of(mesh, split);
    NodeSet changing = corners;
    for (const TiedNode& tie : mesh.tied)
        if (contains_any(corners, tie.ends)) changing.insert(tie.node);
    NodeSet about(mesh.nodes.size());
    for_each_about(body, changing.members(), [&](int element) {
        for (const int node : body->elements[at(element)]) about.insert(node);
    });
    return about;
}

/// Elements that are not still otherwise, have nothing to do with these nodes, and see no tip's functions.
ElementSet others_without_tips(const EnrichedMesh& mesh, const StillElements& still, const NodeSet& nodes) {
    ElementSet others(mesh.elements.size());
    const auto changes = [&](int node) { return nodes.contains(node) || mesh.has_tip_functions(node); };
    for (int e = 0; e < others.size(); ++e)
        if (!still.far.holds(e) && !still.middle.holds(e) && std::ranges::none_of(mesh.elements[at(e)], changes))
            others.insert(e);
    return others;
}

/// With as much room ahead of the tips as the number of far elements is worth. `most`: with_room().
struct ChosenFar {
    ElementSet far;
    double most;
};

ChosenFar choose_far(const Scene& scene, const ElementSet& in_zone) {
    const NodeSet of_zone = nodes_of(scene.enriched, in_zone);
    ChosenFar chosen;
    for (const double most : {1.0, 0.5, 0.25}) {
        NodeSet nodes = of_zone;
        for (int t = 0; t < std::ssize(scene.enriched.tips); ++t)
            add_neighbourhood(scene.mesh, scene.enriched.tips[at(t)], with_room(scene, t, of_zone, most), nodes);
        ElementSet close = near_about(scene, in_zone, nodes);
        if (close.none()) return {.far = ElementSet(in_zone.size()), .most = most};
        chosen = {.far = (close |= in_zone).complement(), .most = most};
        if (close.count() <= most_near * chosen.far.count()) break;
    }
    return chosen;
}

bool disjoint(const ElementSet& a, const ElementSet& b) {
    for (int e = 0; e < a.size(); ++e)
        if (a.contains(e) && b.contains(e)) return false;
    return true;
}

}  // namespace

ElementSet near_elements(const Scene& scene, const ElementSet& in_zone) {
    const EnrichedMesh& mesh = scene.enriched;
    NodeSet nodes = nodes_of(mesh, in_zone);
    for (int t = 0; t < std::ssize(mesh.tips); ++t)
        add_neighbourhood(scene.mesh, mesh.tips[at(t)], {largest_ring_of_either_body(scene, t), 0.0}, nodes);
    return near_about(scene, in_zone, nodes);
}

ElementSet far_elements(const Scene& scene, const ElementSet& in_zone, const ElementSet& known) {
    const EnrichedMesh& mesh = scene.enriched;
    if (known.size() == in_zone.size() && !known.none() && disjoint(known, in_zone) &&
        disjoint(known, near_elements(scene, in_zone)))
        return known;
    const auto [far, most] = choose_far(scene, in_zone);
    const bool serves = !far.none() && (!in_zone.none() || spares_work(mesh, {}, far));
    return serves ? far : ElementSet(in_zone.size());
}

double room_ahead(const Scene& scene, const ElementSet& in_zone) {
    const double most = choose_far(scene, in_zone).most;
    const NodeSet of_zone = nodes_of(scene.enriched, in_zone);
    double room = std::numeric_limits<double>::infinity();
    for (int t = 0; t < std::ssize(scene.enriched.tips); ++t)
        room = std::min(room, with_room(scene, t, of_zone, most).way);
    return room;
}

StillElements still_elements(const Scene& scene, const ElementSet& in_zone, const StillElements& known) {
    StillElements still{.far = far_elements(scene, in_zone, known.far), .middle = {}};
    still.middle = middle_elements(scene, in_zone, still.far, still.far == known.far ? known.middle : ElementSet());
    return still;
}

ElementSet elements_behind(const Scene& scene, const StillElements& still, const ElementSet& soon) {
    const EnrichedMesh& mesh = nominal_functions(scene);
    if (!scene.input.growth || !scene.enriched.left_tips.empty()) return {};
    const NodeSet of_splits = nodes_about_splits(scene.mesh, mesh, soon);
    for (const int steps : {10, 5, 2}) {
        NodeSet changing = of_splits;
        for (int t = 0; t < std::ssize(mesh.tips); ++t)
            add_neighbourhood(scene.mesh, mesh.tips[at(t)], about_way(scene, t, steps), changing);
        const ElementSet behind = others_without_tips(mesh, still, changing);
        const int core = behind.size() - still.far.count() - still.middle.count() - behind.count();
        if (behind.count() > 2 * core && spares_work(mesh, still, behind)) return behind;
    }
    return {};
}

}  // namespace stria::coarse
