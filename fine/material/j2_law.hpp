// What every law of J2 plasticity has, whatever its return: parameters, state, energies and elastic stiffness.
#pragma once

#include "fine/material/j2_pack.hpp"
#include "fine/material/j2_parameters.hpp"

namespace stria::fine {

class J2Law : public MaterialLaw {
public:
    [[nodiscard]] int state_size() const override { return parameters_.state_size(); }
    void update(int points, int stride, const double* strain_increment, const double* committed, double* trial,
                double* tangent, unsigned char* yielding) const final {
        return_points({.law = parameters_,
                       .stiffness = elastic(),
                       .strain_increment = strain_increment,
                       .committed = committed,
                       .trial = trial,
                       .tangent = tangent,
                       .yielding = yielding},
                      points, stride);
    }
    [[nodiscard]] double elastic_margin(int points, int stride, const double* states) const override {
        return parameters_.elastic_margin(points, stride, states);
    }
    [[nodiscard]] double stored_energy(const double* state, int stride) const override {
        return parameters_.stored_energy(state, stride);
    }
    [[nodiscard]] MandelMatrix elastic() const override { return parameters_.elasticity.stiffness(); }

protected:
    explicit J2Law(const J2Parameters& parameters) : parameters_(parameters) {}

    /// The stress of every point, and its return to the yield surface where it flows (update_packs of j2_pack.hpp).
    virtual void return_points(const J2Update& update, int points, int stride) const = 0;

    [[nodiscard]] const J2Parameters& parameters() const { return parameters_; }

private:
    J2Parameters parameters_;
};

}  // namespace stria::fine
