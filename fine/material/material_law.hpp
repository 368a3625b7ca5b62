// Small-strain material laws on blocks of points: (strain increments, committed states) -> (trial states, tangents).
// The state of a point holds its stress: total strain is not recoverable once tip functions are frozen (docs/method.md,
// section 5).
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "common/mandel.hpp"
#include "common/material/materials.hpp"

namespace stria::fine {

/// Points are stored component by component: entry (component c, point q) at [c * stride + q].
/// Every law's state begins with the stress; one by which points may flow goes on with the others, all in Mandel form,
/// and further back stresses. What a law does not store is zero, but for the work.
namespace state {
inline constexpr int stress = 0;          // 4 components, MPa
inline constexpr int plastic_strain = 4;  // 4 components
inline constexpr int accumulated = 8;     // equivalent plastic strain p
inline constexpr int work = 9;            // stress work density, integral of sigma : d eps, N/mm2
inline constexpr int dissipation = 10;    // plastic dissipation density, integral of sigma_y dp, N/mm2
inline constexpr int back_stress = 11;    // 4 components for each back stress, MPa
}  // namespace state

/// A tensor of one point.
[[nodiscard]] inline Mandel tensor_at(const double* state, int stride, int component) {
    const double* first = state + static_cast<std::ptrdiff_t>(component) * stride;
    return {first[0], first[stride], first[2 * static_cast<std::ptrdiff_t>(stride)],
            first[3 * static_cast<std::ptrdiff_t>(stride)]};
}

class MaterialLaw {
public:
    virtual ~MaterialLaw() = default;

    /// Number of state components of a point.
    [[nodiscard]] virtual int state_size() const = 0;

    /// Whether a point may ever flow.
    [[nodiscard]] bool can_yield() const { return state_size() > state::plastic_strain; }

    /// Updates `points` points stored with `stride`: strain increments (4 components) and committed states in, trial
    /// states and consistent tangents (16 components, row-major 4 x 4 Mandel; none where nothing flows: it is
    /// elastic()) out; `yielding[q]` = plastic flow in this increment. Pure: same inputs, same bits. Throws
    /// NumericalFailure where the return mapping fails.
    virtual void update(int points, int stride, const double* strain_increment, const double* committed, double* trial,
                        double* tangent, unsigned char* yielding) const = 0;

    /// The smallest change of the von Mises stress that makes a point flow, MPa; below zero: one flows, as its state
    /// would be without. Infinite where nothing can. `states`: as update() has them.
    [[nodiscard]] virtual double elastic_margin(int points, int stride, const double* states) const = 0;

    /// Energy density that a point holds, N/mm2: elastic, and what hardening stores. `state`: its first component, the
    /// others `stride` apart.
    [[nodiscard]] virtual double stored_energy(const double* state, int stride) const = 0;

    /// Elastic stiffness in Mandel form (zz row and column zero in plane stress).
    [[nodiscard]] virtual MandelMatrix elastic() const = 0;

    /// Writes the state of a point that has been elastic up to a total strain, from an initial stress on, MPa; the rest
    /// of it is zero already. The work that made the initial stress counts as stress work.
    void begin(const Mandel& strain, const Mandel& initial, double* state, int stride) const {
        const Mandel change = elastic() * strain, stress = initial + change;
        for (int c = 0; c < 4; ++c) state[static_cast<std::ptrdiff_t>(c) * stride] = stress[c];
        if (!can_yield()) return;
        const bool virgin = initial.isZero(0.0);
        state[static_cast<std::ptrdiff_t>(state::work) * stride] =
            virgin ? 0.5 * change.dot(strain) : stored_energy(state, stride);
    }

    /// Stress work density, N/mm2: a function of the stress where nothing flows.
    [[nodiscard]] double work(const double* state, int stride) const {
        return can_yield() ? state[static_cast<std::ptrdiff_t>(state::work) * stride] : stored_energy(state, stride);
    }
};

/// The laws of a body, by material.
using MaterialLaws = std::vector<std::unique_ptr<MaterialLaw>>;

}  // namespace stria::fine
