// The yardstick of the coupling tests: structure, zone and contact in one sparse matrix, plain Newton, no condensation.
#pragma once

#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/equilibrium/equilibrium_sections.hpp"
#include "fine/zone/zone_system.hpp"

namespace stria {

class MonolithicFactory : public coarse::EquilibriumFactory {
public:
    explicit MonolithicFactory(const Case& input) : zone_(input), input_(input) {}
    std::unique_ptr<coarse::Equilibrium> make(const coarse::Structure& structure, const coupling::Patch* patch,
                                              const Eigen::VectorXd& committed,
                                              const coarse::LoadFactors& factors) override;
    void extend_zone(const coupling::Patch& patch) override { zone_.set_patch(patch); }
    [[nodiscard]] bool keeps_increments() const override { return true; }
    std::unique_ptr<coarse::Equilibrium> resume(const coarse::Structure& structure, const coupling::Patch* patch,
                                                const Eigen::VectorXd& committed,
                                                const coupling::ZoneSnapshot& zone) override;
    coupling::ZoneState zone_state() override { return zone_.state(); }
    coupling::ZoneSnapshot zone_snapshot() override { return zone_.snapshot(); }
    void keep_zone() override { kept_ = zone_.snapshot(); }
    coupling::ZoneSnapshot kept_zone() override { return kept_; }

private:
    fine::ZoneSystem zone_;
    coupling::ZoneSnapshot kept_;
    coarse::EquilibriumSections input_;
};

}  // namespace stria
