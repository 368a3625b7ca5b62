// Stress intensities, T stress, J and openings of every tip: the structure's share in them plus the zone's.
#pragma once

#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "coarse/fracture/structure_rings.hpp"
#include "coarse/load/load_factors.hpp"
#include "coarse/structure/structure.hpp"
#include "coupling/messages.hpp"

namespace stria::coarse {

struct TipResult {
    double a = 0.0;                         // mm, docs/method.md, section 9
    double x = 0.0, y = 0.0;                // of the tip, mm
    double K_I = 0.0, K_II = 0.0;           // MPa sqrt(mm)
    double T_stress = 0.0;                  // MPa
    double J = 0.0;                         // N/mm
    double J_spread = 0.0, K_spread = 0.0;  // over the rings; NaN where fewer than two tell
    bool rings_flow = false;                // every ring holds a point that has flowed: K, T are no elastic ones
    double CTOD = 0.0, CMOD = 0.0;          // mm
    double opening = std::numeric_limits<double>::quiet_NaN();  // mm, at a stated distance behind the tip
    double contact_length = 0.0;                                // mm
    double plastic_zone = 0.0, plastic_zone_axis = 0.0;         // mm
    double K_initial = 0.0, K_II_initial = 0.0;  // of a nominal solution: the initial stress alone, MPa sqrt(mm)
    std::vector<double> K_I_of_cases = {}, K_II_of_cases = {};  // likewise, of each load case at its factor 1
};

/// At their stated distances behind the tips, mm.
[[nodiscard]] std::vector<double> openings(const std::vector<TipResult>& tips);

/// What load cases add to a K: their factors times those of `of_unit`, one per load case.
[[nodiscard]] inline double sum_over_cases(const std::vector<double>& of_unit, const Eigen::VectorXd& factors) {
    double sum = 0.0;
    for (std::size_t k = 0; k < of_unit.size() && std::cmp_less(k, factors.size()); ++k)
        sum += factors[static_cast<Eigen::Index>(k)] * of_unit[k];
    return sum;
}

/// Nominal K of a tip that load cases and the initial stress have, and with the load of [load]. One of each mode;
/// MPa sqrt(mm).
[[nodiscard]] inline double K_I_beside(const TipResult& nominal, const Eigen::VectorXd& cases) {
    return sum_over_cases(nominal.K_I_of_cases, cases) + nominal.K_initial;
}
[[nodiscard]] inline double K_I_under(const TipResult& nominal, const LoadFactors& loads) {
    return nominal.K_I * loads.main + K_I_beside(nominal, loads.cases);
}
[[nodiscard]] inline double K_II_under(const TipResult& nominal, const LoadFactors& loads) {
    return nominal.K_II * loads.main + sum_over_cases(nominal.K_II_of_cases, loads.cases) + nominal.K_II_initial;
}

/// `u`: displacement of the whole mesh, mm, zero inside the zone; that of near elements is read. `own`:
/// rings.integrals(u). `report`: the zone's share, empty without a zone. `behind`: distances behind the tips, mm, at
/// which the opening is asked for, one per tip; empty: nobody asks. One result per tip.
std::vector<TipResult> fracture_parameters(const StructureRings& rings, const Eigen::VectorXd& u,
                                           const RingIntegrals& own, const coupling::StepReport& report,
                                           std::span<const double> behind = {});

/// The same, with rings made for this once.
std::vector<TipResult> fracture_parameters(const Structure& structure, const Eigen::VectorXd& u,
                                           const coupling::StepReport& report);

/// K and T alone, of a solution in which no element is in a zone and without an initial stress. J and openings are NaN.
std::vector<TipResult> nominal_K(const StructureRings& rings, const Eigen::VectorXd& u);

/// Openings of crack faces that the structure holds, joined with the zone's, ordered by crack and arc length.
std::vector<coupling::FaceSample> face_samples(const Structure& structure, const Eigen::VectorXd& u,
                                               const coupling::StepReport& report);

/// Where faces without contact overlap the most, beyond rounding and a thousandth of their largest jump; null: they do
/// not.
const coupling::FaceSample* deepest_overlap(const std::vector<coupling::FaceSample>& faces,
                                            const std::vector<CrackSection>& cracks);

}  // namespace stria::coarse
