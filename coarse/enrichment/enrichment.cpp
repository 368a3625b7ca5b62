#include "coarse/enrichment/enrichment.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "coarse/enrichment/crack_front.hpp"
#include "coarse/enrichment/crack_sides.hpp"
#include "coarse/enrichment/crack_tips.hpp"
#include "coarse/enrichment/tied_nodes.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/enrichment/tip_support.hpp"
#include "common/enrichment/tip_functions.hpp"
#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"
#include "common/index_set.hpp"

namespace stria::coarse {
namespace {

EnrichedMesh without_cracks(const BodyMesh& mesh) {
    EnrichedMesh plain;
    plain.nodes = mesh.nodes();
    plain.elements = mesh.elements();
    plain.node_ids = mesh.node_ids();
    plain.element_ids = mesh.element_ids();
    plain.material = mesh.material();
    plain.terms = TermsOfNodes(mesh->nodes.size());
    plain.element_side.assign(mesh->elements.size(), 0);
    return plain;
}

/// Whether the elements at all tips of a path are smaller than a part of its length in the body.
bool has_small_elements(const Mesh& mesh, const CrackPath& path, double part) {
    const double length = path.pieces.back().s.back() - path.pieces.front().s.front();
    const auto is_small = [&](const CrackPiece& piece) { return edge_of_square(mesh, piece.element) < part * length; };
    return (!path.tip_at_start || is_small(path.pieces.front())) && (!path.tip_at_end || is_small(path.pieces.back()));
}

[[noreturn]] void refuse_so_near(int crack, int other, const Vec2& place) {
    throw CaseError(
        fmt::format("crack {}: near ({:.6g}, {:.6g}) it is less than two elements from crack {}; use smaller elements",
                    crack, place.x(), place.y(), other));
}

/// Faces that end on an edge have no functions about their tip which others would meet: two cracks that grow into each
/// other would hang together by a node, and pass each other.
void require_room_at_tips(const BodyMesh& mesh, const std::vector<CrackPath>& paths) {
    std::vector<std::set<int>> nodes(paths.size());
    for (std::size_t k = 0; k < paths.size(); ++k)
        for (const CrackPiece& piece : paths[k].pieces) nodes[k].merge(tip_nodes(mesh, piece));
    const auto look = [&](std::size_t k, const CrackPiece& piece) {
        for (const int node : tip_nodes(mesh, piece))
            for (std::size_t other = 0; other < paths.size(); ++other)
                if (other != k && nodes[other].contains(node))
                    refuse_so_near(static_cast<int>(std::max(k, other)), static_cast<int>(std::min(k, other)),
                                   mesh->nodes[at(node)]);
    };
    for (std::size_t k = 0; k < paths.size(); ++k) {
        if (paths[k].tip_at_start) look(k, paths[k].pieces.front());
        if (paths[k].tip_at_end) look(k, paths[k].pieces.back());
    }
}

/// Sides and jumps of an element belong to one crack, and a node sees at most one tip.
void require_one_crack(const EnrichedMesh& mesh, std::size_t element) {
    std::set<int> cracks;
    for (const int node : mesh.elements[element]) {
        int last_tip = -1;
        for (const Term& term : mesh.terms[at(node)]) {
            const bool heaviside = term.kind == Term::Kind::Heaviside;
            cracks.insert(heaviside ? term.owner : mesh.tips[at(term.owner)].crack);
            const Vec2& x = mesh.nodes[at(node)];
            if (cracks.size() > 1) refuse_so_near(*cracks.rbegin(), *cracks.begin(), x);
            if (heaviside) continue;
            if (last_tip >= 0 && last_tip != term.owner) {
                throw CaseError(
                    fmt::format("crack {}: near ({:.6g}, {:.6g}) its two tips are less than two elements apart; use "
                                "smaller elements",
                                *cracks.begin(), x.x(), x.y()));
            }
            last_tip = term.owner;
        }
    }
}

/// Puts the terms of one crack after the other on the nodes.
class Enricher {
public:
    Enricher(const BodyMesh& mesh, const std::vector<CrackSection>& cracks, const TipEnrichment& tips)
        : mesh_(mesh), cracks_(cracks), tip_enrichment_(tips), result_(without_cracks(mesh)) {
        result_.tip_exponent = tips.exponent;
        for (const CrackSection& crack : cracks) result_.grown_at_start.push_back(crack.grown_at_start);
    }

