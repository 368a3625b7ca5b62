#include "common/material/initial_stress.hpp"

#include <algorithm>
#include <numbers>

#include "common/case/case_questions.hpp"
#include "common/index.hpp"

namespace stria {
namespace {

/// Where a coordinate lies between ascending places: the first of two, and the share of the way to the second.
struct Between {
    std::size_t first;
    double share;
};

std::size_t last_before(const std::vector<double>& places, double x) {
    return at(std::upper_bound(places.begin() + 1, places.end() - 1, x) - places.begin()) - 1;
}

Between between(const std::vector<double>& places, double x) {
    const std::size_t first = last_before(places, x);
    return {first, std::clamp((x - places[first]) / (places[first + 1] - places[first]), 0.0, 1.0)};
}

/// Of what `rise(k)` says is linear from each place to the next one. On a place it is the mean of both sides: rounding
/// puts a point of integration there, the middle one of an element, on one or the other.
template <class Rise> double slope_between(const std::vector<double>& places, double x, const Rise& rise) {
    const double rounding = 1e-9 * (places.back() - places.front());
    const auto slope = [&](double there) {
        const std::size_t k = last_before(places, there);
        return rise(k) / (places[k + 1] - places[k]);
    };
    return 0.5 * (slope(x - rounding) + slope(x + rounding));
}

/// A number and its derivatives along x and y.
using Jet = Eigen::Vector3d;

Jet profile_at(const StressProfile& profile, double x, int axis) {
    const auto rise = [&](std::size_t k) { return profile.stress[k + 1] - profile.stress[k]; };
    const auto [k, share] = between(profile.at, x);
    Jet jet = Jet::Zero();
    jet[0] = profile.stress[k] + share * rise(k);
    jet[1 + axis] = slope_between(profile.at, x, rise);
    return jet;
}

Jet grid_at(const StressGrid& grid, const std::vector<double>& values, const Vec2& x) {
    const auto [i, s] = between(grid.x, x.x());
    const auto [j, t] = between(grid.y, x.y());
    const auto value = [&](std::size_t column, std::size_t row) { return values[row * grid.x.size() + column]; };
    const auto along_row = [&](std::size_t column) { return (1.0 - t) * value(column, j) + t * value(column, j + 1); };
    const auto along_column = [&](std::size_t row) { return (1.0 - s) * value(i, row) + s * value(i + 1, row); };
    const auto rise_along_x = [&](std::size_t k) { return along_row(k + 1) - along_row(k); };
    const auto rise_along_y = [&](std::size_t k) { return along_column(k + 1) - along_column(k); };
    return {along_column(j) + t * rise_along_y(j), slope_between(grid.x, x.x(), rise_along_x),
            slope_between(grid.y, x.y(), rise_along_y)};
}

/// Rows xx, yy, xy.
Eigen::Matrix3d jets_at(const InitialStressSection& given, const Vec2& x) {
    Eigen::Matrix3d jets = Eigen::Matrix3d::Zero();
    if (given.sigma_x) jets.row(0) += profile_at(*given.sigma_x, x.y(), 1).transpose();
    if (given.sigma_y) jets.row(1) += profile_at(*given.sigma_y, x.x(), 0).transpose();
    if (!given.grid) return jets;
    jets.row(0) += grid_at(*given.grid, given.grid->xx, x).transpose();
    jets.row(1) += grid_at(*given.grid, given.grid->yy, x).transpose();
    jets.row(2) += grid_at(*given.grid, given.grid->xy, x).transpose();
    return jets;
}

}  // namespace

InitialStress::InitialStress(const Case& input)
    : any_(has_initial_stress(input)), given_(input.initial_stress.value_or(InitialStressSection())) {
    const auto add = [&](const MaterialSection& material, const MisfitStress& misfit) {
        misfit_.emplace_back(misfit.xx, misfit.yy, misfit.xy);
        across_.push_back(input.model.plane == PlaneState::Strain ? material.poisson : 0.0);
    };
    add(input.material, {});
    for (const RegionSection& region : input.regions)
        add(region.material, region.initial_stress.value_or(MisfitStress()));
}

bool InitialStress::is_alike_in(int one, int other) const {
    return !any_ || misfit_[stria::at(one)] == misfit_[stria::at(other)];
}

Mandel InitialStress::with_zz(const Eigen::Vector3d& in_plane, int material) const {
    const double xx = in_plane[0], yy = in_plane[1], xy = in_plane[2];
    return {xx, yy, across_[stria::at(material)] * (xx + yy), std::numbers::sqrt2 * xy};
}

Mandel InitialStress::at(const Vec2& x, int material) const {
    if (!any_) return Mandel::Zero();
    return with_zz(misfit_[stria::at(material)] + jets_at(given_, x).col(0), material);
}

Mandel InitialStress::slope(const Vec2& x, int material, const Vec2& direction) const {
    if (!any_) return Mandel::Zero();
    const Eigen::Matrix3d jets = jets_at(given_, x);
    return with_zz(direction.x() * jets.col(1) + direction.y() * jets.col(2), material);
}

}  // namespace stria
