#include "coupling/ranks/merged_reports.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/index.hpp"
#include "coupling/append.hpp"
#include "coupling/flow_shells.hpp"

namespace stria::coupling {
namespace {

void raise(double& value, double other) { value = std::max(value, other); }

/// Parts without an element have nothing to say of any tip or crack.
template <class T> void widen(std::vector<T>& list, std::size_t size, const T& value = {}) {
    if (list.size() < size) list.resize(size, value);
}

NearestContact merged(const NearestContact& one, const NearestContact& other) {
    NearestContact nearest = other.behind < one.behind ? other : one;
    nearest.closed = one.closed + other.closed;
    nearest.sliding = one.sliding + other.sliding;
    return nearest;
}

void add_digest(Digest& whole, const Digest& part, const std::vector<int>& elements) {
    for (std::size_t e = 0; e < elements.size(); ++e) whole.yielding_points[at(elements[e])] = part.yielding_points[e];
    raise(whole.largest_plastic_increment, part.largest_plastic_increment);
    append(whole.status, part.status);
    append(whole.multiplier, part.multiplier);
    whole.status_changes += part.status_changes;
    widen(whole.contact, part.contact.size());
    for (std::size_t t = 0; t < part.contact.size(); ++t) {
        widen(whole.contact[t], part.contact[t].size(), -std::numeric_limits<double>::infinity());
        for (std::size_t k = 0; k < part.contact[t].size(); ++k) raise(whole.contact[t][k], part.contact[t][k]);
    }
    widen(whole.opening, part.opening.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::size_t t = 0; t < part.opening.size(); ++t)
        if (std::isfinite(part.opening[t])) whole.opening[t] = part.opening[t];
    widen(whole.force_ahead, part.force_ahead.size());
    for (std::size_t t = 0; t < part.force_ahead.size(); ++t) whole.force_ahead[t] += part.force_ahead[t];
    widen(whole.nearest, part.nearest.size());
    for (std::size_t t = 0; t < part.nearest.size(); ++t) {
        widen(whole.nearest[t], part.nearest[t].size());
        for (std::size_t k = 0; k < part.nearest[t].size(); ++k)
            whole.nearest[t][k] = merged(whole.nearest[t][k], part.nearest[t][k]);
    }
}

void add_flow(std::vector<FlowShell>& whole, const std::vector<FlowShell>& part) {
    append(whole, part);
    whole = joined(std::move(whole));
}

void add_tips(StepReport& whole, const StepReport& part) {
    widen(whole.tips, part.tips.size());
    for (std::size_t t = 0; t < part.tips.size(); ++t) {
        raise(whole.tips[t].CTOD, part.tips[t].CTOD);
        if (std::isfinite(part.tips[t].opening)) whole.tips[t].opening = part.tips[t].opening;
        add_flow(whole.tips[t].flow, part.tips[t].flow);
        add_flow(whole.tips[t].flow_ever, part.tips[t].flow_ever);
    }
}

void add_rings(StepReport& whole, const StepReport& part) {
    for (const RingReport& share : part.rings) {
        const auto same = [&](const RingReport& r) { return r.tip == share.tip && r.number == share.number; };
        std::ranges::find_if(whole.rings, same)->sums += share.sums;
    }
}

// The faces of a crack are all with one part.
void add_faces(StepReport& whole, const StepReport& part) {
    const std::size_t cracks = part.contact_length.size();
    widen(whole.contact_length, cracks);
    widen(whole.mouth_opening, cracks, std::numeric_limits<double>::quiet_NaN());
    append(whole.faces, part.faces);
    for (std::size_t crack = 0; crack < cracks; ++crack) {
        whole.contact_length[crack] += part.contact_length[crack];
        if (!std::isnan(part.mouth_opening[crack])) whole.mouth_opening[crack] = part.mouth_opening[crack];
    }
}

/// A part that no load case loads has none.
void add_paths(Eigen::VectorXd& whole, const Eigen::VectorXd& part) {
    if (whole.size() == 0)
        whole = part;
    else if (part.size() > 0)
        whole += part;
}

void add_counters(StepReport& whole, const StepReport& part) {
    whole.dissipation += part.dissipation;
    whole.energy.stored += part.energy.stored;
    whole.energy.released += part.energy.released;
    whole.energy.friction += part.energy.friction;
    whole.energy.contact += part.energy.contact;
    whole.energy.load_path += part.energy.load_path;
    add_paths(whole.energy.case_paths, part.energy.case_paths);
    whole.points += part.points;
    whole.unknowns += part.unknowns;
    whole.multipliers += part.multipliers;
    whole.work += part.work;
    raise(whole.constitutive_s, part.constitutive_s);
    raise(whole.contact_s, part.contact_s);
    raise(whole.factor_s, part.factor_s);
}

}  // namespace

void add(PatchResponse& whole, const PatchResponse& part, const std::vector<int>& elements) {
    raise(whole.interior_residual, part.interior_residual);
    raise(whole.interior_force, part.interior_force);
    raise(whole.contact_residual, part.contact_residual);
    raise(whole.interior_correction, part.interior_correction);
    raise(whole.interior_displacement, part.interior_displacement);
    whole.along += part.along;
    whole.along_before += part.along_before;
    whole.provisional = whole.provisional || part.provisional;
    whole.woken = whole.woken || part.woken;
    whole.opens_faces = whole.opens_faces || part.opens_faces;
    whole.may_keep_factor = whole.may_keep_factor && part.may_keep_factor;
    add_digest(whole.digest, part.digest, elements);
}

StepReport sum_of(const std::vector<StepReport>& parts, const std::vector<Ring>& rings) {
    StepReport whole;
    for (const Ring& ring : rings) whole.rings.push_back({.tip = ring.tip, .number = ring.number, .sums = {}});
    for (const StepReport& part : parts) {
        add_tips(whole, part);
        add_rings(whole, part);
        add_faces(whole, part);
        add_counters(whole, part);
    }
    std::ranges::stable_sort(whole.faces, {}, &FaceSample::crack);
    return whole;
}

void forget_state(StepReport& report) {
    report.tips.clear();
    report.rings.clear();
    report.faces.clear();
    report.contact_length.clear();
    report.mouth_opening.clear();
    report.dissipation = 0.0;
    report.energy = {};
    report.points = report.unknowns = report.multipliers = 0;
}

void add(ZoneState& whole, const ZoneState& part, const std::vector<int>& unknowns, const std::vector<int>& elements) {
    whole.displacement(unknowns) = part.displacement;
    for (const std::int32_t element : part.element) whole.element.push_back(elements[at(element)]);
    append(whole.side, part.side);
    append(whole.x, part.x);
    append(whole.y, part.y);
    append(whole.weight, part.weight);
    append(whole.stress, part.stress);
    append(whole.plastic_strain, part.plastic_strain);
    append(whole.accumulated, part.accumulated);
    append(whole.frozen_tips, part.frozen_tips);
}

}  // namespace stria::coupling
