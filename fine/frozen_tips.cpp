#include "fine/frozen_tips.hpp"

#include <algorithm>

#include "common/fem/crack_faces.hpp"

namespace stria::fine {
namespace {

bool of_tip(const Term& term, int tip) { return term.kind == Term::Kind::Tip && term.owner == tip; }

}  // namespace

void FrozenTips::freeze(const EnrichedMesh& mesh, int tip, const Eigen::VectorXd& displacement) {
    std::vector<int> elements;
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        const auto sees = [&](int node) {
            return std::ranges::any_of(mesh.terms[static_cast<std::size_t>(node)],
                                       [&](const Term& term) { return of_tip(term, tip); });
        };
        if (std::ranges::any_of(mesh.elements[static_cast<std::size_t>(e)], sees)) elements.push_back(e);
    }
    if (elements.empty()) return;
    Frozen frozen{extract(mesh, elements), {}, mesh.tips[static_cast<std::size_t>(tip)].crack, 1e300, -1e300};
    Eigen::VectorXd own = Eigen::VectorXd::Zero(mesh.unknowns);
    for (const auto& [node, term, unknown] : mesh.own_unknowns()) {
        if (term > 0 && of_tip(mesh.terms[static_cast<std::size_t>(node)][static_cast<std::size_t>(term - 1)], tip))
            own.segment<2>(unknown) = displacement.segment<2>(unknown);
    }
    frozen.displacement = carry_over(mesh, own, frozen.mesh, Eigen::VectorXd::Zero(frozen.mesh.unknowns));
    for (const CrackPiece& piece : frozen.mesh.pieces) {
        if (piece.crack != frozen.crack) continue;
        frozen.first_s = std::min(frozen.first_s, piece.s.front());
        frozen.last_s = std::max(frozen.last_s, piece.s.back());
    }
    tips_.push_back(std::move(frozen));
}

Vec2 FrozenTips::jump(int crack, double s) const {
    Vec2 sum = Vec2::Zero();
    for (const Frozen& frozen : tips_) {
        if (frozen.crack == crack && s >= frozen.first_s && s <= frozen.last_s)
            sum += face_station_at(frozen.mesh, crack, s).jump(frozen.displacement);
    }
    return sum;
}

}  // namespace stria::fine
