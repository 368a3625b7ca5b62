#include "coarse/analysis/growth/crack_advance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "common/index.hpp"

namespace stria::coarse {

namespace {

constexpr double no_field = 1e-6;  // of the K of a unit load: faces that touch without a load leave rounding

double size_of(const TipResult& tip) { return std::hypot(tip.K_I, tip.K_II); }

}  // namespace

double hoop_stress_angle(double K_I, double K_II) {
    if (std::abs(K_II) <= 0.005 * std::abs(K_I)) return 0.0;  // no field at all has no direction either
    const double ratio = K_I / K_II;
    return 2.0 * std::atan(0.25 * (ratio - std::copysign(std::sqrt(ratio * ratio + 8.0), K_II)));
}

void advance(CrackSection& crack, const Tip& tip, const Vec2& direction, double increment) {
    const bool at_end = tip.upper > 0;
    const Vec2 next = tip.position + increment * direction;
    const bool straight = std::abs(tip.direction.x() * direction.y() - tip.direction.y() * direction.x()) < 1e-12;
    if (!straight)
        crack.points.insert(at_end ? crack.points.end() : crack.points.begin(), next);
    else
        (at_end ? crack.points.back() : crack.points.front()) = next;
}

std::vector<TipResult> directing(const std::vector<CrackSection>& cracks, const std::vector<Tip>& tips,
                                 std::vector<TipResult> nominal, const std::vector<TipResult>& reached) {
    for (std::size_t t = 0; t < nominal.size(); ++t) {
        const std::optional<ContactSection>& contact = cracks[at(tips[t].crack)].contact;
        const bool touches = reached[t].contact_length > 0.0 && size_of(reached[t]) > no_field * size_of(nominal[t]);
        if (!contact || contact->friction == 0.0 || !touches || reached[t].rings_flow) continue;
        nominal[t].K_I = std::max(reached[t].K_I, 0.0);  // closed faces leave the rounding of one
        nominal[t].K_II = reached[t].K_II;
    }
    return nominal;
}

std::vector<CrackSection> longer_cracks(std::vector<CrackSection> cracks, GrowthDirection direction,
                                        const std::vector<Tip>& tips, const std::vector<TipResult>& directing,
                                        const std::vector<double>& advance_by) {
    for (std::size_t t = 0; t < directing.size(); ++t) {
        if (advance_by[t] == 0.0) continue;
        const bool straight = direction == GrowthDirection::Straight;
        const double angle = straight ? 0.0 : hoop_stress_angle(directing[t].K_I, directing[t].K_II);
        advance(cracks[at(tips[t].crack)], tips[t], Eigen::Rotation2Dd(angle) * tips[t].direction, advance_by[t]);
    }
    return cracks;
}

}  // namespace stria::coarse
