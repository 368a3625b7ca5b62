// What the zone tells of its state: integrals, extents, and the state itself.
#include <algorithm>
#include <cmath>

#include "fine/bulk/zone.hpp"

#include "common/index.hpp"

namespace stria::fine {

std::vector<std::int32_t> Zone::yielding_points() const {
    std::vector<std::int32_t> count(operators_.size(), 0);
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        const auto begin = yielding_.begin() + first_point_[e];
        count[e] = static_cast<std::int32_t>(
            std::count_if(begin, begin + std::ssize(operators_[e].points), [](auto y) { return y != 0; }));
    }
    return count;
}

double Zone::largest_plastic_increment() const {
    double largest = 0.0;
    const auto offset = at(state::accumulated) * at(points_);
    for (std::size_t q = 0; q < at(points_); ++q) {
        if (yielding_[q] != 0) largest = std::max(largest, trial_[offset + q] - committed_[offset + q]);
    }
    return largest;
}

double Zone::dissipation() const {
    double sum = 0.0;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        for (std::size_t q = 0; q < operators_[e].points.size(); ++q) {
            sum +=
                operators_[e].points[q].weight * committed(state::dissipation, first_point_[e] + static_cast<int>(q));
        }
    }
    return sum;
}

double Zone::stored_energy() const {
    double sum = 0.0;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        const double* state = committed_.data() + first_point_[e];
        for (const IntegrationPoint& point : operators_[e].points)
            sum += point.weight * law_->stored_energy(state++, points_);
        if (rests(e)) sum += energy_since_rest(e);
    }
    return sum;
}

void Zone::add_to(RingSums& rings) const {
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        const ElementOperator& op = operators_[e];
        if (!rings.enter(static_cast<int>(e))) continue;
        const Eigen::VectorXd u = gather(committed_u_, op.unknowns), moved = moved_since_rest(e);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const auto [stress, work] = committed_state(e, q, moved);
            rings.add(op.points[q], stress, total_gradient(e, q, u), work);
        }
    }
}

double Zone::plastic_reach(const Tip& tip) const {
    double largest = 0.0;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        for (std::size_t q = 0; q < operators_[e].points.size(); ++q) {
            if (committed(state::accumulated, first_point_[e] + static_cast<int>(q)) > 0.0)
                largest = std::max(largest, (operators_[e].points[q].x - tip.position).norm());
        }
    }
    return largest;
}

double Zone::plastic_extent(const Tip& tip, double half_angle) const {
    double largest = 0.0;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        for (std::size_t q = 0; q < operators_[e].points.size(); ++q) {
            if (flowed_[at(first_point_[e]) + q] == 0) continue;
            const TipPolar polar = tip_polar(tip, operators_[e].points[q].x, 0);
            if (std::abs(polar.theta) <= half_angle) largest = std::max(largest, polar.r);
        }
    }
    return largest;
}

bool Zone::is_near(std::size_t element, const Vec2& place, double radius) const {
    const std::array<int, 4>& corners = mesh_.elements[element];
    const double diagonal = (mesh_.nodes[at(corners[0])] - mesh_.nodes[at(corners[2])]).norm();
    return (operators_[element].points.front().x - place).norm() <= radius + 2.0 * diagonal;
}

double Zone::force_ahead(const Tip& tip, double radius) const {
    const Vec2 normal(-tip.direction.y(), tip.direction.x());
    double sum = 0.0;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        const std::vector<IntegrationPoint>& points = operators_[e].points;
        if (!is_near(e, tip.position, radius)) continue;
        for (std::size_t q = 0; q < points.size(); ++q) {
            const IntegrationPoint& p = points[q];
            const Vec2 from_tip = p.x - tip.position;
            const double along = from_tip.dot(tip.direction);
            if (from_tip.norm() > radius || along < std::abs(from_tip.dot(normal))) continue;
            sum += p.weight * normal.dot(in_plane(trial_stress(e, q)) * normal);
        }
    }
    return sum;
}

void Zone::describe(coupling::ZoneState& out) const {
    out.displacement = committed_u_;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        const Eigen::VectorXd moved = moved_since_rest(e);
        for (std::size_t q = 0; q < operators_[e].points.size(); ++q) {
            const IntegrationPoint& p = operators_[e].points[q];
            const int point = first_point_[e] + static_cast<int>(q);
            out.element.push_back(static_cast<std::int32_t>(e));
            out.side.push_back(static_cast<std::int8_t>(p.side));
            out.x.push_back(p.x.x());
            out.y.push_back(p.x.y());
            out.weight.push_back(p.weight);
            const Mandel stress = committed_state(e, q, moved).stress;
            for (int c = 0; c < 4; ++c) out.stress.push_back(stress[c]);
            for (int c = 0; c < 4; ++c) out.plastic_strain.push_back(committed(state::plastic_strain + c, point));
            out.accumulated.push_back(committed(state::accumulated, point));
        }
    }
}

}  // namespace stria::fine
