#include "coarse/cycle/opening_swing.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "coarse/load/load_history.hpp"
#include "coarse/zone/tip_refinement.hpp"
#include "common/case/case_questions.hpp"
#include "common/case/schema/method_schema.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

constexpr double least_swing = 0.04;   // of K_max
constexpr std::size_t looked_at = 8;   // cycles: what takes longer may be a trend that turns
constexpr std::size_t to_and_fro = 4;  // places: it turns at two of them

void forget(OpeningSwingMemory::Tip& tip) {
    tip.cycles.clear();
    tip.ratios.clear();
}

void remember(OpeningSwingMemory::Tip& tip, int cycle, double ratio) {
    if (tip.ratios.size() == looked_at) {
        tip.cycles.erase(tip.cycles.begin());
        tip.ratios.erase(tip.ratios.begin());
    }
    tip.cycles.push_back(cycle);
    tip.ratios.push_back(ratio);
}

/// From a turn to the next one. What leads to the first turn and from the last one may be a trend as well.
double largest_swing(const std::vector<double>& ratios, const std::vector<std::size_t>& places) {
    double largest = 0.0;
    for (std::size_t k = 1; k + 2 < places.size(); ++k)
        largest = std::max(largest, std::abs(ratios[places[k + 1]] - ratios[places[k]]));
    return largest;
}

/// The last four places.
std::string numbers_of(const OpeningSwingMemory::Tip& tip, const std::vector<std::size_t>& places) {
    std::string all;
    for (std::size_t k = places.size() - to_and_fro; k < places.size(); ++k)
        all += fmt::format("{}{:.2f} in cycle {}", k + to_and_fro == places.size() ? "" : ", ", tip.ratios[places[k]],
                           tip.cycles[places[k]]);
    return all;
}

/// Of elements, until it is no more than is lawful: it falls with the first power of their size.
int halvings(double swing) { return static_cast<int>(std::ceil(std::log2(swing / least_swing))); }

/// The fine.refine that makes elements so much smaller, if one does: what has flowed is split no more.
std::string advice(const Scene& present, const Tip& tip, int halvings_wanted) {
    const int refine = present.input.fine.refine;
    const double finer = std::ldexp(refine, halvings_wanted - levels_missing(present, tip));
    if (finer <= refine || finer > most_refined) return "";
    return fmt::format(": fine.refine = {:g} takes it below {:g}", finer, least_swing);
}

std::string sentence_on(std::size_t t, const OpeningSwingMemory::Tip& tip, const std::vector<std::size_t>& places,
                        const Scene& present) {
    const double swing = largest_swing(tip.ratios, places);
    const Tip& place = present.enriched.tips[t];
    return fmt::format(
        "tip {}: K_op / K_max goes to and fro as it grows under one load, by {:.2g}: {}. It goes by where "
        "the tip stands among its elements of {:.3g} mm, the less the smaller they are{}. On these the "
        "mean of such cycles says more than one of them",
        t, swing, numbers_of(tip, places), tip_element_edge(present.enriched, place),
        advice(present, place, halvings(swing)));
}

}  // namespace

std::vector<std::size_t> places_of_turns(const std::vector<double>& values, double least) {
    std::vector<std::size_t> places;
    std::size_t lowest = 0, highest = 0;
    double sense = 0.0;  // in which it goes
    for (std::size_t k = 0; k < values.size(); ++k) {
        if (sense == 0.0) {
            if (values[k] < values[lowest]) lowest = k;
            if (values[k] > values[highest]) highest = k;
            if (values[highest] - values[lowest] <= least) continue;
            places = {std::min(lowest, highest), k};
            sense = lowest < highest ? 1.0 : -1.0;
        } else if (const double onwards = sense * (values[k] - values[places.back()]); onwards >= 0.0) {
            places.back() = k;
        } else if (-onwards > least) {
            places.push_back(k);
            sense = -sense;
        }
    }
    return places;
}

OpeningSwing::OpeningSwing(const Case& input, OpeningSwingMemory memory)
    : growth_(*input.growth), blocks_(input.load.blocks), has_levels_(!load_cases_vary(input)),
      memory_(std::move(memory)) {
    int last = 0;
    for (const LoadBlock& block : blocks_) last_cycles_.push_back(last += block.cycles);
}

LoadBlock OpeningSwing::level_of(int cycle) const {
    const auto block_of = [&](int number) {
        const int in_sequence = (number - 1) % last_cycles_.back();
        return blocks_[at(std::ranges::upper_bound(last_cycles_, in_sequence) - last_cycles_.begin())];
    };
    return {.cycles = 1, .max = block_of(cycle + 1).max, .min = block_of(cycle).min};
}

std::vector<std::string> OpeningSwing::add(int cycle, const std::vector<CycleResult>& cycles, const Scene& present) {
    if (!has_levels_ || cycle < 1 || !ends_period(growth_, cycle)) return {};
    const LoadBlock level = level_of(cycle);
    if (level != std::exchange(memory_.level, level))
        for (OpeningSwingMemory::Tip& tip : memory_.tips) forget(tip);
    memory_.tips.resize(cycles.size());
    std::vector<std::string> all;
    for (std::size_t t = 0; t < cycles.size(); ++t) {
        OpeningSwingMemory::Tip& tip = memory_.tips[t];
        const Tip& place = present.enriched.tips[t];
        const double ratio = cycles[t].opening.K_op / cycles[t].K_max;
        if (!std::isfinite(ratio) || !may_touch(present.input.cracks[at(place.crack)])) continue;
        remember(tip, cycle, ratio);
        const std::vector<std::size_t> places = places_of_turns(tip.ratios, least_swing);
        if (places.size() < to_and_fro) continue;
        const int graver = halvings(largest_swing(tip.ratios, places));
        if (graver <= std::exchange(tip.said, std::max(tip.said, graver))) continue;
        all.push_back(sentence_on(t, tip, places, present));
    }
    return all;
}

}  // namespace stria::coarse
