#include "fine/bulk/bulk_summary.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "coupling/flow_shells.hpp"

namespace stria::fine {
namespace {

/// Accumulated plastic strain from which on a point has flowed, of its life or of a half cycle: rounding decides which
/// of those that come back to the yield stress flow by 1e-9 of strain. A ring would come and go with one of them, and
/// with it the extent of a plastic zone.
constexpr double least_flow = 1e-6;

/// From the line ahead of a tip. Farther round lies the wake, which flows by itself: where an overload has opened it,
/// its faces yield for as long as they are pressed, ever farther behind the tip, which may be elastic by then.
constexpr double wake_begins = 0.75 * std::numbers::pi, about_line_ahead = std::numbers::pi / 12.0;

void raise(double& largest, double value) { largest = std::max(largest, value); }

}  // namespace

BulkSummary::BulkSummary(const Bulk& bulk)
    : tips_(bulk.elements().mesh().tips.size()), dissipation_(at(bulk.elements().count())), stored_(dissipation_),
      stored_ahead_(dissipation_), extents_(tips_ * dissipation_.size()) {
    for (int e = 0; e < bulk.elements().count(); ++e) look_at(bulk, e);
}

// What has yielded in the half cycle before counts no more, at rest or not.
void BulkSummary::update(const Bulk& bulk, bool half_cycle_begins) {
    if (half_cycle_begins)
        for (Extent& extent : extents_) extent.zone = extent.axis = 0.0;
    for (const int e : bulk.resting().awake()) {
        if (bulk.has_new_points(e))
            look_at(bulk, e);
        else
            follow(bulk, e);
    }
}

void BulkSummary::look_at(const Bulk& bulk, int e) {
    const PointHistory& history = bulk.history();
    const std::vector<IntegrationPoint>& points = bulk.elements().op(e).points;
    const std::vector<Tip>& tips = bulk.elements().mesh().tips;
    const std::span extents = std::span(extents_).subspan(tips_ * at(e), tips_);
    std::ranges::fill(extents, Extent());
    dissipation_[at(e)] = stored_[at(e)] = 0.0;
    follow(bulk, e);
    for (std::size_t q = 0; q < points.size(); ++q) {
        dissipation_[at(e)] += points[q].weight * history.dissipation(e, q);
        stored_[at(e)] += points[q].weight * history.stored_energy(e, q);
        if (tips.empty() || history.accumulated(e, q) == 0.0) continue;
        const auto distance = [&](const Tip& tip) { return (points[q].x - tip.position).norm(); };
        const auto own = at(std::ranges::min_element(tips, {}, distance) - tips.begin());
        const TipPolar polar = tip_polar(tips[own], points[q].x, 0);
        if (history.accumulated(e, q) > least_flow) raise(extents[own].ever, polar.r);
        if (history.flow(e, q) <= least_flow || std::abs(polar.theta) > wake_begins) continue;
        raise(extents[own].zone, polar.r);
        if (std::abs(polar.theta) <= about_line_ahead) raise(extents[own].axis, polar.r);
    }
}

double BulkSummary::sum(const std::vector<double>& of_elements) {
    return std::accumulate(of_elements.begin(), of_elements.end(), 0.0);
}

bool BulkSummary::has_flowed(int e) const {
    return std::ranges::any_of(std::span(extents_).subspan(tips_ * at(e), tips_),
                               [](const Extent& extent) { return extent.ever > 0.0; });
}

std::vector<BulkSummary::PlasticExtent> BulkSummary::plastic_extents(const EnrichedMesh& mesh) const {
    std::vector<PlasticExtent> all(tips_);
    for (std::size_t i = 0; i < extents_.size(); ++i) {
        const Extent& extent = extents_[i];
        if (extent.ever == 0.0 && extent.zone == 0.0) continue;
        const std::size_t e = i / tips_, t = i % tips_;
        const auto shell = [&](double reach, double axis) {
            return coupling::shell_of(mesh.elements[e], mesh.nodes, mesh.tips[t].position, reach, axis);
        };
        if (extent.ever > 0.0) all[t].flow_ever.push_back(shell(extent.ever, 0.0));
        if (extent.zone > 0.0) all[t].flow.push_back(shell(extent.zone, extent.axis));
    }
    for (PlasticExtent& extent : all)
        for (std::vector<coupling::FlowShell>* shells : {&extent.flow, &extent.flow_ever})
            *shells = coupling::joined(std::move(*shells));
    return all;
}

}  // namespace stria::fine
