// The opening load by the compliance offset method (ASTM E647, appendix on opening force).
#pragma once

#include <optional>
#include <vector>

namespace stria::coarse {

/// What the mouth of a crack does on a half cycle, increment by increment.
struct MouthPath {
    std::vector<double> load_factor;
    std::vector<double> force;    // P of the compliance: any measure that is proportional to the force on the body
    std::vector<double> opening;  // mm

    void add(double load_factor_there, double force_there, double opening_there) {
        load_factor.push_back(load_factor_there);
        force.push_back(force_there);
        opening.push_back(opening_there);
    }
};

/// The load factor at which, on the way up from the minimum, the compliance dv/dP at the mouth last is less than
/// 1 - `offset` times that of the open crack. The open crack's compliance is that of the upper quarter of the way down.
/// `down`: from the maximum to the minimum; `up`: from there to the maximum. The minimum where the crack is open all
/// the way, NaN where it does not open up to the maximum. Nothing where that is not told: there is no mouth, or from
/// the increment below that load up to the maximum P falls in one, or grows by more than a tenth of the way up, which
/// need not be as long as that down.
std::optional<double> compliance_offset_opening(const MouthPath& down, const MouthPath& up, double offset = 0.02);

/// The same; of a tip that opens as the load falls, in the other direction.
std::optional<double> opened_by_offset(MouthPath down, MouthPath up);

}  // namespace stria::coarse
