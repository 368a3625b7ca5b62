#include "fine/frozen_tips.hpp"

#include <algorithm>
#include <optional>

#include "common/fem/crack_faces.hpp"

namespace stria::fine {
namespace {

/// Where a mesh's pieces of a crack hold a place.
std::optional<double> arc_length_at(const EnrichedMesh& mesh, int crack, const Vec2& x) {
    for (const CrackPiece& piece : mesh.pieces) {
        if (piece.crack != crack) continue;
        for (std::size_t k = 0; k + 1 < piece.points.size(); ++k) {
            const Vec2 d = piece.points[k + 1] - piece.points[k], to_x = x - piece.points[k];
            const double t = to_x.dot(d) / d.squaredNorm();
            if (t < -1e-9 || t > 1.0 + 1e-9 || (to_x - t * d).norm() > 1e-9 * d.norm()) continue;
            return piece.s[k] + std::clamp(t, 0.0, 1.0) * (piece.s[k + 1] - piece.s[k]);
        }
    }
    return std::nullopt;
}

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
    coupling::FrozenTip frozen{extract(mesh, elements), {}, mesh.tips[static_cast<std::size_t>(tip)].crack};
    Eigen::VectorXd own = Eigen::VectorXd::Zero(mesh.unknowns);
    for (const auto& [node, term, unknown] : mesh.own_unknowns()) {
        if (term > 0 && of_tip(mesh.terms[static_cast<std::size_t>(node)][static_cast<std::size_t>(term - 1)], tip))
            own.segment<2>(unknown) = displacement.segment<2>(unknown);
    }
    frozen.displacement = carry_over(mesh, own, frozen.mesh, Eigen::VectorXd::Zero(frozen.mesh.unknowns));
    tips_.push_back(std::move(frozen));
}

Vec2 FrozenTips::jump(int crack, const Vec2& x) const {
    Vec2 sum = Vec2::Zero();
    for (const coupling::FrozenTip& frozen : tips_) {
        if (frozen.crack != crack) continue;
        if (const auto s = arc_length_at(frozen.mesh, crack, x))
            sum += face_station_at(frozen.mesh, crack, *s).jump(frozen.displacement);
    }
    return sum;
}

}  // namespace stria::fine
