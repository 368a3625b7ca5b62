// The largest nodal force of the loads: what residuals are small beside.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

class LargestForces {
public:
    /// `initial`: of the initial stress on all unknowns, N/mm; empty without one.
    LargestForces(const Scene& scene, const Eigen::VectorXd& initial)
        : main_(largest(scene.unit_force)), initial_(largest(initial)) {
        for (const Eigen::VectorXd& force : scene.case_forces) cases_.push_back(largest(force));
    }

    /// Of any unit load by itself, N/mm.
    [[nodiscard]] double under(const LoadFactors& factors) const {
        double force = std::max(std::abs(factors.main) * main_, initial_);
        for (std::size_t k = 0; k < cases_.size(); ++k)
            force = std::max(force, std::abs(factors.of_case(static_cast<Eigen::Index>(k))) * cases_[k]);
        return force;
    }

private:
    static double largest(const Eigen::VectorXd& v) { return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0.0; }

    double main_, initial_;
    std::vector<double> cases_;  // at factors 1
};

}  // namespace stria::coarse
