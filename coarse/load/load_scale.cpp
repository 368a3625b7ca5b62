#include "coarse/load/load_scale.hpp"

#include <algorithm>
#include <cmath>

#include "coarse/load/load_history.hpp"
#include "coarse/load/rate_law.hpp"
#include "common/case/loads/load_increments.hpp"
#include "common/error.hpp"

namespace stria::coarse {
namespace {

// Beside a K_II that slides what is left of K_I opens nothing, nor does it press: of a crack that is sheared, on a mesh
// that is not quite symmetric.
constexpr double negligible = 0.01;

/// Of one tip, MPa sqrt(mm).
struct Modes {
    double K_I, K_II;
    std::optional<double> friction;  // none: faces never touch

    [[nodiscard]] bool is_pressed() const { return friction && K_I < 0.0; }
    [[nodiscard]] double sliding() const {
        return is_pressed() ? std::max(std::abs(K_II) + *friction * K_I, 0.0) : std::abs(K_II);
    }
    [[nodiscard]] double equivalent() const {
        return std::sqrt(std::pow(std::max(K_I, 0.0), 2) + 3.0 * sliding() * sliding());
    }
};

std::optional<double> friction_of(const UnitResponse& nominal, std::size_t t) {
    return t < nominal.friction.size() ? nominal.friction[t] : std::nullopt;
}

/// Without positions of a pressure that travels where the faces would overlap.
std::vector<double> K_II_of_cases(const UnitResponse& nominal, std::size_t t, const CaseHistories& cases) {
    std::vector<double> K_II = nominal.K_II_of_cases[t];
    for (std::size_t k = cases.load_cases(); friction_of(nominal, t) && k < K_II.size(); ++k)
        if (nominal.K_I_of_cases[t][k] < 0.0) K_II[k] = 0.0;
    return K_II;
}

double value_at(const std::vector<double>& values, std::size_t t) { return t < values.size() ? values[t] : 0.0; }

double largest_of_cases(const CaseHistories& cases, std::vector<double> K, double sign, double scale) {
    for (double& of_case : K) of_case *= sign;
    return cases.largest_sum(K, scale);
}

/// With K of load cases while the boundary is held: where one of them changes the load factor does, too. Dead ones do
/// not change.
UnitResponse while_held(const LoadSection& load, UnitResponse nominal, const CaseHistories& cases) {
    if (load.control != Control::Displacement) return nominal;
    const UnitDisplacement& moved = nominal.displacement;
    const auto give_way = [&](std::vector<std::vector<double>>& of_cases, const std::vector<double>& of_load) {
        for (std::size_t t = 0; t < of_cases.size(); ++t)
            for (std::size_t k = 0; k < std::min(of_cases[t].size(), moved.of_cases.size()); ++k)
                if (!cases.is_dead(k)) of_cases[t][k] -= value_at(of_load, t) * moved.of_cases[k] / moved.mean;
    };
    give_way(nominal.K_I_of_cases, nominal.K_I);
    give_way(nominal.K_II_of_cases, nominal.K_II);
    return nominal;
}

/// Of each tip at the two extremes of the history, with load cases at their largest.
struct Extremes {
    Modes at_largest, at_smallest;
    double least_K_I;  // with load cases at their least

