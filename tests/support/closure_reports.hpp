// What Newton's method reports of faces, for tests of who reads closure from it.
#pragma once

#include <vector>

#include "coarse/cycle/closure_meter.hpp"

namespace stria::coarse {

inline Case loaded() {
    Case input;
    input.material.yield_stress = 300.0;
    return input;
}

inline Case rough() {
    Case input = loaded();
    input.closure.distance = 0.1;
    input.closure.profile = {0.4};
    input.cracks.resize(1);
    input.cracks[0].contact = ContactSection{0.3};
    return input;
}

inline NewtonReport with_nearest(std::vector<coupling::NearestContact> nearest) {
    NewtonReport report{.converged = true, .iterations = {{}}, .lost = {}, .failure = {}};
    report.iterations.back().residual.faces = {std::vector<double>(nearest.size(), 1.0)};
    report.iterations.back().residual.nearest = {std::move(nearest)};
    return report;
}

inline NewtonReport with_slip(const std::vector<int>& slides) {
    std::vector<coupling::NearestContact> nearest;
    for (const int one : slides) nearest.push_back({.behind = 0.5, .pressure = 1.0, .excess = one == 0 ? -1.0 : 1.0});
    return with_nearest(nearest);
}

inline std::vector<bool> closed(const std::vector<double>& signal) {
    std::vector<bool> closed;
    for (const double s : signal) closed.push_back(s > 0.0);
    return closed;
}

}  // namespace stria::coarse
