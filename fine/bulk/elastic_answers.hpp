// How the points of plain elements answer to the rings while their elements are elastic, from where they stand.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "common/fracture/elastic_share.hpp"
#include "fine/bulk/bulk.hpp"

namespace stria::fine {

/// Of one bulk and a tip. An answer serves as long as its points stand where they stood and the tip goes straight on,
/// however far: most of a wake stands for many cycles in which the tip moves in each.
class ElasticAnswers {
public:
    /// Of all points of an element with four functions. `along`: what the tip turns its point to.
    [[nodiscard]] std::span<const ElasticResponse> of(const Bulk& bulk, EnergyDensity density, const Vec2& along,
                                                      int element);

    /// Points whose answer was made so far.
    [[nodiscard]] std::size_t made() const { return made_; }

private:
    struct Known {
        int stand = -1;  // StandingPoints::times_moved()
        std::vector<ElasticResponse> points;
    };
    std::vector<Known> known_;  // of each element
    EnergyDensity density_ = EnergyDensity::StressWork;
    Vec2 along_ = Vec2::Zero();
    std::size_t made_ = 0;
};

}  // namespace stria::fine
