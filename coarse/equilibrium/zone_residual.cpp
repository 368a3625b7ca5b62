#include "coarse/equilibrium/zone_residual.hpp"

#include <algorithm>
#include <numeric>

namespace stria::coarse {

void add_zone(Residual& residual, const coupling::PatchResponse& response) {
    const coupling::Digest& digest = response.digest;
    residual.interior = response.interior_residual;
    residual.contact = response.contact_residual;
    residual.scale = std::max(residual.scale, response.interior_force);
    residual.yielding_points = std::reduce(digest.yielding_points.begin(), digest.yielding_points.end());
    residual.closed = static_cast<int>(std::ranges::count_if(digest.status, [](auto status) { return status != 0; }));
    residual.status_changes = digest.status_changes;
    residual.faces = digest.contact;
    residual.opening = digest.opening;
    residual.force_ahead = digest.force_ahead;
    residual.nearest = digest.nearest;
    residual.along = response.along;
    residual.along_before = response.along_before;
    residual.provisional = response.provisional;
    residual.woken = response.woken;
    residual.keeps_factor = response.keeps_factor;
}

}  // namespace stria::coarse
