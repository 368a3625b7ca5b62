#include "coarse/fracture/nominal_solution.hpp"

namespace stria::coarse {

namespace {

Eigen::VectorXd near_displacement(const Structure& body, const LoadFactors& factors, double initial) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(body.scene().enriched.unknowns);
    body.expand_near({}, factors, initial, u);
    return u;
}

/// What each load case does alone.
void add_cases(const Structure& body, const StructureRings& rings, std::vector<TipResult>& tips) {
    if (tips.empty()) return;
    for (Eigen::Index k = 0; k < std::ssize(body.loads().cases()); ++k) {
        const Eigen::VectorXd alone = near_displacement(body, LoadFactors::of_one_case(k), 0.0);
        const std::vector<TipResult> of_case =
            fracture_parameters(rings, alone, rings.integrals_of_displacement(alone), {});
        for (std::size_t t = 0; t < tips.size(); ++t) {
            tips[t].K_I_of_cases.push_back(of_case[t].K_I);
            tips[t].K_II_of_cases.push_back(of_case[t].K_II);
        }
    }
}

std::vector<TipResult> tips_of(const Structure& body, const Eigen::VectorXd& unit) {
    const StructureRings rings(body, Asked::Once);
    std::vector<TipResult> tips = fracture_parameters(rings, unit, rings.integrals_of_displacement(unit), {});
    add_cases(body, rings, tips);
    if (!body.scene().initial_stress().any()) return tips;
    const Eigen::VectorXd alone = near_displacement(body, 0.0, 1.0);
    const std::vector<TipResult> initial = fracture_parameters(rings, alone, rings.integrals(alone), {});
    for (std::size_t t = 0; t < tips.size(); ++t) tips[t].K_initial = initial[t].K_I;
    return tips;
}

}  // namespace

NominalSolution solve_nominal(std::unique_ptr<Structure> body) {
    Eigen::VectorXd u = body->expand({}, 1.0);
    std::vector<TipResult> tips = tips_of(*body, u);
    return {std::move(body), std::move(u), std::move(tips)};
}

NominalSolution solve_nominal_near(std::unique_ptr<Structure> body) {
    Eigen::VectorXd u = near_displacement(*body, 1.0, 0.0);
    std::vector<TipResult> tips = tips_of(*body, u);
    return {std::move(body), std::move(u), std::move(tips)};
}

NominalSolution solve_nominal(const Scene& scene) { return solve_nominal(std::make_unique<Structure>(scene)); }

std::vector<double> stress_intensities(const std::vector<TipResult>& tips) {
    std::vector<double> K_I;
    for (const TipResult& tip : tips) K_I.push_back(tip.K_I);
    return K_I;
}

UnitResponse unit_response(const NominalSolution& nominal) {
    std::vector<double> K_initial;
    std::vector<std::vector<double>> K_of_cases;
    for (const TipResult& tip : nominal.tips) {
        K_initial.push_back(tip.K_initial);
        K_of_cases.push_back(tip.K_I_of_cases);
    }
    return {.K_I = stress_intensities(nominal.tips),
            .K_initial = std::move(K_initial),
            .K_of_cases = std::move(K_of_cases),
            .mean_displacement = nominal.structure->loads().mean_displacement().per_load_factor,
            .largest_displacement = nominal.displacement.lpNorm<Eigen::Infinity>()};
}

}  // namespace stria::coarse
