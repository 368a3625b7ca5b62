#include "fine/bulk/bulk_report.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace stria::fine {
namespace {

/// Calls visit(element, point there, its place and weight), element by element.
template <class Visit> void for_each_point(const Bulk& bulk, const Visit& visit) {
    for (int e = 0; e < bulk.elements().count(); ++e) {
        const std::vector<IntegrationPoint>& points = bulk.elements().op(e).points;
        for (std::size_t q = 0; q < points.size(); ++q) visit(e, q, points[q]);
    }
}

void raise(double& largest, double value) { largest = std::max(largest, value); }

}  // namespace

double dissipation(const Bulk& bulk) {
    double sum = 0.0;
    for_each_point(bulk, [&](int e, std::size_t q, const IntegrationPoint& point) {
        sum += point.weight * bulk.history().dissipation(e, q);
    });
    return sum;
}

double stored_energy(const Bulk& bulk) {
    double sum = 0.0;
    for (int e = 0; e < bulk.elements().count(); ++e) {
        const std::vector<IntegrationPoint>& points = bulk.elements().op(e).points;
        for (std::size_t q = 0; q < points.size(); ++q) sum += points[q].weight * bulk.history().stored_energy(e, q);
        if (bulk.resting().contains(e)) sum += bulk.energy_since_rest(e);
    }
    return sum;
}

void add_to(RingSums& rings, const Bulk& bulk) {
    const InitialStress& initial = bulk.elements().materials().initial_stress();
    for (const int e : rings.elements()) {
        rings.enter(e);
        const std::vector<Bulk::PointState> states = bulk.committed_states(e);
        const std::vector<IntegrationPoint>& points = bulk.elements().op(e).points;
        for (std::size_t q = 0; q < states.size(); ++q) {
            rings.add(points[q], states[q].stress, states[q].gradient, states[q].work);
            if (initial.any())
                rings.add_initial(points[q], states[q].stress,
                                  initial.slope(points[q].x, bulk.elements().mesh().material_of(e), rings.direction()));
        }
    }
}

std::vector<PlasticExtent> plastic_extents(const Bulk& bulk) {
    const std::vector<Tip>& tips = bulk.elements().mesh().tips;
    std::vector<PlasticExtent> extents(tips.size());
    if (tips.empty()) return extents;
    for_each_point(bulk, [&](int e, std::size_t q, const IntegrationPoint& point) {
        if (bulk.history().accumulated(e, q) == 0.0) return;
        const auto distance = [&](const Tip& tip) { return (point.x - tip.position).norm(); };
        const auto own = at(std::ranges::min_element(tips, {}, distance) - tips.begin());
        PlasticExtent& extent = extents[own];
        const TipPolar polar = tip_polar(tips[own], point.x, 0);
        raise(extent.ever, polar.r);
        if (!bulk.history().is_plastic(e, q)) return;
        raise(extent.zone, polar.r);
        if (std::abs(polar.theta) <= std::numbers::pi / 12.0) raise(extent.axis, polar.r);
    });
    return extents;
}

double force_ahead(const Bulk& bulk, const Tip& tip, double radius) {
    const Vec2 normal(-tip.direction.y(), tip.direction.x());
    double sum = 0.0;
    for (int e = 0; e < bulk.elements().count(); ++e) {
        if (!bulk.elements().is_near(e, tip.position, radius)) continue;
        const std::vector<IntegrationPoint>& points = bulk.elements().op(e).points;
        for (std::size_t q = 0; q < points.size(); ++q) {
            const Vec2 from_tip = points[q].x - tip.position;
            const double along = from_tip.dot(tip.direction);
            if (from_tip.norm() > radius || along < std::abs(from_tip.dot(normal))) continue;
            sum += points[q].weight * normal.dot(in_plane(bulk.trial_stress(e, q)) * normal);
        }
    }
    return sum;
}

coupling::ZoneState state_of(const Bulk& bulk) {
    coupling::ZoneState out;
    out.displacement = bulk.committed_displacement();
    for (int e = 0; e < bulk.elements().count(); ++e) {
        const std::vector<Bulk::PointState> states = bulk.committed_states(e);
        for (std::size_t q = 0; q < states.size(); ++q) {
            const IntegrationPoint& p = bulk.elements().op(e).points[q];
            out.element.push_back(e);
            out.side.push_back(static_cast<std::int8_t>(p.side));
            out.x.push_back(p.x.x());
            out.y.push_back(p.x.y());
            out.weight.push_back(p.weight);
            const Mandel plastic_strain = bulk.history().plastic_strain(e, q);
            out.stress.insert(out.stress.end(), states[q].stress.begin(), states[q].stress.end());
            out.plastic_strain.insert(out.plastic_strain.end(), plastic_strain.begin(), plastic_strain.end());
            out.accumulated.push_back(bulk.history().accumulated(e, q));
        }
    }
    return out;
}

}  // namespace stria::fine
