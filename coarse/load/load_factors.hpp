// How a body is loaded at a moment: one factor per unit load.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <utility>

namespace stria::coarse {

/// A body bears factor times load, summed over its unit loads. The loads of [load] have the main factor. Each load case
/// has one of its own, and a pressure that travels one for each of its positions.
struct LoadFactors {
    LoadFactors() = default;
    LoadFactors(double main_factor, Eigen::VectorXd of_cases = {}) : main(main_factor), cases(std::move(of_cases)) {}

    /// One for the k-th load case alone.
    static LoadFactors of_one_case(Eigen::Index k) { return {0.0, Eigen::VectorXd::Unit(k + 1, k)}; }

    double main = 0.0;      // lambda: an unknown where a displacement is controlled
    Eigen::VectorXd cases;  // given; those beyond its end are zero

    [[nodiscard]] double of_case(Eigen::Index k) const { return k < cases.size() ? cases[k] : 0.0; }
};

/// What factors of load cases change by from one moment to another; those beyond an end are zero.
[[nodiscard]] inline Eigen::VectorXd change(Eigen::VectorXd before, Eigen::VectorXd after) {
    const Eigen::Index count = std::max(before.size(), after.size());
    before.conservativeResizeLike(Eigen::VectorXd::Zero(count));
    after.conservativeResizeLike(Eigen::VectorXd::Zero(count));
    return after - before;
}

/// Likewise, factors at a part of the way from one moment to another.
[[nodiscard]] inline Eigen::VectorXd between(const Eigen::VectorXd& before, const Eigen::VectorXd& after, double way) {
    Eigen::VectorXd there = way * change(before, after);
    there.head(before.size()) += before;
    return there;
}

}  // namespace stria::coarse
