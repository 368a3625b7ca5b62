#include "coarse/cycle/compliance_offset.hpp"

#include <cmath>
#include <cstddef>

namespace stria::coarse {
namespace {

/// Opening at a force on the way down, linear between increments.
double interpolated(const MouthPath& down, double at) {
    const auto& [load_factor, force, opening] = down;
    for (std::size_t k = 1; k < force.size(); ++k) {
        if (force[k] > at) continue;
        const double way = (force[k - 1] - at) / (force[k - 1] - force[k]);
        return opening[k - 1] + way * (opening[k] - opening[k - 1]);
    }
    return opening.back();
}

}  // namespace

std::optional<double> compliance_offset_opening(const MouthPath& down, const MouthPath& up, double offset) {
    if (down.force.size() < 2 || up.force.size() < 2) return std::nullopt;
    const double top = down.force.front(), upper = top - 0.25 * (top - down.force.back());
    const double of_open = (down.opening.front() - interpolated(down, upper)) / (top - upper);
    constexpr double least_opening = 1e-10;        // mm: less is rounding of faces that stay closed
    if (std::isnan(of_open)) return std::nullopt;  // no mouth
    if (down.opening.front() - down.opening.back() < least_opening) return NAN;
    if (of_open <= 0.0) return std::nullopt;
    const double longest = 0.1 * (up.force.back() - up.force.front()) * (1.0 + 1e-9);  // E647's segments
    double above = NAN, offset_above = 0.0;  // the middle of the segment above, and its offset
    for (std::size_t k = up.force.size() - 1; k > 0; --k) {
        const double segment = up.force[k] - up.force[k - 1];
        if (!(segment > 0.0 && segment <= longest)) return std::nullopt;
        const double here = 1.0 - (up.opening[k] - up.opening[k - 1]) / segment / of_open;
        const double middle = 0.5 * (up.load_factor[k] + up.load_factor[k - 1]);
        if (here >= offset) {
            if (std::isnan(above)) return NAN;  // stiffer than the open crack up to the maximum
            return middle + (above - middle) * (here - offset) / (here - offset_above);
        }
        above = middle;
        offset_above = here;
    }
    return up.load_factor.front();
}

std::optional<double> opened_by_offset(MouthPath down, MouthPath up) {
    const bool against = !up.load_factor.empty() && up.load_factor.back() < up.load_factor.front();
    const double sense = against ? -1.0 : 1.0;
    for (MouthPath* path : {&down, &up})
        for (std::vector<double>* loads : {&path->load_factor, &path->force})
            for (double& load : *loads) load *= sense;
    const std::optional<double> opened = compliance_offset_opening(down, up);
    return opened ? std::optional(sense * *opened) : std::nullopt;
}

}  // namespace stria::coarse
