#include "coarse/specimen/initial_field.hpp"

#include <cmath>
#include <fmt/format.h>
#include <string>

#include "common/error.hpp"

namespace stria::coarse {
namespace {

struct Extent {
    double low, high;  // mm
};

Extent extent_of(const Mesh& mesh, int axis) {
    Extent extent{1e300, -1e300};
    for (const Vec2& node : mesh.nodes) {
        extent.low = std::min(extent.low, node[axis]);
        extent.high = std::max(extent.high, node[axis]);
    }
    return extent;
}

void require_cover(const std::string& key, const std::vector<double>& places, const Extent& body) {
    const double rounding = 1e-9 * (body.high - body.low);
    if (places.front() > body.low + rounding || places.back() < body.high - rounding)
        throw CaseError(fmt::format("initial_stress.{}: goes from {:g} to {:g} mm, must cover the body from {:g} to "
                                    "{:g} mm",
                                    key, places.front(), places.back(), body.low, body.high));
}

/// Of a profile over the body, by strips.
struct Resultants {
    double force = 0.0, moment = 0.0;             // N/mm, N, about the middle
    double amount = 0.0, amount_of_moment = 0.0;  // of their absolute values
};

Resultants resultants_of(const StressProfile& profile, const Extent& body) {
    constexpr int strips = 64;  // between two places
    const double middle = 0.5 * (body.low + body.high);
    Resultants sum;
    for (std::size_t k = 0; k + 1 < profile.at.size(); ++k) {
        const double from = std::max(profile.at[k], body.low), to = std::min(profile.at[k + 1], body.high);
        const double slope = (profile.stress[k + 1] - profile.stress[k]) / (profile.at[k + 1] - profile.at[k]);
        for (int i = 0; i < strips && from < to; ++i) {
            const double width = (to - from) / strips, x = from + (i + 0.5) * width;
            const double force = width * (profile.stress[k] + slope * (x - profile.at[k]));
            sum.force += force;
            sum.moment += force * (x - middle);
            sum.amount += std::abs(force);
            sum.amount_of_moment += std::abs(force * (x - middle));
        }
    }
    return sum;
}

void check_profile(const char* key, const StressProfile& profile, const Extent& body) {
    constexpr double most = 0.02;
    require_cover(std::string(key) + ".at", profile.at, body);
    const auto [force, moment, amount, amount_of_moment] = resultants_of(profile, body);
    if (std::abs(force) > most * amount || std::abs(moment) > most * amount_of_moment)
        throw CaseError(fmt::format("initial_stress.{}: has a resultant of {:.4g} N/mm and a moment of {:.4g} N across "
                                    "the body: a stress without load has none",
                                    key, force, moment));
}

}  // namespace

void check_initial_stress(const InitialStressSection& given, const Mesh& mesh) {
    const Extent x = extent_of(mesh, 0), y = extent_of(mesh, 1);
    if (given.sigma_x) check_profile("sigma_x", *given.sigma_x, y);
    if (given.sigma_y) check_profile("sigma_y", *given.sigma_y, x);
    if (!given.grid) return;
    require_cover("grid.x", given.grid->x, x);
    require_cover("grid.y", given.grid->y, y);
}

}  // namespace stria::coarse
