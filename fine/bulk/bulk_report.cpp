#include "fine/bulk/bulk_report.hpp"

#include <cmath>

namespace stria::fine {

void add_to(RingSums& rings, const Bulk& bulk, EnergyDensity density) {
    const Materials& materials = bulk.elements().materials();
    const InitialStress& initial = materials.initial_stress();
    const Tip& tip = rings.tip();
    for (const int e : rings.elements()) {
        rings.enter(e);
        const int material = bulk.elements().mesh().material_of(e);
        const std::vector<IntegrationPoint>& points = bulk.elements().op(e).points;
        bulk.for_each_committed_state(e, density, [&](std::size_t q, const Bulk::PointState& state) {
            rings.add(points[q], state.stress, state.gradient, state.energy);
            const Vec2& x = points[q].x;
            if (initial.any())
                rings.add_initial(points[q], state.stress, initial.slope(x, tip.material, tip.direction));
            if (!materials.are_alike(tip.material, material))
                rings.add_mismatch(points[q], materials.mismatch(tip.material, material, x, state.stress));
        });
    }
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
