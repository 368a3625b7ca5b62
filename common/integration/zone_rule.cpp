#include "common/integration/zone_rule.hpp"

#include <algorithm>

#include "common/case/case_questions.hpp"
#include "common/fem/centre.hpp"
#include "common/integration/element_operator.hpp"

namespace stria {

IntegrationRule zone_rule(const FineSection& fine, bool may_yield) {
    return {.subcells = subcells_at_crack(fine),
            .far_subcells = subcells_elsewhere(fine),
            .singular_gauss = may_yield ? 2 : 6,
            .tip_points = may_yield ? 4 : 10};
}

bool lies_on_way(const Tip& tip, const Vec2& centre, double diagonal) {
    constexpr double beside = 1.5, behind = 2.0;  // of the element's diagonal
    const Vec2 from_tip = centre - tip.position;
    const double ahead = from_tip.dot(tip.direction);
    return ahead > -behind * diagonal && (from_tip - ahead * tip.direction).norm() < beside * diagonal;
}

bool lies_on_way_of_a_tip(const EnrichedMesh& mesh, int element) {
    const double size = diagonal(mesh, element);
    return std::ranges::any_of(mesh.tips,
                               [&](const Tip& tip) { return lies_on_way(tip, centre(mesh, element), size); });
}

int points_of_zone(const EnrichedMesh& mesh, int element, const CrackPiece* cut, const IntegrationRule& rule) {
    const bool has_functions =
        std::ranges::any_of(mesh.elements[at(element)], [&](int node) { return mesh.has_tip_functions(node); });
    constexpr int many = 8;  // of so many sub-quadrangles few are cut
    if ((cut != nullptr || has_functions) && rule.subcells <= many)
        return static_cast<int>(std::ssize(make_operator(mesh, element, cut, rule).points));
    const bool is_near = cut != nullptr || has_functions || lies_on_way_of_a_tip(mesh, element);
    const int subcells = is_near ? rule.subcells : rule.far_subcells.value_or(rule.subcells);
    return 4 * subcells * subcells;
}

}  // namespace stria
