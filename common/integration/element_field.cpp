#include "common/integration/element_field.hpp"

#include <algorithm>

#include "common/fem/shape_q4.hpp"
#include "common/index.hpp"

namespace stria {

Vec2 sum_of(const Shares& shares, const Eigen::VectorXd& values) {
    Vec2 sum = Vec2::Zero();
    for (const auto& [unknown, weight] : shares) sum += weight * values.segment<2>(unknown);
    return sum;
}

ElementField::ElementField(const EnrichedMesh& mesh, int element, const CrackPiece* cut)
    : basis_(mesh, element, cut != nullptr), own_side_(cut != nullptr ? 0 : mesh.element_side[at(element)]) {
    if (cut != nullptr) sides_ = cut_element(basis_.corners(), *cut);
}

// The boundary itself is on no side.
int ElementField::side_of(const Vec2& x) const {
    constexpr double inwards = 1e-6;
    const auto& corners = basis_.corners();
    return sides_->side_of(x + inwards * ((corners[0] + corners[1] + corners[2] + corners[3]) / 4.0 - x));
}

Shares ElementField::on_side(const Vec2& x, int side) const {
    BasisValues at_x;
    basis_.evaluate(map_to_parent(basis_.corners(), x), x, side, at_x);
    Shares shares;
    for (int f = 0; f < basis_.functions(); ++f) shares.push_back({basis_.unknowns()[at(2 * f)], at_x.value[f]});
    return shares;
}

FieldAtNode::FieldAtNode(const Vec2& x, const std::vector<Term>& terms) : x_(x) {
    const auto jump = std::ranges::find(terms, Term::Kind::Heaviside, &Term::kind);
    if (jump != terms.end()) own_side_ = jump->shift > 0.0 ? 1 : -1;
}

void FieldAtNode::add(const ElementField& element) {
    if (element.is_cut()) {
        for (const int side : {-1, 1}) sides_[side > 0 ? 1 : 0] = element.on_side(x_, side);
        if (own_side_ == 0) without_jump_ = sides_[element.side_of(x_) > 0 ? 1 : 0];
        return;
    }
    const int side = element.own_side();
    Shares shares = element.on_side(x_, side);
    if (side != 0) sides_[side > 0 ? 1 : 0] = shares;
    if (side == 0 || own_side_ == 0) without_jump_ = std::move(shares);
}

// Beside a cut element one that is not cut tells of the side that it lies on. Where a crack is carried along it may be
// the other one.
const std::optional<Shares>& FieldAtNode::standard() const {
    const std::optional<Shares>& own = sides_[own_side_ > 0 ? 1 : 0];
    return own_side_ != 0 && own ? own : without_jump_;
}

std::optional<Shares> FieldAtNode::half_jump() const {
    if (!sides_[0] || !sides_[1]) return std::nullopt;
    Shares shares;
    for (const auto& [unknown, weight] : *sides_[1]) shares.push_back({unknown, weight / 2.0});
    for (const auto& [unknown, weight] : *sides_[0]) shares.push_back({unknown, -weight / 2.0});
    return shares;
}

}  // namespace stria
