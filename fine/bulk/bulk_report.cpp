#include "fine/bulk/bulk_report.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "common/material/initial_strain.hpp"

namespace stria::fine {

namespace {

// Point by point, whatever there is.
void add_points(RingSums& rings, const Bulk& bulk, EnergyDensity density, int e) {
    const Materials& materials = bulk.elements().materials();
    const InitialStress& initial = materials.initial_stress();
    const Tip& tip = rings.tip();
    const int material = bulk.elements().mesh().material_of(e);
    const std::vector<IntegrationPoint>& points = bulk.elements().op(e).points;
    const Eigen::Matrix2d of_initial = gradient_of_initial_stress(materials, tip.position, tip.material);
    bulk.for_each_committed_state(e, density, [&](std::size_t q, const Bulk::PointState& state) {
        rings.add(points[q], state.stress, state.gradient + of_initial, state.energy);
        const Vec2& x = points[q].x;
        if (initial.any()) rings.add_initial(points[q], state.stress, initial.slope(x, tip.material, tip.direction));
        if (!materials.are_alike(tip.material, material))
            rings.add_mismatch(points[q], materials.mismatch(tip.material, material, x, state.stress));
    });
}

/// How the nodes of an element of four functions have moved from where its points stand to what is committed; none of
/// one that has others, or that has not moved.
std::optional<NodeMotion> motion_of(const Bulk& bulk, int e) {
    constexpr std::size_t four_functions = 8;  // unknowns
    const ElementOperator& op = bulk.elements().op(e);
    if (op.unknowns.size() != four_functions) return std::nullopt;
    const ElementKernel<4> kernel(op);
    const Eigen::Matrix<double, 2, 4> moved =
        kernel.gather(bulk.committed_displacement()) - kernel.nodal(bulk.standing().displacement(e).data());
    return moved.isZero(0.0) ? std::nullopt : std::optional(stria::motion_of(moved));
}

void add_moved(RingSums& rings, const Bulk& bulk, EnergyDensity density, int e, const NodeMotion& motion,
               ElasticAnswers& answers) {
    const int stand = bulk.standing().times_moved(e);
    if (!rings.knows_way_from(stand)) {
        rings.begin_way_from(stand);
        const std::span<const ElasticResponse> responses = answers.of(bulk, density, rings.tip().direction, e);
        for (std::size_t q = 0; q < responses.size(); ++q)
            rings.tell_way(bulk.elements().op(e).points[q], responses[q]);
    }
    rings.add_moved(motion);
}

}  // namespace

// Most elements of a long wake are elastic for many increments.
void add_to(RingSums& rings, const Bulk& bulk, EnergyDensity density, ElasticAnswers& answers) {
    const Materials& materials = bulk.elements().materials();
    for (const int e : rings.elements()) {
        rings.enter(e);
        const bool adds_more = materials.initial_stress().any() ||
                               !materials.are_alike(rings.tip().material, bulk.elements().mesh().material_of(e));
        const std::optional<NodeMotion> motion = adds_more ? std::nullopt : motion_of(bulk, e);
        if (motion)
            add_moved(rings, bulk, density, e, *motion, answers);
        else
            add_points(rings, bulk, density, e);
    }
}

std::vector<std::int32_t> yielding_points(const Bulk& bulk) {
    std::vector<std::int32_t> count(at(bulk.elements().count()), 0);
    for (const int e : bulk.resting().awake()) count[at(e)] = bulk.history().yielding_points(e);
    return count;
}

double largest_plastic_increment(const Bulk& bulk) {
    double largest = 0.0;
    for (const int e : bulk.resting().awake()) largest = std::max(largest, bulk.history().largest_plastic_increment(e));
    return largest;
}

double force_ahead(const Bulk& bulk, const Tip& tip, double radius) {
    constexpr double rounding = 1e-9;  // of the radius: points of squares lie on the sides of the sector
    const Vec2 normal(-tip.direction.y(), tip.direction.x()), apex = tip.end_of_faces();
    double sum = 0.0;
    for (int e = 0; e < bulk.elements().count(); ++e) {
        if (!bulk.elements().is_near(e, apex, radius)) continue;
        const std::vector<IntegrationPoint>& points = bulk.elements().op(e).points;
        for (std::size_t q = 0; q < points.size(); ++q) {
            const Vec2 from_end = points[q].x - apex;
            const double along = from_end.dot(tip.direction) + rounding * radius;
            if (from_end.norm() > radius || along < std::abs(from_end.dot(normal))) continue;
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
