#include "coarse/fracture/structure_rings.hpp"

#include <limits>

namespace stria::coarse {

std::vector<RingForms> StructureRings::forms_of(const CoarseElements& elements, const ElementSet& for_K) {
    std::vector<RingForms> tips;
    for (int tip = 0; tip < std::ssize(elements.scene().enriched.tips); ++tip) tips.emplace_back(elements, tip, for_K);
    return tips;
}

RingIntegrals StructureRings::integrals(const Eigen::VectorXd& u) const {
    if (!elements_->scene().initial_stress().any()) return integrals_of_displacement(u);
    RingIntegrals integrals;
    for (const RingForms& tip : tips_) integrals.push_back(tip.values_with_initial_stress(*elements_, u));
    return integrals;
}

RingIntegrals StructureRings::integrals_in_proportion(const Structure& structure, double load_factor,
                                                      std::int64_t& found) {
    if (!of_unit_load_) of_unit_load_ = integrals_of_displacement(structure.near_of_unit_load(found));
    RingIntegrals integrals = *of_unit_load_;
    for (std::vector<DomainIntegral>& of_tip : integrals)
        for (DomainIntegral& of_ring : of_tip) of_ring = of_ring.of_scaled(load_factor);
    return integrals;
}

RingIntegrals StructureRings::unknown() const {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    RingIntegrals integrals;
    for (const RingForms& tip : tips_)
        integrals.emplace_back(tip.rings().size(), DomainIntegral{.J = none, .rotation = none});
    return integrals;
}

RingIntegrals StructureRings::integrals_of_displacement(const Eigen::VectorXd& u) const {
    RingIntegrals integrals;
    for (const RingForms& tip : tips_) integrals.push_back(tip.values(*elements_, u));
    return integrals;
}

}  // namespace stria::coarse
