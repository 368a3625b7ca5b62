#include "coarse/model/enrichment.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "coarse/model/crack_front.hpp"
#include "coarse/model/crack_sides.hpp"
#include "coarse/model/tip_reach.hpp"
#include "common/case/case_questions.hpp"
#include "common/crack/crack_end.hpp"
#include "common/enrichment/tip_functions.hpp"
#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

class Enricher {
public:
    Enricher(const Mesh& mesh, const std::vector<CrackSection>& cracks, const TipEnrichment& tips)
        : mesh_(mesh), cracks_(cracks), tip_enrichment_(tips) {
        result_.nodes = mesh.nodes;
        result_.elements = mesh.elements;
        result_.node_ids.resize(mesh.nodes.size());
        result_.element_ids.resize(mesh.elements.size());
        std::iota(result_.node_ids.begin(), result_.node_ids.end(), 0);
        std::iota(result_.element_ids.begin(), result_.element_ids.end(), 0);
        result_.material = mesh.material;
        result_.terms.resize(mesh.nodes.size());
        result_.element_side.assign(mesh.elements.size(), 0);
        result_.tip_exponent = tips.exponent;
        for (const CrackSection& crack : cracks) result_.grown_at_start.push_back(crack.grown_at_start);
    }

    EnrichedMesh enrich() {
        std::vector<CrackPath> paths;
        for (int crack = 0; crack < static_cast<int>(cracks_.size()); ++crack)
            paths.push_back(resolve_crack(mesh_, crack, cracks_[at(crack)].points));
        if (std::ranges::all_of(paths, [&](const CrackPath& path) { return has_small_elements(path); }))
            tip_enrichment_.functions = 0;
        result_.tip_functions = tip_enrichment_.functions;
        for (int crack = 0; crack < static_cast<int>(cracks_.size()); ++crack) {
            CrackPath& path = paths[at(crack)];
            if (tip_enrichment_.functions == 0) path = with_fronts_on_edges(mesh_, std::move(path));
            add_crack(crack, path);
        }
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e) require_one_crack(e);
        for (const HangingNode& hanging : mesh_.hanging) result_.tied.push_back(tie(hanging));
        result_.number();
        return std::move(result_);
    }

