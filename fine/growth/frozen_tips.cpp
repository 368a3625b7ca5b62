#include "fine/growth/frozen_tips.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "common/enrichment/element_basis.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "common/index.hpp"
#include "common/integration/crack_faces.hpp"

namespace stria::fine {
namespace {

bool of_tip(const Term& term, int tip) { return term.kind == Term::Kind::Tip && term.owner == tip; }

bool is_newly_cut(const EnrichedMesh& before, const EnrichedMesh& next, const CrackPiece& piece) {
    const int id = next.element_ids[at(piece.element)];
    return std::ranges::none_of(before.pieces, [&](const CrackPiece& old) {
        return old.neighbour < 0 && before.element_ids[at(old.element)] == id;
    });
}

/// The values of Heaviside terms alone.
Eigen::VectorXd heaviside_values(const EnrichedMesh& mesh, const Eigen::VectorXd& displacement) {
    Eigen::VectorXd values = Eigen::VectorXd::Zero(mesh.unknowns);
    for (const auto& [node, term, unknown] : mesh.own_unknowns()) {
        const auto& terms = mesh.terms[at(node)];
        if (term > 0 && terms[at(term - 1)].kind == Term::Kind::Heaviside)
            values.segment<2>(unknown) = displacement.segment<2>(unknown);
    }
    return values;
}

bool opens(const EnrichedMesh& mesh, int element, const Eigen::VectorXd& values) {
    const ElementBasis basis(mesh, element, true);
    return std::ranges::any_of(basis.unknowns(), [&](int unknown) { return values[unknown] != 0.0; });
}

/// More elements where a hanging node of theirs would be without an end of its edge.
std::vector<int> with_ends_of_edges(const EnrichedMesh& mesh, const std::vector<int>& elements) {
    std::set<int> chosen(elements.begin(), elements.end()), nodes;
    for (std::vector<int> added = elements; !added.empty();) {
        std::set<int> missing;
        for (const int e : added) {
            for (const int node : mesh.elements[at(e)]) {
                nodes.insert(node);
                if (const TiedNode* tie = mesh.tie(node)) missing.insert(tie->ends.begin(), tie->ends.end());
            }
        }
        added.clear();
        for (int e = 0; e < std::ssize(mesh.elements) && !missing.empty(); ++e) {
            const auto& corners = mesh.elements[at(e)];
            const auto lacks = [&](int node) { return missing.contains(node) && !nodes.contains(node); };
            if (std::ranges::any_of(corners, lacks) && chosen.insert(e).second) added.push_back(e);
        }
    }
    return {chosen.begin(), chosen.end()};
}

}  // namespace

FrozenTips::FrozenTips(std::vector<coupling::FrozenTip> tips) {
    for (coupling::FrozenTip& tip : tips) keep(std::move(tip));
}

void FrozenTips::keep(coupling::FrozenTip tip) {
    Eigen::AlignedBox2d box;
    for (const Vec2& node : tip.mesh.nodes) box.extend(node);
    boxes_.push_back(box);
    std::vector<int> ids(at(tip.mesh.unknowns));
    for (const auto& [node, term, unknown] : tip.mesh.own_unknowns()) ids[at(unknown)] = tip.mesh.node_ids[at(node)];
    node_ids_.push_back(std::move(ids));
    tips_.push_back(std::move(tip));
}

void FrozenTips::freeze(const EnrichedMesh& mesh, int tip, const Eigen::VectorXd& displacement) {
    std::vector<int> elements;
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        const auto sees = [&](int node) {
            return std::ranges::any_of(mesh.terms[at(node)], [&](const Term& term) { return of_tip(term, tip); });
        };
        if (std::ranges::any_of(mesh.elements[at(e)], sees)) elements.push_back(e);
    }
    if (elements.empty()) return;
    coupling::FrozenTip frozen{extract(mesh, with_ends_of_edges(mesh, elements)), {}, mesh.tips[at(tip)].crack};
    Eigen::VectorXd own = Eigen::VectorXd::Zero(mesh.unknowns);
    for (const auto& [node, term, unknown] : mesh.own_unknowns()) {
        if (term > 0 && of_tip(mesh.terms[at(node)][at(term - 1)], tip))
            own.segment<2>(unknown) = displacement.segment<2>(unknown);
    }
    frozen.displacement = carry_over(mesh, own, frozen.mesh, Eigen::VectorXd::Zero(frozen.mesh.unknowns));
    keep(std::move(frozen));
}

void FrozenTips::keep_closed(const EnrichedMesh& before, const EnrichedMesh& next,
                             const Eigen::VectorXd& displacement) {
    const Eigen::VectorXd jumps = heaviside_values(next, displacement);
    std::map<int, std::vector<int>> opening;  // elements, by crack
    for (const CrackPiece& piece : next.pieces)
        if (piece.neighbour < 0 && is_newly_cut(before, next, piece) && opens(next, piece.element, jumps))
            opening[piece.crack].push_back(piece.element);
    for (auto& [crack, elements] : opening) {
        std::set<int> counting;  // by id
        for (const int e : elements) counting.insert(next.element_ids[at(e)]);
        coupling::FrozenTip frozen{extract(next, with_ends_of_edges(next, elements)), {}, crack};
        std::erase_if(frozen.mesh.pieces, [&](const CrackPiece& piece) {
            return !counting.contains(frozen.mesh.element_ids[at(piece.element)]);
        });
        frozen.displacement = -carry_over(next, jumps, frozen.mesh, Eigen::VectorXd::Zero(frozen.mesh.unknowns));
        keep(std::move(frozen));
    }
}

std::vector<FrozenTips::Share> FrozenTips::shares_of_jump(int crack, const Vec2& x) const {
    std::vector<Share> shares;
    for (std::size_t t = 0; t < tips_.size(); ++t) {
        const coupling::FrozenTip& frozen = tips_[t];
        if (frozen.crack != crack || boxes_[t].squaredExteriorDistance(x) > 1e-6 * boxes_[t].sizes().squaredNorm())
            continue;
        const auto s = arc_length_at(frozen.mesh, crack, x);
        if (!s) continue;
        for (const auto& [unknown, value, slope] : face_station_at(frozen.mesh, crack, *s).terms) {
            const Vec2 frozen_value = frozen.displacement.segment<2>(unknown);
            shares.push_back({node_ids_[t][at(unknown)], value * frozen_value, slope * frozen_value});
        }
    }
    return shares;
}

Vec2 FrozenTips::jump(int crack, const Vec2& x) const {
    Vec2 sum = Vec2::Zero();
    for (const Share& share : shares_of_jump(crack, x)) sum += share.jump;
    return sum;
}

Vec2 FrozenTips::slope(int crack, const Vec2& x) const {
    Vec2 sum = Vec2::Zero();
    for (const Share& share : shares_of_jump(crack, x)) sum += share.slope;
    return sum;
}

}  // namespace stria::fine
