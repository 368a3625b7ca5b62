// What the zone remembers, written down and taken up again: bulk, contact, and tips left behind.
#include <algorithm>
#include <ranges>

#include "common/error.hpp"
#include "common/index.hpp"
#include "fine/zone/zone_system.hpp"

namespace stria::fine {
namespace {

/// A row of ZoneSnapshot::history: so many numbers, then the state of the law.
constexpr std::size_t leading = 12;

IntegrationPoint point_of(const double* row) {
    return {.x = {row[0], row[1]},
            .xi = {row[2], row[3]},
            .weight = row[4],
            .side = static_cast<int>(row[5]),
            .region = static_cast<int>(row[6])};
}

}  // namespace

Zone::Zone(const EnrichedMesh& mesh, std::unique_ptr<MaterialLaw> law, const Elasticity& elastic,
           const IntegrationRule& rule, const coupling::ZoneSnapshot& snapshot)
    : Zone(mesh, std::move(law), elastic, rule, snapshot.displacement,
           [&, histories = histories_of_elements(snapshot)](std::size_t e, const CrackPiece*) {
               std::vector<IntegrationPoint> points;
               for (std::size_t q = 0; q < histories.at(e).rows; ++q) {
                   const std::size_t row = histories[e].first_row + q;
                   points.push_back(point_of(&snapshot.history.at(row * at(snapshot.columns))));
               }
               return points;
           }) {
    const auto columns = at(snapshot.columns), n = at(points_);
    require(snapshot.element == mesh_.element_ids && columns * n == snapshot.history.size() &&
                columns == leading + at(law_->state_size()),
            "a snapshot has the elements of its zone, in its order, and the states of its law");
    half_cycle_ended_ = snapshot.half_cycle_ended;
    std::vector<Eigen::Matrix2d> frozen(n);
    for (std::size_t q = 0; q < n; ++q) {
        const double* row = &snapshot.history[q * columns];
        flowed_[q] = row[7] != 0.0 ? 1 : 0;
        frozen[q] << row[8], row[9], row[10], row[11];
        for (std::size_t c = leading; c < columns; ++c) committed_[(c - leading) * n + q] = row[c];
    }
    const bool some =
        std::ranges::any_of(frozen, [](const Eigen::Matrix2d& gradient) { return !gradient.isZero(0.0); });
    if (some) frozen_gradient_ = std::move(frozen);
    trial_ = committed_;
    settle();
    quiet_half_cycles_.assign(snapshot.quiet_half_cycles.begin(), snapshot.quiet_half_cycles.end());
    std::vector<char> resting(operators_.size(), 0);
    for (std::size_t e = 0; e < snapshot.resting.size(); ++e) resting[e] = snapshot.resting[e] != 0 ? 1 : 0;
    rest(resting, snapshot.rest_displacement);
}

void Zone::remember(coupling::ZoneSnapshot& out) const {
    out.element = mesh_.element_ids;
    out.rank.assign(out.element.size(), 0);
    for (const ElementOperator& op : operators_) out.points.push_back(static_cast<std::int32_t>(op.points.size()));
    out.columns = static_cast<std::int32_t>(leading) + law_->state_size();
    out.history.reserve(at(out.columns * points_));
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        for (std::size_t q = 0; q < operators_[e].points.size(); ++q) {
            const IntegrationPoint& p = operators_[e].points[q];
            const int point = first_point_[e] + static_cast<int>(q);
            const auto place = at(point);
            const Eigen::Matrix2d frozen =
                frozen_gradient_.empty() ? Eigen::Matrix2d::Zero().eval() : frozen_gradient_[place];
            out.history.insert(out.history.end(),
                               {p.x.x(), p.x.y(), p.xi.x(), p.xi.y(), p.weight, static_cast<double>(p.side),
                                static_cast<double>(p.region), static_cast<double>(flowed_[place]), frozen(0, 0),
                                frozen(0, 1), frozen(1, 0), frozen(1, 1)});
            for (int c = 0; c < law_->state_size(); ++c) out.history.push_back(committed(c, point));
        }
    }
    out.half_cycle_ended = half_cycle_ended_;
    out.quiet_half_cycles.assign(quiet_half_cycles_.begin(), quiet_half_cycles_.end());
    for (std::size_t e = 0; e < operators_.size(); ++e) out.resting.push_back(rests(e) ? 1 : 0);
    out.rest_displacement = rest_u_;
}

coupling::ZoneSnapshot ZoneSystem::snapshot() const {
    coupling::ZoneSnapshot out;
    zone_->remember(out);
    out.displacement = committed_.displacement;
    for (const Unknowns& increment : increments_.all()) out.increments.push_back(increment.displacement);
    out.held = opening_.held(patch_.mesh.unknowns);
    for (int k = 0; k < contact_->multipliers(); ++k) {
        const ContactInterface::Key& key = contact_->keys()[at(k)];
        coupling::MultiplierSnapshot multiplier;
        multiplier.crack = key.crack;
        multiplier.place = key.x;
        multiplier.pressure = committed_.pressure[k];
        multiplier.closed = contact_->committed_statuses()[at(k)] != 0;
        for (const Unknowns& increment : increments_.all()) multiplier.increments.push_back(increment.pressure[k]);
        out.multipliers.push_back(std::move(multiplier));
    }
    out.frozen_tips = frozen_.tips();
    return out;
}

void ZoneSystem::restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) {
    frozen_ = FrozenTips(snapshot.frozen_tips);
    make_contact(patch);
    const int multipliers = contact_->multipliers();
    require(std::ssize(snapshot.multipliers) == multipliers, "a snapshot has the multipliers of its zone");
    std::vector<std::int8_t> statuses;
    committed_ = {snapshot.displacement, Eigen::VectorXd(multipliers)};
    std::vector<Unknowns> increments;
    for (const Eigen::VectorXd& displacement : snapshot.increments)
        increments.push_back({displacement, Eigen::VectorXd(multipliers)});
    for (int k = 0; k < multipliers; ++k) {
        const coupling::MultiplierSnapshot& multiplier = snapshot.multipliers[at(k)];
        require(contact_->keys()[at(k)].is_at(multiplier.crack, multiplier.place),
                "multipliers of a snapshot are in the order of the cracks");
        statuses.push_back(multiplier.closed ? 1 : 0);
        committed_.pressure[k] = multiplier.pressure;
        for (std::size_t back = 0; back < increments.size(); ++back)
            increments[back].pressure[k] = multiplier.increments.at(back);
    }
    contact_->restore(std::move(statuses));
    increments_.clear();
    for (Unknowns& increment : increments | std::views::reverse) increments_.push(std::move(increment));
    opening_ = OpeningFaces(snapshot.held);
    const coupling::WorkCounts so_far = zone_ ? zone_->counts() : coupling::WorkCounts();
    zone_ = std::make_unique<Zone>(patch.mesh, make_law(), elastic_, rule(), snapshot);
    zone_->count_on_from(so_far);
    begin_with(patch);
}

}  // namespace stria::fine
