// What contact says of the faces behind a tip: whether they touch, and whether the contact nearest to it slides.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "common/index.hpp"
#include "fine/contact/contact_interface.hpp"

namespace stria::fine {

double ContactInterface::contact_behind(const FacesBehind& part, const Eigen::VectorXd& traction, const Jumps& jumps,
                                        const Eigen::VectorXd& u) const {
    constexpr double least = std::numeric_limits<double>::min();  // the status decides the sign, not rounding
    double contact = -std::numeric_limits<double>::infinity();
    std::vector<std::pair<double, int>> open;  // gaps may be bounds: the most that -c g can be, and the multiplier
    for (const int k : multipliers_of(operators_, part)) {
        if (is_closed(status_[at(k)]))
            contact = std::max({contact, traction[k], least});
        else
            open.emplace_back(-augmentation_[k] * jumps.gap[k], k);
    }
    if (contact > 0.0 || open.empty()) return contact;
    std::swap(open.front(), *std::ranges::max_element(open));  // hardly another one needs to be read
    for (const auto& [most, k] : open)
        if (most > contact) contact = std::max(contact, std::min(-augmentation_[k] * operators_.gap(k, u), -least));
    return contact;
}

coupling::NearestContact ContactInterface::nearest_behind(const FacesBehind& part, const Eigen::VectorXd& traction,
                                                          const Jumps& jumps, double rounding) const {
    coupling::NearestContact nearest;
    for (const int k : multipliers_of(operators_, part)) {
        if (!is_closed(status_[at(k)]) || traction[k] <= augmentation_[k] * rounding) continue;
        const double behind = part.distance(operators_.middle(k)), slip = std::abs(jumps.slip[k]);
        const bool sliding = slides(k) && slip > rounding;
        ++nearest.closed;
        nearest.sliding += sliding ? 1 : 0;
        if (behind >= nearest.behind) continue;
        nearest.behind = behind;
        nearest.pressure = traction[k];
        const double bound = operators_.friction(k) * traction[k];
        if (shear_of(k) >= 0)
            nearest.excess = sliding ? augmentation_[k] * slip : std::min(std::abs(traction[shear_of(k)]) - bound, 0.0);
    }
    return nearest;
}

}  // namespace stria::fine
