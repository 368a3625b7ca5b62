// What an iterate of the zone tells: residuals and their scales, and the digest.
#include <algorithm>
#include <cmath>

#include "fine/bulk/bulk_report.hpp"
#include "fine/zone/zone_report.hpp"
#include "fine/zone/zone_system.hpp"

namespace stria::fine {

coupling::PatchResponse ZoneSystem::measure() {
    coupling::PatchResponse response;
    UnknownSet followed = at_rest_.inside();  // by the structure, or by the others
    for (const int unknown : patch_.boundary) followed.insert(unknown);
    response.interior_force = at_rest_.force_scale();
    const bool some_rest = at_rest_.response().size() > 0;
    Eigen::VectorXd scale = bulk_->force_scale();
    if (some_rest) scale += at_rest_.response().head(scale.size()).cwiseAbs();
    for (int i = 0; i < patch_.mesh.unknowns; ++i) {
        response.interior_force = std::max(response.interior_force, scale[i]);
        if (!followed.contains(i))
            response.interior_residual = std::max(response.interior_residual, std::abs(load_[i]));
    }
    response.contact_residual = contact_->residual(trial_.traction, jumps_);
    if (some_rest)
        response.contact_residual = std::max(
            response.contact_residual, contact_->residual_at_rest(at_rest_.response().tail(contact_->tractions())));
    response.interior_correction = largest_move_;
    response.interior_displacement = trial_.displacement.cwiseAbs().maxCoeff();
    response.digest.yielding_points = yielding_points(*bulk_);
    response.digest.largest_plastic_increment = largest_plastic_increment(*bulk_);
    for (std::size_t t = 0; t < patch_.ahead.size(); ++t)
        response.digest.force_ahead.push_back(force_ahead(*bulk_, patch_.mesh.tips[t], patch_.ahead[t]));
    measure_faces(response.digest);
    return response;
}

void ZoneSystem::measure_faces(coupling::Digest& digest) const {
    put_faces({.patch = patch_,
               .contact = *contact_,
               .frozen = memory_.frozen,
               .displacement = trial_.displacement,
               .traction = trial_.traction,
               .jumps = jumps_,
               .smallest_slip = smallest_slip()},
              digest);
}

double ZoneSystem::smallest_slip() const {
    constexpr double rounding = 1e-8;  // of a displacement
    return rounding * std::max(trial_.displacement.lpNorm<Eigen::Infinity>(),
                               memory_.committed.displacement.lpNorm<Eigen::Infinity>());
}

}  // namespace stria::fine
