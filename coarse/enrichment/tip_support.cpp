#include "coarse/enrichment/tip_support.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
#include <utility>
#include <vector>

#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/fem/chord.hpp"
#include "common/index.hpp"
#include "common/index_set.hpp"

namespace stria::coarse {
namespace {

/// In diagonals: to the elements ahead of a tip on an edge, and behind it.
constexpr double least_radius = 1.15;

/// The corners of the elements about some nodes.
std::vector<std::array<int, 4>> about(const BodyMesh& mesh, const std::set<int>& nodes) {
    std::vector<std::array<int, 4>> corners;
    for (const int element : mesh.elements_about(std::vector<int>(nodes.begin(), nodes.end())))
        corners.push_back(mesh->elements[at(element)]);
    return corners;
}

/// Adds the corners of all elements that share one with some of the nodes.
void add_elements_about(const BodyMesh& mesh, std::set<int>& nodes) {
    const std::set<int> within = nodes;
    for (const std::array<int, 4>& corners : about(mesh, within))
        if (contains_any(within, corners)) nodes.insert(corners.begin(), corners.end());
    add_ends_of_edges(mesh, nodes);
}

/// And what hangs on edges between these and others: it has their functions.
std::set<int> with_what_hangs(const Mesh& mesh, std::set<int> nodes) {
    std::set<int> hanging;
    for (const HangingNode& h : mesh.hanging)
        if (contains_any(nodes, h.ends)) hanging.insert(h.node);
    nodes.merge(hanging);
    return nodes;
}

/// Whether an element has nodes of both.
bool meet(const BodyMesh& mesh, const std::set<int>& nodes, const std::set<int>& others) {
    const std::set<int> seen = with_what_hangs(mesh, nodes);
    return std::ranges::any_of(about(mesh, seen), [&](const std::array<int, 4>& corners) {
        return contains_any(seen, corners) && contains_any(others, corners);
    });
}

/// What shares functions hangs on no edge: with these a small element would differ from its larger neighbour there.
TipNodes shared_where_nothing_hangs(const BodyMesh& mesh, TipNodes about) {
    std::set<int> hanging;
    for (const HangingNode& h : mesh->hanging) hanging.insert(h.node);
    about.share = about.share && !meet(mesh, about.nodes, hanging);
    return about;
}

double distance_to_rim(const Mesh& mesh, const Vec2& place, const std::set<int>& nodes) {
    double rim = 0.0;
    for (const int node : nodes) rim = std::max(rim, (mesh.nodes[at(node)] - place).norm());
    return rim;
}

/// Those that no element sees together with what other cracks have, and the tip's own.
TipNodes clear_of_others(const BodyMesh& mesh, const std::set<int>& nodes, const TipNodes& own,
                         const std::set<int>& others) {
    std::set<int> beside;
    for (const std::array<int, 4>& corners : about(mesh, others))
        if (contains_any(others, corners)) beside.insert(corners.begin(), corners.end());
    add_ends_of_edges(mesh, beside);
    TipNodes clear{own.nodes, false};
    std::ranges::set_difference(nodes, beside, std::inserter(clear.nodes, clear.nodes.end()));
    return meet(mesh, clear.nodes, others) ? own : clear;
}

}  // namespace

std::set<int> tip_nodes(const Mesh& mesh, const CrackPiece& piece) {
    std::set<int> nodes;
    for (const int element : {piece.element, piece.neighbour}) {
        if (element >= 0) nodes.insert(mesh.elements[at(element)].begin(), mesh.elements[at(element)].end());
    }
    add_ends_of_edges(mesh, nodes);
    return nodes;
}

void add_ends_of_edges(const Mesh& mesh, std::set<int>& nodes) {
    for (const HangingNode& hanging : mesh.hanging)
        if (nodes.contains(hanging.node)) nodes.insert(hanging.ends.begin(), hanging.ends.end());
}

void add_disk(const BodyMesh& mesh, const Vec2& place, double radius, std::set<int>& nodes) {
    for (const int element : mesh.elements_near(place, radius)) {
        if ((centre(*mesh, element) - place).norm() > radius) continue;
        nodes.insert(mesh->elements[at(element)].begin(), mesh->elements[at(element)].end());
    }
    add_ends_of_edges(mesh, nodes);
}

double disk_radius(const TipEnrichment& enrichment, const Tip& tip, const RoomOfDisk& room) {
    const double others = std::min(room.other_end, room.other_cracks), reach = std::min(room.in_body, others);
    if (!enrichment.radius) {
        // No element between two disks sees functions of both.
        constexpr double clear = 1.25;  // diagonals: from a disk's rim to its last nodes, and half an element
        const double radius = std::max(0.75 * reach, std::min(reach, least_radius * room.diagonal));
        return std::min({radius, others - clear * room.diagonal, enrichment.most_diagonals * room.diagonal});
    }
    if (*enrichment.radius <= reach) return *enrichment.radius;
    throw CaseError(
        fmt::format("fine.enrichment_radius: {} mm is too large for the tip at ({:.6g}, {:.6g}): the boundary, "
                    "a bend of its own crack, or the middle between it and another tip or crack lies {:.4g} mm away",
                    *enrichment.radius, tip.position.x(), tip.position.y(), reach));
}

NodesOfCrack nodes_of_crack(const BodyMesh& mesh, const CrackPath& path) {
    NodesOfCrack result;
    for (const CrackPiece& piece : path.pieces) result.beside.merge(tip_nodes(mesh, piece));
    const auto add = [&](const CrackPiece& piece, const Vec2& tip) {
        std::set<int> nodes = tip_nodes(mesh, piece);
        add_elements_about(mesh, nodes);
        add_disk(mesh, tip, least_radius * diagonal(*mesh, piece.element), nodes);
        result.about.push_back({tip, std::move(nodes)});
    };
    if (path.tip_at_start) add(path.pieces.front(), path.pieces.front().points.front());
    if (path.tip_at_end) add(path.pieces.back(), path.pieces.back().points.back());
    return result;
}

std::set<int> left_to_others(const Mesh& mesh, const std::vector<NodesOfCrack>& cracks, const Tip& tip) {
    std::set<int> left;
    for (int crack = 0; crack < std::ssize(cracks); ++crack) {
        if (crack == tip.crack) continue;
        left.insert(cracks[at(crack)].beside.begin(), cracks[at(crack)].beside.end());
        for (const auto& [other, nodes] : cracks[at(crack)].about)
            for (const int node : nodes)
                if ((mesh.nodes[at(node)] - other).norm() < (mesh.nodes[at(node)] - tip.position).norm())
                    left.insert(node);
    }
    return with_what_hangs(mesh, std::move(left));
}

// Functions that all nodes share want all elements about the tip's: where others took some of them K was up to 14 %
// off, and functions of each node of the tip's element leave 1 %. So where another crack takes some of these elements
// each node of the others has functions of its own. Disks may see functions of the crack's other tip.
TipNodes support_of_tip(const BodyMesh& mesh, const TipEnrichment& enrichment, const Tip& tip, const CrackPiece& piece,
                        const RoomOfDisk& room) {
    TipNodes own{tip_nodes(mesh, piece), false};
    if (enrichment.support == TipSupport::Topological) return own;
    const bool share = enrichment.support == TipSupport::Gathered;
    const double radius = disk_radius(enrichment, tip, room), least = least_radius * room.diagonal;
    TipNodes disk{own.nodes, share};
    add_disk(mesh, tip.position, radius, disk.nodes);
    if (!share || enrichment.radius) return disk;
    if (room.in_body < least) return radius >= room.in_body ? shared_where_nothing_hangs(mesh, disk) : own;
    TipNodes whole{own.nodes, share};
    add_elements_about(mesh, whole.nodes);
    add_disk(mesh, tip.position, std::max(radius, least), whole.nodes);
    // A node of another tip of the crack may be none of these.
    if (distance_to_rim(mesh, tip.position, whole.nodes) >= room.other_end)
        return radius >= least ? shared_where_nothing_hangs(mesh, disk) : own;
    if (!meet(mesh, whole.nodes, room.of_others)) return shared_where_nothing_hangs(mesh, whole);
    return clear_of_others(mesh, whole.nodes, own, room.of_others);
}

}  // namespace stria::coarse
