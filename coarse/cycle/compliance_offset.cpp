#include "coarse/cycle/compliance_offset.hpp"

#include <cmath>
#include <cstddef>

namespace stria::coarse {
namespace {

/// Opening at a load on the way down, linear between increments.
double interpolated(std::span<const double> load, std::span<const double> opening, double at) {
    for (std::size_t k = 1; k < load.size(); ++k) {
        if (load[k] > at) continue;
        const double way = (load[k - 1] - at) / (load[k - 1] - load[k]);
        return opening[k - 1] + way * (opening[k] - opening[k - 1]);
    }
    return opening.back();
}

}  // namespace

std::optional<double> compliance_offset_opening(std::span<const double> load_down, std::span<const double> opening_down,
                                                std::span<const double> load_up, std::span<const double> opening_up,
                                                double offset) {
    if (load_down.size() < 2 || load_up.size() < 2) return std::nullopt;
    const double range = load_down.front() - load_down.back();
    const double upper = load_down.front() - 0.25 * range;
    const double of_open =
        (opening_down.front() - interpolated(load_down, opening_down, upper)) / (load_down.front() - upper);
    constexpr double least_opening = 1e-10;        // mm: less is rounding of faces that stay closed
    if (std::isnan(of_open)) return std::nullopt;  // no mouth
    if (opening_down.front() - opening_down.back() < least_opening) return NAN;
    if (of_open <= 0.0) return std::nullopt;
    const double longest = 0.1 * (load_up.back() - load_up.front()) * (1.0 + 1e-9);  // E647's segments
    double above = NAN, offset_above = 0.0;  // the middle of the segment above, and its offset
    for (std::size_t k = load_up.size() - 1; k > 0; --k) {
        if (load_up[k] - load_up[k - 1] > longest) return std::nullopt;
        const double compliance = (opening_up[k] - opening_up[k - 1]) / (load_up[k] - load_up[k - 1]);
        const double middle = 0.5 * (load_up[k] + load_up[k - 1]), here = 1.0 - compliance / of_open;
        if (here >= offset) {
            if (std::isnan(above)) return NAN;  // stiffer than the open crack up to the maximum
            return middle + (above - middle) * (here - offset) / (here - offset_above);
        }
        above = middle;
        offset_above = here;
    }
    return load_up.front();
}

std::optional<double> opened_by_offset(std::vector<double> load_down, std::span<const double> opening_down,
                                       std::vector<double> load_up, std::span<const double> opening_up) {
    const bool against = !load_up.empty() && load_up.back() < load_up.front();
    const double sense = against ? -1.0 : 1.0;
    for (std::vector<double>* loads : {&load_down, &load_up})
        for (double& load : *loads) load *= sense;
    const std::optional<double> opened = compliance_offset_opening(load_down, opening_down, load_up, opening_up);
    return opened ? std::optional(sense * *opened) : std::nullopt;
}

}  // namespace stria::coarse
