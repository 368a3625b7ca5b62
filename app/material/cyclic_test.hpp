// A material point through the cycles of [material_test]: what happens at each increment, and what each cycle sums to.
#pragma once

#include <span>
#include <vector>

#include "common/case/case.hpp"

namespace stria::material {

/// Strain and stress along the load, in shear the angle gamma and tau; energies per volume, N/mm2, total so far.
struct TestRow {
    int increment, cycle;
    double strain, stress;  // MPa
    double plastic_strain;
    double back_stress, yield_stress;  // MPa; that by which the loop is off its middle, and sigma_y + R
    double accumulated;                // equivalent plastic strain
    double work, stored, dissipation;
    bool ends_cycle;  // or the ramp to the first maximum
};

/// From a maximum to the next one.
struct CycleSummary {
    int cycle;
    double strain_max, strain_min, stress_max, stress_min;
    double plastic_range;
    double ratchet;              // plastic strain at the end less that at the beginning
    double dissipation, stored;  // N/mm2, change in the cycle

    [[nodiscard]] double stress_range() const { return stress_max - stress_min; }
    [[nodiscard]] double mean_stress() const { return 0.5 * (stress_max + stress_min); }
};

/// Throws CaseError without a yield stress or a [material_test], NumericalFailure where the metal cannot bear the
/// stresses.
std::vector<TestRow> go_through_cycles(const Case& input);

std::vector<CycleSummary> summaries(std::span<const TestRow> rows);

}  // namespace stria::material
