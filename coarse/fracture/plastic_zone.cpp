#include "coarse/fracture/plastic_zone.hpp"

#include <algorithm>
#include <numbers>

namespace stria::coarse {
namespace {

/// (K / sigma_y)^2, mm; zero under pressure.
double length_of_flow(double K_I, double yield_stress) {
    const double ratio = std::max(K_I, 0.0) / yield_stress;
    return ratio * ratio;
}

}  // namespace

double subdivision_radius(double beta, double K, double yield_stress) {
    return beta * (std::numbers::pi / 16.0) * (K * K) / (yield_stress * yield_stress);
}

std::vector<double> closure_distances(const ClosureSection& closure, const std::vector<double>& K,
                                      const std::vector<double>& yield_stress) {
    constexpr double share_of_radius = 0.1;
    std::vector<double> distances;
    for (std::size_t t = 0; t < K.size(); ++t)
        distances.push_back(
            closure.distance.value_or(share_of_radius * subdivision_radius(1.0, K[t], yield_stress[t])));
    return distances;
}

double forward_zone(double K_I, double yield_stress, PlaneState plane) {
    return (plane == PlaneState::Stress ? std::numbers::inv_pi : 0.157) * length_of_flow(K_I, yield_stress);
}

double forward_zone_ahead(double K_I, double yield_stress, PlaneState plane) {
    return (plane == PlaneState::Stress ? std::numbers::inv_pi : 0.04) * length_of_flow(K_I, yield_stress);
}

double elastic_zone_ahead(double K_I, double yield_stress, PlaneState plane) {
    const double away = forward_zone(K_I, yield_stress, plane);
    return plane == PlaneState::Strain ? 0.47 * away : away;
}

}  // namespace stria::coarse
