// Isotropic linear elasticity as a material law: the zone of a case without a yield stress. No history but the stress.
#pragma once

#include <limits>

#include "common/material/elasticity.hpp"
#include "fine/material/material_law.hpp"

namespace stria::fine {

class Elastic final : public MaterialLaw {
public:
    explicit Elastic(const Elasticity& elasticity) : elasticity_(elasticity), stiffness_(elasticity.stiffness()) {}

    [[nodiscard]] int state_size() const override { return state::plastic_strain; }
    void update(int points, int stride, const double* strain_increment, const double* committed, double* trial,
                double* tangent, unsigned char* yielding) const override;
    [[nodiscard]] double elastic_margin(int /*points*/, int /*stride*/, const double* /*states*/) const override {
        return std::numeric_limits<double>::infinity();
    }
    [[nodiscard]] double stored_energy(const double* state, int stride) const override {
        return elasticity_.energy(tensor_at(state, stride, state::stress));
    }
    [[nodiscard]] MandelMatrix elastic() const override { return stiffness_; }

private:
    Elasticity elasticity_;
    MandelMatrix stiffness_;
};

}  // namespace stria::fine
