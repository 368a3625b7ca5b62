#include "coarse/equilibrium/condensed/condensed_factory.hpp"

#include "coarse/equilibrium/condensed/condensed_equilibrium.hpp"

namespace stria::coarse {

std::unique_ptr<Equilibrium> CondensedFactory::make(const Structure& structure, const coupling::Patch* patch,
                                                    const Eigen::VectorXd& committed, const LoadFactors& factors) {
    if (patch != nullptr) fine_->set_patch(*patch);
    return std::make_unique<CondensedEquilibrium>(structure, patch != nullptr ? fine_ : nullptr, input_, committed,
                                                  factors);
}

std::unique_ptr<Equilibrium> CondensedFactory::resume(const Structure& structure, const coupling::Patch* patch,
                                                      const Eigen::VectorXd& committed,
                                                      const coupling::ZoneSnapshot& zone) {
    if (patch != nullptr) fine_->restore(*patch, zone);
    return std::make_unique<CondensedEquilibrium>(structure, patch != nullptr ? fine_ : nullptr, input_, committed,
                                                  0.0);
}

}  // namespace stria::coarse
