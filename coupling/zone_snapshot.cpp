#include "coupling/zone_snapshot.hpp"

#include <algorithm>
#include <map>

#include "common/index.hpp"
#include "common/integration/element_operator.hpp"
#include "coupling/append.hpp"

namespace stria::coupling {

std::vector<ElementHistory> histories_of_elements(const ZoneSnapshot& snapshot) {
    std::vector<ElementHistory> histories;
    std::size_t row = 0, unknown = 0;
    for (std::size_t e = 0; e < snapshot.points.size(); ++e) {
        histories.push_back({row, at(snapshot.points[e]), unknown, at(snapshot.unknowns[e])});
        row += histories.back().rows;
        unknown += histories.back().unknowns;
    }
    return histories;
}

ZoneSnapshot part_of(const ZoneSnapshot& whole, const EnrichedMesh& part, const std::vector<int>& unknowns) {
    ZoneSnapshot own;
    own.ranks = whole.ranks;
    own.columns = whole.columns;
    own.half_cycle_ended = whole.half_cycle_ended;
    std::map<int, std::size_t> place;
    for (std::size_t e = 0; e < whole.element.size(); ++e) place[whole.element[e]] = e;
    const std::vector<ElementHistory> histories = histories_of_elements(whole);
    for (const int id : part.element_ids) {
        const std::size_t e = place.at(id);
        own.element.push_back(id);
        own.rank.push_back(whole.rank[e]);
        own.points.push_back(whole.points[e]);
        own.recent_flow.push_back(whole.recent_flow[e]);
        own.unknowns.push_back(whole.unknowns[e]);
        own.resting.push_back(whole.resting[e]);
        own.flow.push_back(whole.flow[e]);
        const auto columns = at(whole.columns);
        const auto begin = whole.history.begin() + static_cast<std::ptrdiff_t>(histories[e].first_row * columns);
        own.history.insert(own.history.end(), begin, begin + static_cast<std::ptrdiff_t>(histories[e].rows * columns));
        const auto stand = whole.stand.begin() + static_cast<std::ptrdiff_t>(histories[e].first_unknown);
        own.stand.insert(own.stand.end(), stand, stand + whole.unknowns[e]);
    }
    own.displacement = gather(whole.displacement, unknowns);
    own.rest_displacement = gather(whole.rest_displacement, unknowns);
    for (const Eigen::VectorXd& increment : whole.increments) own.increments.push_back(gather(increment, unknowns));
    own.held = gather(whole.held, unknowns);
    const auto here = [&](int crack) { return std::ranges::find(part.pieces, crack, &CrackPiece::crack); };
    for (const MultiplierSnapshot& multiplier : whole.multipliers)
        if (here(multiplier.crack) != part.pieces.end()) own.multipliers.push_back(multiplier);
    for (const FrozenTip& tip : whole.frozen_tips)
        if (here(tip.crack) != part.pieces.end()) own.frozen_tips.push_back(tip);
    return own;
}

void add(ZoneSnapshot& whole, const ZoneSnapshot& part, std::int32_t rank, const std::vector<int>& unknowns) {
    append(whole.element, part.element);
    whole.rank.insert(whole.rank.end(), part.element.size(), rank);
    append(whole.points, part.points);
    append(whole.recent_flow, part.recent_flow);
    append(whole.unknowns, part.unknowns);
    append(whole.resting, part.resting);
    append(whole.flow, part.flow);
    append(whole.stand, part.stand);
    whole.columns = part.columns;
    append(whole.history, part.history);
    whole.half_cycle_ended = part.half_cycle_ended;
    whole.displacement(unknowns) = part.displacement;
    whole.rest_displacement(unknowns) = part.rest_displacement;
    for (std::size_t k = 0; k < part.increments.size(); ++k) whole.increments.at(k)(unknowns) = part.increments[k];
    whole.held(unknowns) += part.held;
    append(whole.multipliers, part.multipliers);
    append(whole.frozen_tips, part.frozen_tips);
}

}  // namespace stria::coupling
