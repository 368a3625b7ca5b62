// The opening load by the compliance offset method (ASTM E647, appendix on opening force).
#pragma once

#include <optional>
#include <span>
#include <vector>

namespace stria::coarse {

/// The load at which, on the way up from the minimum, the compliance dv/dP at the mouth last is less than 1 - `offset`
/// times that of the open crack. The open crack's compliance is that of the upper quarter of the way down.
/// `load_down`, `opening_down`: load factors and mouth openings, mm, at the increments from the maximum to the minimum;
/// `load_up`, `opening_up`: from there to the maximum. The minimum where the crack is open all the way, NaN where it
/// does not open up to the maximum. Nothing where that is not told: there is no mouth, or an increment from the
/// one below that load up to the maximum is longer than a tenth of the way up, which need not be as long as that down.
std::optional<double> compliance_offset_opening(std::span<const double> load_down, std::span<const double> opening_down,
                                                std::span<const double> load_up, std::span<const double> opening_up,
                                                double offset = 0.02);

/// The same; of a tip that opens as the load falls, in the other direction.
std::optional<double> opened_by_offset(std::vector<double> load_down, std::span<const double> opening_down,
                                       std::vector<double> load_up, std::span<const double> opening_up);

}  // namespace stria::coarse