    [[nodiscard]] double largest() const { return std::max(at_largest.equivalent(), at_smallest.equivalent()); }
    [[nodiscard]] bool presses_rough_faces() const {
        return at_largest.friction.value_or(0.0) > 0.0 && least_K_I < -negligible * largest();
    }
};
std::vector<Extremes> extremes(const Case& input, const UnitResponse& free, double grown) {
    const CaseHistories cases(input);
    const double scale = target_of_unit(input.load, free.K_I, grown);
    const auto [largest, smallest] = range_of_load(input, free, grown);
    const UnitResponse nominal = while_held(input.load, free, cases);
    std::vector<Extremes> all;
    for (std::size_t t = 0; t < nominal.K_I.size(); ++t) {
        double added_I = value_at(nominal.K_initial, t), least_added_I = added_I, added_II = 0.0;
        if (cases.count() > 0) {
            const std::vector<double> K_II = K_II_of_cases(nominal, t, cases);
            added_I += largest_of_cases(cases, nominal.K_I_of_cases[t], 1.0, scale);
            least_added_I -= largest_of_cases(cases, nominal.K_I_of_cases[t], -1.0, scale);
            added_II = std::max(largest_of_cases(cases, K_II, 1.0, scale), largest_of_cases(cases, K_II, -1.0, scale));
        }
        const auto at = [&](double factor) -> Modes {
            const double sliding = value_at(nominal.K_II, t) * factor + value_at(nominal.K_II_initial, t);
            return {nominal.K_I[t] * factor + added_I, std::abs(sliding) + added_II, friction_of(nominal, t)};
        };
        const double least = std::min(nominal.K_I[t] * largest, nominal.K_I[t] * smallest) + least_added_I;
        all.push_back({at(largest), at(smallest), least});
    }
    return all;
}

bool presses_rough_faces(const Case& input, const UnitResponse& nominal) {
    return std::ranges::any_of(extremes(input, nominal, 0.0), &Extremes::presses_rough_faces);
}

}  // namespace

double target_of_unit(const LoadSection& load, const std::vector<double>& K_I, double grown) {
    if (load.control != Control::StressIntensity) return 1.0;
    if (K_I.empty() || !(K_I.front() > 0.0))
        throw CaseError("load.control: \"K\" needs a crack tip with K_I > 0 under the unit load");
    return std::exp(load.K_gradient * grown) / K_I.front();
}

LoadRange range_of_load(const Case& input, const UnitResponse& nominal, double grown) {
    const LoadSection& load = input.load;
    if (load.control != Control::Displacement) {
        const double unit = target_of_unit(load, nominal.K_I, grown);
        return {unit * largest_value(load), unit * smallest_value(load)};
    }
    if (std::abs(nominal.displacement.mean) <= 1e-9 * nominal.displacement.largest)
        throw CaseError("load.control: the loads do not move the loaded boundary along their direction, or have none");
    const CaseHistories cases(input);
    const Eigen::VectorXd dead = cases.dead();
    LoadRange range{0.0, 0.0};
    const auto take = [&](double displacement) {
        const double factor = nominal.displacement.load_factor_at(displacement, dead);
        range = {std::max(range.largest, factor), std::min(range.smallest, factor)};
    };
    take(nominal.displacement.beside(cases.at_start()));
    for (const LoadBlock& block : load.blocks)
        for (const double value : {block.max, block.min}) take(load.scale * value);
    return range;
}

std::vector<double> largest_K(const Case& input, const UnitResponse& nominal, double grown) {
    std::vector<double> K;
    for (const Extremes& tip : extremes(input, nominal, grown)) K.push_back(tip.largest());
    return K;
}

LoadSection graded_load(const Case& input, const UnitResponse& nominal) {
    LoadSection load = input.load;
    const bool curved = std::ranges::any_of(input.load_cases, lags);  // then increments go by the angle
    if (!load.grading && !curved && presses_rough_faces(input, nominal)) load.grading = 1.0;
    return load;
}

namespace {

/// The value of the history at which [load] is none.
double without_load(const Case& input, const UnitResponse& nominal) {
    const bool is_moved = input.load.control == Control::Displacement;
    return is_moved ? nominal.displacement.beside(CaseHistories(input).dead()) : 0.0;
}

}  // namespace

std::vector<double> largest_K_I(const Case& input, const UnitResponse& nominal, double grown) {
    UnitResponse opening = nominal;
    opening.K_II.clear();
    opening.K_II_initial.clear();
    for (std::vector<double>& of_tip : opening.K_II_of_cases) std::ranges::fill(of_tip, 0.0);
    const std::vector<double> any = largest_K(input, nominal, grown);
    std::vector<double> K_I = largest_K(input, opening, grown);
    for (std::size_t t = 0; t < any.size(); ++t)
        if (K_I[t] <= negligible * any[t]) K_I[t] = 0.0;
    return K_I;
}

std::vector<double> least_K_I(const Case& input, const UnitResponse& nominal) {
    std::vector<double> K;
    for (const Extremes& tip : extremes(input, nominal, 0.0))
        K.push_back(tip.least_K_I < -negligible * tip.largest() ? tip.least_K_I : 0.0);
    return K;
}

std::vector<double> common_K_I(const Case& input, const UnitResponse& nominal, double grown, int passed) {
    if (!input.growth) return largest_K_I(input, nominal, grown);
    LoadSection ahead = cycles_ahead(input.load, passed);
    const double start = without_load(input, nominal);
    for (LoadBlock& block : ahead.blocks)
        for (double* value : {&block.max, &block.min}) *value -= start / ahead.scale;
    const double most = (median_maximum(ahead, exponent_of_K(*input.growth)) + start) / ahead.scale;
    Case common = input;
    common.load.blocks = {{.max = most, .min = most}};
    return largest_K_I(common, nominal, grown);
}

}  // namespace stria::coarse
