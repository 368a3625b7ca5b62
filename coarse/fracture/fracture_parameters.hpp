// Stress intensities, T stress, J and openings of every tip: the structure's share in them plus the zone's.
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "coarse/fracture/face_tractions.hpp"
#include "coarse/fracture/structure_rings.hpp"
#include "coarse/load/load_factors.hpp"
#include "coarse/structure/structure.hpp"
#include "coupling/messages.hpp"

namespace stria::coarse {

struct TipResult {
    double a = 0.0;                                // mm, docs/method.md, section 9
    double x = 0.0, y = 0.0;                       // of the tip, mm
    double way = 0.0;                              // along the crack to there, mm (way_to_tip)
    double K_I = 0.0, K_II = 0.0;                  // MPa sqrt(mm)
    double K_I_of_wake = 0.0, K_II_of_wake = 0.0;  // of these: of pressure on faces in metal that has flowed
    double T_stress = 0.0;                         // MPa
    double J = 0.0;                                // N/mm
    double J_spread = 0.0, K_spread = 0.0;         // over the rings; NaN where fewer than two tell
    bool rings_flow = false;                       // every ring holds a point that has flowed: K, T are no elastic ones
    double CTOD = 0.0, CMOD = 0.0;                 // mm
    double opening = std::numeric_limits<double>::quiet_NaN();  // mm, at a stated distance behind the tip
    double contact_length = 0.0;                                // mm
    double plastic_zone = 0.0, plastic_zone_axis = 0.0;         // mm
    double K_initial = 0.0, K_II_initial = 0.0;  // of a nominal solution: the initial stress alone, MPa sqrt(mm)
    std::vector<double> K_I_of_cases = {}, K_II_of_cases = {};  // likewise, of each load case at its factor 1
};

/// At their stated distances behind the tips, mm.
[[nodiscard]] std::vector<double> openings(const std::vector<TipResult>& tips);

/// K below this share of what each load has on its own is rounding, and so is a change of K: loads that cancel drive
/// nothing.
constexpr double rounding_of_K = 1e-9;

/// Nominal K of a tip of one mode, MPa sqrt(mm), under all loads and the initial stress. `of_main`, `of_cases`: at
/// factors of 1.
[[nodiscard]] inline double K_together(double of_main, const std::vector<double>& of_cases, double initial,
                                       const LoadFactors& loads) {
    const double main = of_main * loads.main;
    double beside = 0.0, alone = std::abs(main) + std::abs(initial);
    for (std::size_t k = 0; k < of_cases.size(); ++k) {
        const double K = loads.of_case(static_cast<Eigen::Index>(k)) * of_cases[k];
        beside += K;
        alone += std::abs(K);
    }
    const double sum = main + (beside + initial);
    return std::abs(sum) < rounding_of_K * alone ? 0.0 : sum;
}
[[nodiscard]] inline double K_I_under(const TipResult& nominal, const LoadFactors& loads) {
    return K_together(nominal.K_I, nominal.K_I_of_cases, nominal.K_initial, loads);
}
[[nodiscard]] inline double K_II_under(const TipResult& nominal, const LoadFactors& loads) {
    return K_together(nominal.K_II, nominal.K_II_of_cases, nominal.K_II_initial, loads);
}

/// What a change of the loads adds to the nominal K_I of a tip, of which the sign alone counts: above zero it opens the
/// tip, and zero if nothing drives it. Where K_I changes by less than a hundredth of what K_II does, as the mesh alone
/// may have it in shear, the sign is that of [load].
[[nodiscard]] inline double rise_of_K(const TipResult& nominal, const LoadFactors& change) {
    constexpr double least_of_K_II = 0.01;
    const double K_I = K_together(nominal.K_I, nominal.K_I_of_cases, 0.0, change);
    const double K_II = K_together(nominal.K_II, nominal.K_II_of_cases, 0.0, change);
    return std::abs(K_I) >= least_of_K_II * std::abs(K_II) ? K_I : change.main;
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
/// `on_faces`: that load it; null: none do.
std::vector<TipResult> nominal_K(const StructureRings& rings, const Eigen::VectorXd& u,
                                 const FaceTractions* on_faces = nullptr);

/// Openings of crack faces that the structure holds, joined with the zone's, ordered by crack and arc length.
std::vector<coupling::FaceSample> face_samples(const Structure& structure, const Eigen::VectorXd& u,
                                               const coupling::StepReport& report);

/// Where faces without contact overlap the most, beyond rounding and a thousandth of their largest jump; null: they do
/// not. The first of places that are alike, as those at the two tips of a crack in the middle of its plate.
const coupling::FaceSample* deepest_overlap(const std::vector<coupling::FaceSample>& faces,
                                            const std::vector<CrackSection>& cracks);

}  // namespace stria::coarse
