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

}  // namespace stria::coarse
