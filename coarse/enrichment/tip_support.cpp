#include "coarse/enrichment/tip_support.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"

namespace stria::coarse {

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
    if (!enrichment.radius) {
        // No element between two disks sees functions of both.
        constexpr double clear = 1.25;  // diagonals: from a disk's rim to its last nodes, and half an element
        // To the elements ahead of a tip on an edge, and behind it. Without one of them K was 7 % low.
        constexpr double least = 1.15;  // diagonals
        const double radius = std::max(0.75 * room.reach, std::min(room.reach, least * room.diagonal));
        return std::min({radius, room.half_way - clear * room.diagonal, enrichment.most_diagonals * room.diagonal});
    }
    if (*enrichment.radius <= room.reach) return *enrichment.radius;
    throw CaseError(
        fmt::format("fine.enrichment_radius: {} mm is too large for the tip at ({:.6g}, {:.6g}): the boundary, "
                    "a bend of its own crack, or the middle between it and another tip or crack lies {:.4g} mm away",
                    *enrichment.radius, tip.position.x(), tip.position.y(), room.reach));
}

}  // namespace stria::coarse