    EnrichedMesh enrich() {
        std::vector<CrackPath> paths;
        for (int crack = 0; crack < std::ssize(cracks_); ++crack)
            paths.push_back(resolve_crack(mesh_, crack, cracks_[at(crack)].points));
        if (std::ranges::all_of(paths, [&](const CrackPath& path) {
                return has_small_elements(mesh_, path, tip_enrichment_.none_below);
            }))
            tip_enrichment_.functions = 0;
        result_.tip_functions = tip_enrichment_.functions;
        if (tip_enrichment_.functions == 0) {
            if (paths.size() > 1) require_room_at_tips(mesh_, paths);
            for (CrackPath& path : paths) path = with_fronts_on_edges(mesh_, std::move(path));
        }
        if (paths.size() > 1 && tip_enrichment_.functions > 0 && tip_enrichment_.support == TipSupport::Gathered)
            for (const CrackPath& path : paths) wanted_.push_back(nodes_of_crack(mesh_, path));
        for (const CrackPath& path : paths) add_crack(path);
        for (const int e : mesh_.elements_about(result_.terms.nodes())) require_one_crack(result_, at(e));
        result_.tied = tied_nodes(mesh_->hanging, result_, beside_);
        result_.number();
        return std::move(result_);
    }

private:
    void add_crack(const CrackPath& path) {
        const CrackSides sides(mesh_, path);
        const std::vector<Tip> tips = tips_of(mesh_, path);
        if (tip_enrichment_.functions > 0)
            for (const Tip& tip : tips) require_behind(mesh_, path, tip);
        add_jumps(path, tips, sides);
        sides.put_on_elements(tips, result_.element_side);
        beside_.insert(sides.of_hanging_too().begin(), sides.of_hanging_too().end());
        result_.pieces.insert(result_.pieces.end(), path.pieces.begin(), path.pieces.end());
        result_.mouths.push_back(path.mouth());
        const std::size_t before = result_.tips.size();
        result_.tips.insert(result_.tips.end(), tips.begin(), tips.end());
        for (std::size_t tip = before; tip < result_.tips.size(); ++tip)
            add_functions(static_cast<int>(tip), last_piece(path, result_.tips[tip]), sides);
    }

    void add_jumps(const CrackPath& path, const std::vector<Tip>& tips, const CrackSides& sides) {
        std::set<int> without_jump;  // the tip functions open the crack there, or it is closed
        for (const Tip& tip : tips)
            without_jump.merge(tip_enrichment_.functions == 0 ? front_nodes(mesh_, path, tip.upper < 0)
                                                              : tip_nodes(mesh_, last_piece(path, tip)));
        const int crack = path.pieces.front().crack;
        bool jumps = false;
        for (const auto& [node, side] : sides.of_nodes()) {
            if (without_jump.contains(node)) continue;
            jumps = true;
            result_.terms.of(at(node)).push_back({Term::Kind::Heaviside, crack, 0, double(side)});
        }
        if (!jumps && tip_enrichment_.functions == 0)
            throw CaseError(
                fmt::format("crack {}: it is less than two elements long, and without tip functions none of "
                            "it opens; use smaller elements there",
                            crack));
    }

    void add_functions(int index, const CrackPiece& piece, const CrackSides& sides) {
        const Tip& tip = result_.tips[at(index)];
        const auto [nodes, share] = support_of_tip(mesh_, tip_enrichment_, tip, piece, room_about(index, piece));
        const Term::Kind kind = share ? Term::Kind::Gathered : Term::Kind::Tip;
        const std::map<int, int> side_of = branches(nodes, piece, sides);
        sides.put_behind_tip(tip, side_of, result_.element_side);
        for (const auto& [node, side] : side_of) {
            const auto value = tip_functions(tip, mesh_->nodes[at(node)], side, tip_enrichment_.exponent).value;
            for (int alpha = 0; alpha < tip_enrichment_.functions; ++alpha)
                result_.terms.of(at(node)).push_back({kind, index, alpha, value[alpha]});
        }
    }

    [[nodiscard]] RoomOfDisk room_about(int index, const CrackPiece& piece) const {
        const double size = diagonal(*mesh_, piece.element);
        const Tip& tip = result_.tips[at(index)];
        return {.of_others = left_to_others(mesh_, wanted_, tip),
                .in_body = room_in_body(mesh_, cracks_, tip, bend_to_element * size),
                .other_end = half_way_to_other_end(result_.tips, index),
                .other_cracks = half_way_to_other_cracks(cracks_, result_.tips, index),
                .diagonal = size};
    }

    /// Nodes of a tip's functions and what hangs between them, with the side of the crack that chooses the branch of
    /// theta there.
    [[nodiscard]] std::map<int, int> branches(const std::set<int>& nodes, const CrackPiece& piece,
                                              const CrackSides& sides) const {
        std::map<int, int> side_of;
        for (const HangingNode& hanging : mesh_->hanging)  // what hangs follows
            if (contains_any(nodes, hanging.ends)) side_of[hanging.node] = 0;
        for (const int node : nodes) side_of[node] = 0;
        const std::set<int> about_tip = tip_nodes(mesh_, piece);
        for (auto& [node, side] : side_of) {
            const auto own = sides.of_hanging_too().find(node);
            side = own != sides.of_hanging_too().end() ? own->second : sides.of_place(mesh_->nodes[at(node)]);
            if (about_tip.contains(node)) side = sides.near_tip(piece, node);
        }
        return side_of;
    }

    const BodyMesh& mesh_;
    const std::vector<CrackSection>& cracks_;
    TipEnrichment tip_enrichment_;
    EnrichedMesh result_;
    std::vector<NodesOfCrack> wanted_;  // per crack; empty: there is one, or functions keep to the elements of tips
    std::map<int, int> beside_;         // CrackSides::of_hanging_too(), of all cracks so far
};

}  // namespace

EnrichedMesh enrich(const BodyMesh& mesh, const std::vector<CrackSection>& cracks, const TipEnrichment& tips) {
    return Enricher(mesh, cracks, tips).enrich();
}

}  // namespace stria::coarse