private:
    [[nodiscard]] bool has_small_elements(const CrackPath& path) const {
        const double length = path.pieces.back().s.back() - path.pieces.front().s.front();
        const auto is_small = [&](const CrackPiece& piece) {
            return edge_of_square(mesh_, piece.element) < tip_enrichment_.none_below * length;
        };
        return (!path.tip_at_start || is_small(path.pieces.front())) &&
               (!path.tip_at_end || is_small(path.pieces.back()));
    }

    // Sides and jumps of an element belong to one crack, and a node sees at most one tip.
    void require_one_crack(std::size_t element) const {
        std::set<int> cracks;
        for (const int node : mesh_.elements[element]) {
            int last_tip = -1;
            for (const Term& term : result_.terms[at(node)]) {
                const bool heaviside = term.kind == Term::Kind::Heaviside;
                cracks.insert(heaviside ? term.owner : result_.tips[at(term.owner)].crack);
                const Vec2& x = mesh_.nodes[at(node)];
                if (cracks.size() > 1) {
                    throw CaseError(fmt::format(
                        "crack {}: near ({}, {}) it is less than two elements from crack {}; use smaller elements",
                        *cracks.rbegin(), x.x(), x.y(), *cracks.begin()));
                }
                if (heaviside) continue;
                if (last_tip >= 0 && last_tip != term.owner) {
                    throw CaseError(fmt::format(
                        "crack {}: near ({}, {}) its two tips are less than two elements apart; use smaller elements",
                        *cracks.begin(), x.x(), x.y()));
                }
                last_tip = term.owner;
            }
        }
    }

    [[nodiscard]] TiedNode tie(const HangingNode& hanging) const {
        const auto [node, ends, larger] = hanging;
        const auto meets = [&](int a, int b) { return crossed_edges_.contains(std::minmax(a, b)); };
        const bool jump =
            met_nodes_.contains(node) || meets(ends[0], ends[1]) || meets(ends[0], node) || meets(node, ends[1]);
        return {node, ends, side_at(hanging), jump};
    }

    // Of the edge at the node: an end on the crack counts as +, whatever the side of the edge. Of an edge that the
    // crack runs along, what hangs is beyond it.
    [[nodiscard]] double side_at(const HangingNode& hanging) const {
        const auto side_of = [&](int node) {
            for (const Term& term : result_.terms[at(node)])
                if (term.kind == Term::Kind::Heaviside) return term.shift;
            return 0.0;
        };
        if (const double own = side_of(hanging.node); own != 0.0) return own;
        for (const int end : hanging.ends)
            if (side_of(end) != 0.0 && !met_nodes_.contains(end)) return side_of(end);
        const double of_larger = result_.element_side[at(hanging.larger)];
        return edges_of_faces_.contains(std::minmax(hanging.ends[0], hanging.ends[1])) ? -of_larger : of_larger;
    }

    void add_crack(int crack, const CrackPath& path) {
        const CrackSides sides(mesh_, path);
        const int before = static_cast<int>(result_.tips.size());
        std::set<int> without_jump;  // the tip functions open the crack there
        if (path.tip_at_start) add_tip(crack, path, true, without_jump);
        if (path.tip_at_end) add_tip(crack, path, false, without_jump);
        bool jumps = false;
        for (const auto& [node, side] : sides.of_nodes()) {
            if (without_jump.contains(node)) continue;
            jumps = true;
            result_.terms[at(node)].push_back({Term::Kind::Heaviside, crack, 0, double(side)});
        }
        if (!jumps && tip_enrichment_.functions == 0)
            throw CaseError(
                fmt::format("crack {}: it is less than two elements long, and without tip functions none of "
                            "it opens; use smaller elements there",
                            crack));
        sides.put_on_elements(std::span(result_.tips).subspan(at(before)), result_.element_side);
        met_nodes_.insert(sides.nodes_on_crack().begin(), sides.nodes_on_crack().end());
        note_met_edges(path);
        result_.pieces.insert(result_.pieces.end(), path.pieces.begin(), path.pieces.end());
        result_.mouths.push_back(path.mouth());
        for (int tip = before; tip < std::ssize(result_.tips); ++tip) add_tip_terms(tip, path, sides);
    }

    void add_tip(int crack, const CrackPath& path, bool start, std::set<int>& without_jump) {
        const CrackPiece& piece = start ? path.pieces.front() : path.pieces.back();
        Tip tip;
        tip.crack = crack;
        const std::vector<Vec2>& points = path.points;
        tip.material = mesh_.material_of(piece.element);
        tip.s = start ? piece.s.front() : piece.s.back();
        tip.upper = start ? -1 : 1;
        tip.position = start ? points.front() : points.back();
        tip.beyond = start ? tip.s : path.length - tip.s;
        // Of the crack as given: the last piece may be short, and its other end snapped onto a node.
        const Vec2& before = start ? points[1] : points[points.size() - 2];
        tip.direction = ((start ? points.front() : points.back()) - before).normalized();
        if (tip_enrichment_.functions > 0) refuse_hook(path, piece, tip, start);
        result_.tips.push_back(tip);
        without_jump.merge(tip_enrichment_.functions == 0 ? front_nodes(mesh_, path, start) : tip_nodes(mesh_, piece));
    }

    // The crack lies behind its tip as far as the tip's functions act, or theta would run on to more than 3/2 pi.
    void refuse_hook(const CrackPath& path, const CrackPiece& piece, const Tip& tip, bool start) const {
        const std::vector<Vec2>& points = piece.points;
        const Vec2 into = start ? Vec2(points[points.size() - 2] - points.back()) : Vec2(points[1] - points[0]);
        const std::set<int> holders = tip_nodes(mesh_, piece);
        const auto is_ahead = [&](const Vec2& x) {
            return (x - tip.position).dot(tip.direction) > 1e-9 * (x - tip.position).norm();
        };
        const auto hooks = [&](const CrackPiece& other) {
            const auto& nodes = mesh_.elements[at(other.element)];
            return std::ranges::any_of(nodes, [&](int node) { return holders.contains(node); }) &&
                   std::ranges::any_of(other.points, is_ahead);
        };
        if (into.dot(tip.direction) >= 0.0 && std::ranges::none_of(path.pieces, hooks)) return;
        throw CrackOffMesh(fmt::format("crack {}: it turns by more than 90 degrees within two elements of its tip at "
                                       "({:.6g}, {:.6g}); use smaller elements there",
                                       tip.crack, tip.position.x(), tip.position.y()));
    }

    void note_met_edges(const CrackPath& path) {
        for (const CrackPiece& piece : path.pieces) {
            for (const double place : {piece.entry, piece.exit}) {
                if (place < 0.0 || place == std::floor(place)) continue;
                const auto& nodes = mesh_.elements[at(piece.element)];
                const int edge = static_cast<int>(place);
                const std::pair<int, int> ends = std::minmax(nodes[at(edge)], nodes[at((edge + 1) % 4)]);
                crossed_edges_.insert(ends);
                if (piece.neighbour >= 0) edges_of_faces_.insert(ends);
            }
        }
    }

    void add_tip_terms(int index, const CrackPath& path, const CrackSides& sides) {
        const Tip& tip = result_.tips[at(index)];
        const Term::Kind kind =
            tip_enrichment_.support == TipSupport::Gathered ? Term::Kind::Gathered : Term::Kind::Tip;
        for (const auto& [node, side] : enriched_nodes(index, *piece_of(path.pieces, tip), sides)) {
            const auto value = tip_functions(tip, mesh_.nodes[at(node)], side, tip_enrichment_.exponent).value;
            for (int alpha = 0; alpha < tip_enrichment_.functions; ++alpha)
                result_.terms[at(node)].push_back({kind, index, alpha, value[alpha]});
        }
    }

    /// Nodes that carry a tip's functions, with the side of the crack that chooses the branch of theta there.
    [[nodiscard]] std::map<int, int> enriched_nodes(int tip, const CrackPiece& piece, const CrackSides& sides) const {
        const std::set<int> about_tip = tip_nodes(mesh_, piece);
        std::set<int> nodes = about_tip;
        if (tip_enrichment_.support != TipSupport::Topological) {
            const double radius = disk_radius(tip, piece);
            for (int element = 0; element < static_cast<int>(mesh_.elements.size()); ++element) {
                // Whole elements: there the functions are complete.
                if ((centre(mesh_, element) - result_.tips[at(tip)].position).norm() > radius) continue;
                nodes.insert(mesh_.elements[at(element)].begin(), mesh_.elements[at(element)].end());
            }
            add_ends_of_edges(mesh_, nodes);
        }
        std::map<int, int> sides_of_nodes;
        for (const HangingNode& hanging : mesh_.hanging)  // what hangs follows
            if (nodes.contains(hanging.ends[0]) || nodes.contains(hanging.ends[1]))
                sides_of_nodes[hanging.node] = result_.element_side[at(hanging.larger)];
        for (const int node : nodes) sides_of_nodes.try_emplace(node, 0);
        for (auto& [node, side] : sides_of_nodes) {
            if (const auto own = sides.of_nodes().find(node); own != sides.of_nodes().end()) side = own->second;
            if (about_tip.contains(node)) side = sides.near_tip(piece, node);
        }
        return sides_of_nodes;
    }

    [[nodiscard]] double disk_radius(int tip, const CrackPiece& piece) const {
        const double size = diagonal(mesh_, piece.element);
        const double reach = tip_reach(mesh_, cracks_, result_.tips, tip, bend_to_element * size);
        if (!tip_enrichment_.radius) {
            // No element between two disks sees functions of both.
            constexpr double clear = 1.25;  // diagonals: from a disk's rim to its last nodes, and half an element
            return std::min({0.75 * reach, half_way_to_others(cracks_, result_.tips, tip) - clear * size,
                             tip_enrichment_.most_diagonals * size});
        }
        if (*tip_enrichment_.radius <= reach) return *tip_enrichment_.radius;
        const Vec2& x = result_.tips[at(tip)].position;
        throw CaseError(fmt::format(
            "fine.enrichment_radius: {} mm is too large for the tip at ({}, {}): the boundary, "
            "a bend of its own crack, or the middle between it and another tip or crack lies {:.4g} mm away",
            *tip_enrichment_.radius, x.x(), x.y(), reach));
    }

    const Mesh& mesh_;
    const std::vector<CrackSection>& cracks_;
    TipEnrichment tip_enrichment_;
    EnrichedMesh result_;
    std::set<int> met_nodes_;  // of all cracks so far
    std::set<std::pair<int, int>> crossed_edges_;
    std::set<std::pair<int, int>> edges_of_faces_;  // of those: on which the crack runs from or to a hanging node
};

