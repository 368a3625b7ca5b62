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
    double width;  // mm
};

Between between(const std::vector<double>& places, double x) {
    const auto above = std::upper_bound(places.begin() + 1, places.end() - 1, x);
    const std::size_t first = at(above - places.begin()) - 1;
    const double width = places[first + 1] - places[first];
    return {first, std::clamp((x - places[first]) / width, 0.0, 1.0), width};
}

/// A number and its derivatives along x and y.
using Jet = Eigen::Vector3d;

Jet profile_at(const StressProfile& profile, double x, int axis) {
    const auto [k, share, width] = between(profile.at, x);
    const double rise = profile.stress[k + 1] - profile.stress[k];
    Jet jet = Jet::Zero();
    jet[0] = profile.stress[k] + share * rise;
    jet[1 + axis] = rise / width;
    return jet;
}

Jet grid_at(const StressGrid& grid, const std::vector<double>& values, const Vec2& x) {
    const auto [i, s, width] = between(grid.x, x.x());
    const auto [j, t, height] = between(grid.y, x.y());
    const std::size_t row = grid.x.size(), k = j * row + i;
    const double a = values[k], b = values[k + 1], c = values[k + row], d = values[k + row + 1];
    return {(1.0 - t) * (a + s * (b - a)) + t * (c + s * (d - c)), ((1.0 - t) * (b - a) + t * (d - c)) / width,
            ((1.0 - s) * (c - a) + s * (d - b)) / height};
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
