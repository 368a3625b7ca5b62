#include "coarse/enrichment/tied_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// What the cracks meet of a mesh.
class Crossings {
public:
    explicit Crossings(const EnrichedMesh& mesh) {
        for (const CrackPiece& piece : mesh.pieces)
            for (const double place : {piece.entry, piece.exit})
                if (place >= 0.0) note(mesh.elements[at(piece.element)], place, piece.neighbour >= 0);
    }

    [[nodiscard]] bool at_node(int node) const { return nodes_.contains(node); }
    [[nodiscard]] bool between(int a, int b) const { return edges_.contains(std::minmax(a, b)); }
    /// Whether a crack runs along a part of the edge, from or to the middle of it.
    [[nodiscard]] bool along(int a, int b) const { return edges_of_faces_.contains(std::minmax(a, b)); }

private:
    void note(const std::array<int, 4>& corners, double place, bool along_edge) {
        const int edge = static_cast<int>(place);
        if (place == std::floor(place)) {
            nodes_.insert(corners[at(edge % 4)]);
            return;
        }
        const std::pair<int, int> ends = std::minmax(corners[at(edge)], corners[at((edge + 1) % 4)]);
        edges_.insert(ends);
        if (along_edge) edges_of_faces_.insert(ends);
    }

    std::set<int> nodes_;
    std::set<std::pair<int, int>> edges_, edges_of_faces_;  // by their ends, the lower number first
};

/// Of the edge at the node: an end on the crack counts as +, whatever the side of the edge. Of an edge that the crack
/// runs along, what hangs is beyond it.
double side_at(const HangingNode& hanging, const EnrichedMesh& mesh, const std::map<int, int>& beside,
               const Crossings& crossings) {
    if (const auto own = beside.find(hanging.node); own != beside.end()) return own->second;
    for (const int end : hanging.ends)
        for (const Term& term : mesh.terms[at(end)])
            if (term.kind == Term::Kind::Heaviside && !crossings.at_node(end)) return term.shift;
    const double of_larger = mesh.element_side[at(hanging.larger)];
    return crossings.along(hanging.ends[0], hanging.ends[1]) ? -of_larger : of_larger;
}

}  // namespace

std::vector<TiedNode> tied_nodes(std::span<const HangingNode> hanging, const EnrichedMesh& mesh,
                                 const std::map<int, int>& beside) {
    std::vector<TiedNode> tied;
    if (hanging.empty()) return tied;
    const Crossings crossings(mesh);
    for (const HangingNode& one : hanging) {
        const auto [node, ends, larger] = one;
        const bool jump = crossings.at_node(node) || crossings.between(ends[0], ends[1]) ||
                          crossings.between(ends[0], node) || crossings.between(node, ends[1]);
        tied.push_back({node, ends, side_at(one, mesh, beside, crossings), jump});
    }
    return tied;
}

}  // namespace stria::coarse
