#include "common/integration/element_field.hpp"

#include "common/fem/shape_q4.hpp"
#include "common/index.hpp"

namespace stria {

ElementField::ElementField(const EnrichedMesh& mesh, int element, const CrackPiece* cut)
    : basis_(mesh, element, cut != nullptr) {
    if (cut != nullptr) sides_ = cut_element(basis_.corners(), *cut);
}

std::vector<ElementField::Share> ElementField::at_place(const Vec2& x) const {
    std::vector<Share> shares;
    add(x, is_cut() ? sides_->side_of(x) : 0, 1.0, shares);
    return shares;
}

std::vector<ElementField::Share> ElementField::half_jump(const Vec2& x) const {
    std::vector<Share> shares;
    add(x, 1, 0.5, shares);
    add(x, -1, -0.5, shares);
    return shares;
}

void ElementField::add(const Vec2& x, int side, double factor, std::vector<Share>& shares) const {
    BasisValues at_x;
    basis_.evaluate(map_to_parent(basis_.corners(), x), x, side, at_x);
    for (int f = 0; f < basis_.functions(); ++f)
        shares.push_back({basis_.unknowns()[at(2 * f)], factor * at_x.value[f]});
}

Vec2 sum_of(const std::vector<ElementField::Share>& shares, const Eigen::VectorXd& values) {
    Vec2 sum = Vec2::Zero();
    for (const auto& [unknown, weight] : shares) sum += weight * values.segment<2>(unknown);
    return sum;
}

}  // namespace stria
