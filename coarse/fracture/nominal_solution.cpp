#include "coarse/fracture/nominal_solution.hpp"

namespace stria::coarse {

NominalSolution solve_nominal(std::unique_ptr<Structure> body) {
    Eigen::VectorXd u = body->expand({}, 1.0);
    std::vector<TipResult> tips = fracture_parameters(*body, u, {});
    return {std::move(body), std::move(u), std::move(tips)};
}

NominalSolution solve_nominal_near(std::unique_ptr<Structure> body) {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(body->scene().enriched.unknowns);
    body->expand_near({}, 1.0, u);
    std::vector<TipResult> tips = fracture_parameters(*body, u, {});
    return {std::move(body), std::move(u), std::move(tips)};
}

NominalSolution solve_nominal(const Scene& scene) { return solve_nominal(std::make_unique<Structure>(scene)); }

std::vector<double> stress_intensities(const std::vector<TipResult>& tips) {
    std::vector<double> K_I;
    for (const TipResult& tip : tips) K_I.push_back(tip.K_I);
    return K_I;
}

UnitResponse unit_response(const NominalSolution& nominal) {
    return {.K_I = stress_intensities(nominal.tips),
            .mean_displacement = nominal.structure->loads().mean_displacement().per_load_factor,
            .largest_displacement = nominal.displacement.lpNorm<Eigen::Infinity>()};
}

}  // namespace stria::coarse
