// Isotropic linear elasticity of plane strain or plane stress, in Mandel form.
#pragma once

#include <algorithm>

#include "common/case/case.hpp"
#include "common/mandel.hpp"

namespace stria {

struct Elasticity {
    double young;  // MPa
    double poisson;
    PlaneState plane = PlaneState::Strain;

    bool operator==(const Elasticity&) const = default;

    [[nodiscard]] double shear_modulus() const { return young / (2.0 * (1.0 + poisson)); }
    [[nodiscard]] double bulk_modulus() const { return young / (3.0 * (1.0 - 2.0 * poisson)); }
    /// E': E / (1 - nu^2) in plane strain, E in plane stress.
    [[nodiscard]] double plane_modulus() const {
        return plane == PlaneState::Strain ? young / (1.0 - poisson * poisson) : young;
    }
    /// Kolosov's constant: 3 - 4 nu in plane strain, (3 - nu) / (1 + nu) in plane stress.
    [[nodiscard]] double kolosov() const {
        return plane == PlaneState::Strain ? 3.0 - 4.0 * poisson : (3.0 - poisson) / (1.0 + poisson);
    }

    /// Strain in the plane, of one in it: xx, yy, 0, sqrt(2) xy.
    [[nodiscard]] Mandel strain_in_plane(const Mandel& stress) const {
        const double all_round = 0.25 * (3.0 - kolosov()) * (stress[0] + stress[1]);
        return Mandel(stress[0] - all_round, stress[1] - all_round, 0.0, stress[3]) / (2.0 * shear_modulus());
    }

    /// Largest von Mises stress of a strain of unit size.
    [[nodiscard]] double largest_von_mises() const {
        const double hydrostatic = plane == PlaneState::Stress ? (1.0 + poisson) / (1.0 - poisson) : 0.0;
        return std::numbers::sqrt2 * shear_modulus() * std::max(std::numbers::sqrt3, hydrostatic);
    }

    /// Work density of a stress on the strain that another one makes, N/mm2: one : compliance : other.
    [[nodiscard]] double work(const Mandel& one, const Mandel& other) const {
        return ((1.0 + poisson) * one.dot(other) - poisson * mandel_identity.dot(one) * mandel_identity.dot(other)) /
               young;
    }

    /// Elastic energy density, N/mm2: (1/2) stress : compliance : stress.
    [[nodiscard]] double energy(const Mandel& stress) const {
        const double trace = mandel_identity.dot(stress);
        return ((1.0 + poisson) * stress.squaredNorm() - poisson * trace * trace) / (2.0 * young);
    }

    /// sigma = stiffness : eps with all of xx, yy, zz, sqrt(2) xy. In plane stress the zz strain is no unknown: its row
    /// and column are zero.
    [[nodiscard]] MandelMatrix stiffness() const {
        if (plane == PlaneState::Stress) {
            const Mandel in_plane_identity{1.0, 1.0, 0.0, 0.0};
            const MandelMatrix mixed = in_plane_identity * in_plane_identity.transpose();
            MandelMatrix in_plane = MandelMatrix::Identity();
            in_plane(2, 2) = 0.0;
            return young / (1.0 - poisson * poisson) * (poisson * mixed + (1.0 - poisson) * in_plane);
        }
        const MandelMatrix volumetric = mandel_identity * mandel_identity.transpose();
        return bulk_modulus() * volumetric + 2.0 * shear_modulus() * (MandelMatrix::Identity() - volumetric / 3.0);
    }
};

inline Elasticity elasticity_of(const MaterialSection& material, PlaneState plane) {
    return {material.young, material.poisson, plane};
}

}  // namespace stria
