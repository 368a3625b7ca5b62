#include "coarse/model/enrichment.hpp"

#include <fmt/format.h>
#include <map>
#include <numeric>
#include <set>

#include "coarse/model/tip_reach.hpp"
#include "common/enrichment/tip_functions.hpp"
#include "common/error.hpp"
#include "common/geometry/clipping.hpp"
#include "common/index.hpp"
#include "common/integration/cut_element.hpp"

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
        result_.terms.resize(mesh.nodes.size());
        result_.element_side.assign(mesh.elements.size(), 0);
        result_.tip_exponent = tips.exponent;
        result_.tip_functions = tips.functions;
    }

    EnrichedMesh enrich() {
        for (int crack = 0; crack < static_cast<int>(cracks_.size()); ++crack) {
            const CrackPath path = resolve_crack(mesh_, crack, cracks_[at(crack)].points);
            add_crack(crack, path);
        }
        for (std::size_t e = 0; e < mesh_.elements.size(); ++e) require_one_crack(e);
        for (const HangingNode& hanging : mesh_.hanging) result_.tied.push_back(tie(hanging));
        result_.number();
        return std::move(result_);
    }

private:
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
                        *cracks.rbegin() + 1, x.x(), x.y(), *cracks.begin() + 1));
                }
                if (heaviside) continue;
                if (last_tip >= 0 && last_tip != term.owner) {
                    throw CaseError(fmt::format(
                        "crack {}: near ({}, {}) its two tips are less than two elements apart; use smaller elements",
                        *cracks.begin() + 1, x.x(), x.y()));
                }
                last_tip = term.owner;
            }
        }
    }

    [[nodiscard]] TiedNode tie(const HangingNode& hanging) const {
        const auto [node, ends, larger] = hanging;
        for (const int n : {node, ends[0], ends[1]})
            require(!has_tip_function(n), "tip functions end within the smallest elements");
        const auto meets = [&](int a, int b) { return crossed_edges_.contains(std::minmax(a, b)); };
        const bool jump =
            met_nodes_.contains(node) || meets(ends[0], ends[1]) || meets(ends[0], node) || meets(node, ends[1]);
        return {node, ends, side_at(hanging), jump};
    }

    // Of the edge at the node: an end on the crack counts as +, whatever the side of the edge.
    [[nodiscard]] double side_at(const HangingNode& hanging) const {
        const auto side_of = [&](int node) {
            for (const Term& term : result_.terms[at(node)])
                if (term.kind == Term::Kind::Heaviside) return term.shift;
            return 0.0;
        };
        if (const double own = side_of(hanging.node); own != 0.0) return own;
        for (const int end : hanging.ends)
            if (side_of(end) != 0.0 && !met_nodes_.contains(end)) return side_of(end);
        return result_.element_side[at(hanging.larger)];
    }

    [[nodiscard]] bool has_tip_function(int node) const {
        return std::ranges::any_of(result_.terms[at(node)],
                                   [](const Term& term) { return term.kind != Term::Kind::Heaviside; });
    }

    void add_crack(int crack, const CrackPath& path) {
        node_side_.clear();
        on_crack_.clear();
        std::set<int> without_jump;  // the tip functions open the crack there
        if (path.tip_at_start) add_tip(crack, path, true, without_jump);
        if (path.tip_at_end) add_tip(crack, path, false, without_jump);
        for (const CrackPiece& piece : path.pieces) note_sides(piece);
        for (const auto& [node, side] : node_side_) {
            if (!without_jump.contains(node))
                result_.terms[at(node)].push_back({Term::Kind::Heaviside, crack, 0, double(side)});
        }
        set_element_sides(path);
        note_met_edges(path);
        result_.pieces.insert(result_.pieces.end(), path.pieces.begin(), path.pieces.end());
        add_tip_terms(path);
    }

    void add_tip(int crack, const CrackPath& path, bool start, std::set<int>& without_jump) {
        const CrackPiece& piece = start ? path.pieces.front() : path.pieces.back();
        Tip tip;
        tip.crack = crack;
        tip.s = start ? 0.0 : path.length;
        tip.upper = start ? -1 : 1;
        tip.position = start ? piece.points.front() : piece.points.back();
        // Of the crack as given: the last piece may be short, and its other end snapped onto a node.
        const std::vector<Vec2>& points = cracks_[at(crack)].points;
        const Vec2& before = start ? points[1] : points[points.size() - 2];
        tip.direction = ((start ? points.front() : points.back()) - before).normalized();
        result_.tips.push_back(tip);
        without_jump.merge(tip_nodes(piece));
    }

    // Side of the nodes of cut elements. A node on the crack counts as + (docs/method.md, section 2).
    void note_sides(const CrackPiece& piece) {
        for (const double place : {piece.entry, piece.exit}) note_if_node(piece, place);
        const bool holds_tip = piece.entry < 0.0 || piece.exit < 0.0;
        if (piece.neighbour >= 0 || holds_tip) return;
        const CutElement cut = cut_element(corners(piece.element), piece);
        for (const int node : mesh_.elements[at(piece.element)]) {
            if (on_crack_.contains(node)) continue;
            node_side_[node] = side_of_polygon(cut.left, mesh_.nodes[at(node)]) >= 0 ? 1 : -1;
        }
    }

    void note_met_edges(const CrackPath& path) {
        met_nodes_.insert(on_crack_.begin(), on_crack_.end());
        for (const CrackPiece& piece : path.pieces) {
            for (const double place : {piece.entry, piece.exit}) {
                if (place < 0.0 || place == std::floor(place)) continue;
                const auto& nodes = mesh_.elements[at(piece.element)];
                const int edge = static_cast<int>(place);
                crossed_edges_.insert(std::minmax(nodes[at(edge)], nodes[at((edge + 1) % 4)]));
            }
        }
    }

    void note_if_node(const CrackPiece& piece, double place) {
        if (place < 0.0 || place != std::floor(place)) return;
        const int node = mesh_.elements[at(piece.element)][at(static_cast<int>(place) % 4)];
        node_side_[node] = 1;
        on_crack_.insert(node);
    }

    // Elements that touch the crack without being cut: at a node, left or right of the two pieces that meet there;
    // beside a tip, like the nodes of its element (a kink may put them across the straight line behind the tip); along
    // an edge.
    void set_element_sides(const CrackPath& path) {
        std::set<int> cut;
        for (const CrackPiece& piece : path.pieces)
            if (piece.neighbour < 0) cut.insert(piece.element);
        const auto around = elements_around_nodes(mesh_);
        for (const int node : on_crack_) {
            const auto [before, after] = neighbours_on_crack(path, mesh_.nodes[at(node)]);
            for (const int element : around[at(node)]) {
                if (!cut.contains(element))
                    result_.element_side[at(element)] = side(before, mesh_.nodes[at(node)], after, element);
            }
        }
        if (path.tip_at_start) set_sides_beside_tip(path.pieces.front(), cut, around);
        if (path.tip_at_end) set_sides_beside_tip(path.pieces.back(), cut, around);
        for (const CrackPiece& piece : path.pieces) {
            if (piece.neighbour < 0) continue;
            result_.element_side[at(piece.element)] = -1;
            result_.element_side[at(piece.neighbour)] = 1;
        }
    }

    void set_sides_beside_tip(const CrackPiece& piece, const std::set<int>& cut,
                              const std::vector<std::vector<int>>& around) {
        std::map<int, std::set<int>> sides;  // of each element's nodes; both: it lies ahead of the tip
        for (const int node : tip_nodes(piece)) {
            if (on_crack_.contains(node)) continue;
            for (const int element : around[at(node)]) sides[element].insert(side_near_tip(piece, node));
        }
        for (const auto& [element, seen] : sides) {
            signed char& known = result_.element_side[at(element)];
            if (known == 0 && seen.size() == 1 && !cut.contains(element))
                known = static_cast<signed char>(*seen.begin());
        }
    }

    /// Nodes of the element or elements that hold the tip at the end of a piece.
    [[nodiscard]] std::set<int> tip_nodes(const CrackPiece& piece) const {
        std::set<int> nodes;
        for (const int element : {piece.element, piece.neighbour}) {
            if (element >= 0) nodes.insert(mesh_.elements[at(element)].begin(), mesh_.elements[at(element)].end());
        }
        return nodes;
    }

    // Ahead of the tip either side will do.
    [[nodiscard]] int side_near_tip(const CrackPiece& piece, int node) const {
        if (on_crack_.contains(node)) return 1;
        const Vec2& x = mesh_.nodes[at(node)];
        if (piece.neighbour >= 0) return orientation(piece.points.front(), piece.points.back(), x) >= 0 ? 1 : -1;
        return side_of_polygon(cut_element(corners(piece.element), piece).left, x) >= 0 ? 1 : -1;
    }

    [[nodiscard]] static std::pair<Vec2, Vec2> neighbours_on_crack(const CrackPath& path, const Vec2& x) {
        std::optional<Vec2> before, after;
        for (const CrackPiece& piece : path.pieces) {
            if (piece.points.front() == x) after = piece.points[1];
            if (piece.points.back() == x) before = piece.points[piece.points.size() - 2];
        }
        if (!before) before = 2.0 * x - *after;
        if (!after) after = 2.0 * x - *before;
        return {*before, *after};
    }

    [[nodiscard]] signed char side(const Vec2& before, const Vec2& x, const Vec2& after, int element) const {
        const auto c = corners(element);
        const Vec2 centre = (c[0] + c[1] + c[2] + c[3]) / 4.0;
        const bool left_of_first = orientation(before, x, centre) > 0,
                   left_of_second = orientation(x, after, centre) > 0;
        const bool turns_left = orientation(before, x, after) >= 0;
        return (turns_left ? left_of_first && left_of_second : left_of_first || left_of_second) ? 1 : -1;
    }

    void add_tip_terms(const CrackPath& path) {
        const int count = int(path.tip_at_start) + int(path.tip_at_end);
        const bool gathered = tip_enrichment_.support == TipSupport::Gathered;
        for (int k = 0; k < count; ++k) {
            const int index = static_cast<int>(result_.tips.size()) - count + k;
            const CrackPiece& piece = path.tip_at_start && k == 0 ? path.pieces.front() : path.pieces.back();
            for (const auto& [node, side] : enriched_nodes(result_.tips[at(index)], piece)) {
                const auto value =
                    tip_functions(result_.tips[at(index)], mesh_.nodes[at(node)], side, tip_enrichment_.exponent).value;
                for (int alpha = 0; alpha < tip_enrichment_.functions; ++alpha) {
                    result_.terms[at(node)].push_back(
                        {gathered ? Term::Kind::Gathered : Term::Kind::Tip, index, alpha, value[alpha]});
                }
            }
        }
    }

    /// Nodes that carry a tip's functions, with the side of the crack that chooses the branch of theta there.
    [[nodiscard]] std::map<int, int> enriched_nodes(const Tip& tip, const CrackPiece& piece) const {
        std::map<int, int> nodes;
        if (tip_enrichment_.support != TipSupport::Topological) {
            const double radius = disk_radius(tip, piece);
            for (int element = 0; element < static_cast<int>(mesh_.elements.size()); ++element) {
                const auto c = corners(element);  // whole elements: there the functions are complete
                if (((c[0] + c[1] + c[2] + c[3]) / 4.0 - tip.position).norm() > radius) continue;
                for (const int node : mesh_.elements[at(element)]) {
                    const auto beside = node_side_.find(node);
                    nodes[node] = beside != node_side_.end() ? beside->second : 0;
                }
            }
        }
        for (const int node : tip_nodes(piece)) nodes[node] = side_near_tip(piece, node);
        return nodes;
    }

    [[nodiscard]] double disk_radius(const Tip& tip, const CrackPiece& piece) const {
        const auto c = corners(piece.element);
        const double diagonal = (c[2] - c[0]).norm();
        const double reach = tip_reach(mesh_, cracks_, result_.tips, tip, bend_to_element * diagonal);
        // Beyond some twenty elements a larger disk costs more than it gains.
        if (!tip_enrichment_.radius) return std::min(0.75 * reach, 20.0 * diagonal);
        if (*tip_enrichment_.radius <= reach) return *tip_enrichment_.radius;
        throw CaseError(fmt::format(
            "fine.enrichment_radius: {} mm is too large for the tip at ({}, {}): the boundary, "
            "a bend of its own crack, or the middle between it and another tip or crack lies {:.4g} mm away",
            *tip_enrichment_.radius, tip.position.x(), tip.position.y(), reach));
    }

    [[nodiscard]] std::array<Vec2, 4> corners(int element) const {
        const auto& n = mesh_.elements[at(element)];
        return {mesh_.nodes[at(n[0])], mesh_.nodes[at(n[1])], mesh_.nodes[at(n[2])], mesh_.nodes[at(n[3])]};
    }

    const Mesh& mesh_;
    const std::vector<CrackSection>& cracks_;
    TipEnrichment tip_enrichment_;
    EnrichedMesh result_;
    std::map<int, int> node_side_;  // of the present crack
    std::set<int> on_crack_;
    std::set<int> met_nodes_;  // of all cracks so far
    std::set<std::pair<int, int>> crossed_edges_;
};

}  // namespace

TipEnrichment choose_enrichment(const Case& input) {
    const TipEnrichment none{0, 0.5}, single{1, 0.5};
    const TipEnrichment topological{6, 1.0 / (input.fine.enrichment_n.value_or(1.0) + 1.0)};
    // Four of the six span the singular fields of elasticity.
    const TipEnrichment geometrical{4, 0.5, TipSupport::Gathered, input.fine.enrichment_radius};
    switch (input.fine.enrichment) {
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
    if (input.material.yield_stress) return single;
    return needs_fine(input) ? topological : geometrical;
}

EnrichedMesh enrich(const Mesh& mesh, const std::vector<CrackSection>& cracks, const TipEnrichment& tips) {
    return Enricher(mesh, cracks, tips).enrich();
}

}  // namespace stria::coarse
