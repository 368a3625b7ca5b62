// Makes equilibria on Gamma over the port.
#pragma once

#include <memory>
#include <utility>

#include "coarse/equilibrium/equilibrium_factory.hpp"
#include "coarse/equilibrium/equilibrium_sections.hpp"
#include "coupling/fine_scale.hpp"

namespace stria::coarse {

/// Equilibrium of structure and zone over the port (null: no fine component).
class CondensedFactory : public EquilibriumFactory {
public:
    CondensedFactory(coupling::FineScale* fine, EquilibriumSections input) : fine_(fine), input_(std::move(input)) {}
    std::unique_ptr<Equilibrium> make(const Structure& structure, const coupling::Patch* patch,
                                      const Eigen::VectorXd& committed, const LoadFactors& factors) override;
    void begin_zone(const coupling::Patch& patch) override { fine_->begin_set_patch(patch); }
    void extend_zone(const coupling::Patch& patch) override { fine_->set_patch(patch); }
    [[nodiscard]] bool keeps_increments() const override { return fine_ != nullptr; }
    std::unique_ptr<Equilibrium> resume(const Structure& structure, const coupling::Patch* patch,
                                        const Eigen::VectorXd& committed, const coupling::ZoneSnapshot& zone) override;
    coupling::ZoneState zone_state() override { return fine_->state(); }
    coupling::ZoneSnapshot zone_snapshot() override { return fine_->snapshot(); }
    void keep_zone() override { fine_->keep(); }
    coupling::ZoneSnapshot kept_zone() override { return fine_->kept(); }

private:
    coupling::FineScale* fine_;
    EquilibriumSections input_;
};

}  // namespace stria::coarse
