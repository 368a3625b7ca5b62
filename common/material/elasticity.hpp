// Isotropic linear elasticity, plane strain, in Mandel form.
#pragma once

#include "common/io/case.hpp"
#include "common/mandel.hpp"

namespace stria {

struct Elasticity {
    double young;  // MPa
    double poisson;

    [[nodiscard]] double shear_modulus() const { return young / (2.0 * (1.0 + poisson)); }
    [[nodiscard]] double bulk_modulus() const { return young / (3.0 * (1.0 - 2.0 * poisson)); }
    /// E' = E / (1 - nu^2): plane strain.
    [[nodiscard]] double plane_modulus() const { return young / (1.0 - poisson * poisson); }
    /// Kolosov's constant 3 - 4 nu: plane strain.
    [[nodiscard]] double kolosov() const { return 3.0 - 4.0 * poisson; }

    /// sigma = stiffness : eps with all of xx, yy, zz, sqrt(2) xy.
    [[nodiscard]] MandelMatrix stiffness() const {
        const MandelMatrix volumetric = mandel_identity * mandel_identity.transpose();
        return bulk_modulus() * volumetric + 2.0 * shear_modulus() * (MandelMatrix::Identity() - volumetric / 3.0);
    }
};

inline Elasticity elasticity_of(const MaterialSection& material) { return {material.young, material.poisson}; }

}  // namespace stria
