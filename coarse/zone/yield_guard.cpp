#include "coarse/zone/yield_guard.hpp"

#include <limits>

#include "coarse/zone/structure_stresses.hpp"

namespace stria::coarse {
namespace {

/// Where far elements are all but yielding no bound helps: to learn must not cost more than this many looks for
/// nothing.
constexpr int most_unpaid = 8;

}  // namespace

YieldGuard::YieldGuard(const Materials& materials) : limit_(materials.weakest_yield_stress() * (1.0 + 1e-9)) {}

void YieldGuard::turn_to(const Structure& structure, const Eigen::VectorXd& elastic) {
    structure_ = &structure;
    if (limit_ == std::numeric_limits<double>::infinity() || (far_ && far_->turn_to(structure))) return;
    unpaid_ = 0;
    far_.emplace(structure);
    if (elastic.size() > 0)
        far_->learn_pivot(gather(elastic, structure.rim()),
                          largest_far_stress(structure, elastic, StressPart::OfDisplacement));
}

std::vector<int> YieldGuard::elements_beyond(const Equilibrium& equilibrium) {
    if (!far_) return {};
    const Eigen::VectorXd& near = equilibrium.near_displacement();
    std::vector<int> yielding = near_elements_beyond(limit_, *structure_, near);
    const Eigen::VectorXd rim = gather(near, structure_->rim());
    if (far_->at(rim, equilibrium.factors()) <= limit_) {
        ++work_.structure_checks_by_bound;
        --unpaid_;
        return yielding;
    }
    ++work_.structure_checks_full;
    const Eigen::VectorXd whole = equilibrium.structure_displacement();
    const double largest = largest_far_stress(*structure_, whole, StressPart::Whole);
    if (largest > limit_) return stria::coarse::elements_beyond(limit_, *structure_, whole);
    if (unpaid_ < most_unpaid) {
        far_->learn(rim, equilibrium.factors(), largest);
        ++unpaid_;
    }
    return yielding;
}

}  // namespace stria::coarse
