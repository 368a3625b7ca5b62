#include "coarse/enrichment/tip_support.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/fem/chord.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// In diagonals: to the elements ahead of a tip on an edge, and behind it.
constexpr double least_radius = 1.15;

/// Adds the corners of all elements that share one with some of the nodes.
void add_elements_about(const Mesh& mesh, std::set<int>& nodes) {
    const std::set<int> within = nodes;
    for (const std::array<int, 4>& corners : mesh.elements)
        if (std::ranges::any_of(corners, [&](int node) { return within.contains(node); }))
            nodes.insert(corners.begin(), corners.end());
    add_ends_of_edges(mesh, nodes);
}

/// Whether a node of another tip of the crack may be none of these, and no element may see both these and what another
/// crack has.
bool is_clear(const Mesh& mesh, const Tip& tip, const std::set<int>& nodes, const RoomOfDisk& room) {
    double rim = 0.0, element = 0.0;
    for (const int node : nodes) rim = std::max(rim, (mesh.nodes[at(node)] - tip.position).norm());
    if (rim >= room.other_end || rim >= room.other_cracks) return false;
    for (int e = 0; e < std::ssize(mesh.elements); ++e)
        if (std::ranges::any_of(mesh.elements[at(e)], [&](int node) { return nodes.contains(node); }))
            element = std::max(element, diagonal(mesh, e));
    return rim + 0.5 * element < room.other_cracks;
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

void add_disk(const Mesh& mesh, const Vec2& place, double radius, std::set<int>& nodes) {
    for (int element = 0; element < std::ssize(mesh.elements); ++element) {
        if ((centre(mesh, element) - place).norm() > radius) continue;
        nodes.insert(mesh.elements[at(element)].begin(), mesh.elements[at(element)].end());
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

// Functions that all nodes share want all elements about the tip's: where others took some of them K was up to 14 %
// off, and functions of each node of the tip's element leave 1 %. Disks may see functions of the crack's other tip.
TipNodes support_of_tip(const Mesh& mesh, const TipEnrichment& enrichment, const Tip& tip, const CrackPiece& piece,
                        const RoomOfDisk& room) {
    TipNodes own{tip_nodes(mesh, piece), false};
    if (enrichment.support == TipSupport::Topological) return own;
    const bool share = enrichment.support == TipSupport::Gathered;
    const double radius = disk_radius(enrichment, tip, room), least = least_radius * room.diagonal;
    TipNodes disk{own.nodes, share};
    add_disk(mesh, tip.position, radius, disk.nodes);
    if (!share || enrichment.radius) return disk;
    if (room.in_body < least) return radius >= room.in_body ? disk : own;
    TipNodes whole{own.nodes, share};
    add_elements_about(mesh, whole.nodes);
    add_disk(mesh, tip.position, std::max(radius, least), whole.nodes);
    if (is_clear(mesh, tip, whole.nodes, room)) return whole;
    return radius >= least ? disk : own;
}

}  // namespace stria::coarse