/// n of the strain's r^(-n/(n+1)) at the tip. Behind a growing tip the metal has unloaded: there it is no power law's.
double singular_n(const Case& input) {
    const MaterialSection& metal = input.material;
    const bool of_power_law = metal.yield_stress && metal.isotropic.law == "power" && metal.kinematic.empty();
    return input.fine.enrichment_n.value_or(of_power_law && !input.growth ? metal.isotropic.n : 1.0);
}

}  // namespace

TipEnrichment choose_enrichment(const Case& input) {
    const FineSection& fine = input.fine;
    const double exponent = 1.0 / (singular_n(input) + 1.0);
    const TipEnrichment none{.functions = 0, .exponent = 0.5};
    const TipEnrichment single{.functions = 1, .exponent = exponent}, topological{.functions = 6, .exponent = exponent};
    const TipEnrichment growing{.functions = 1, .exponent = exponent, .none_below = small_elements};
    const bool leaves_faces = input.growth && some_touch(input.cracks);
    const TipEnrichment linear{.functions = 6, .exponent = exponent, .none_below = leaves_faces ? small_elements : 0.0};
    // Four of the six span the singular fields of elasticity.
    const TipEnrichment geometrical{
        .functions = 4, .exponent = 0.5, .support = TipSupport::Gathered, .radius = fine.enrichment_radius};
    const TipEnrichment near_sliding{
        .functions = 4, .exponent = 0.5, .support = TipSupport::Nodal, .most_diagonals = 1.6};
    switch (fine.enrichment) {
    case Enrichment::None:
        return none;
    case Enrichment::Single:
        return single;
    case Enrichment::Topological:
        return topological;
    case Enrichment::Geometrical:
        return geometrical;
    case Enrichment::Auto:
        break;
    }
    // What a function leaves on the faces moves opening loads, and a life by these is off by several times as much.
    if (leaves_faces && grows_by_opening_loads(*input.growth)) return none;
    if (may_yield(input)) return input.growth ? growing : single;
    if (has_friction(input.cracks)) return near_sliding;
    return needs_fine(input) ? linear : geometrical;
}

EnrichedMesh enrich(const Mesh& mesh, const std::vector<CrackSection>& cracks, const TipEnrichment& tips) {
    return Enricher(mesh, cracks, tips).enrich();
}

}  // namespace stria::coarse
