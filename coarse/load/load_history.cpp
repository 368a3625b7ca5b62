#include "coarse/load/load_history.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace stria::coarse {
namespace {

/// Ways of no length are none; what their ends would have been, the end before is.
void append(std::vector<Leg>& all, const Leg& leg) {
    if (leg.from != leg.to) {
        all.push_back(leg);
    } else if (!all.empty()) {
        all.back().ends_cycle = all.back().ends_cycle || leg.ends_cycle;
        all.back().at_maximum = all.back().at_maximum || leg.at_maximum;
    }
}

// A half cycle ends where the load turns, not where a block does.
void mark_reversals(std::vector<Leg>& all) {
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool last = k + 1 == all.size();
        all[k].reversal = last || (all[k].to - all[k].from) * (all[k + 1].to - all[k + 1].from) < 0.0;
    }
}

/// Of a load or a load case: blocks that are more than cycles of one kind.
bool are_unlike(const auto& blocks) {
    return std::ranges::any_of(blocks, [&](auto block) {
        block.cycles = blocks.front().cycles;
        return block != blocks.front();
    });
}

}  // namespace

std::vector<Leg> legs(const LoadSection& load) {
    std::vector<Leg> all;
    double at = 0.0;
    int cycle = 0;
    const auto go = [&](Leg leg) {
        leg.from = at;
        at = leg.to *= load.scale;
        append(all, leg);
    };
    for (int repetition = 0; repetition < load.repeat; ++repetition) {
        for (const LoadBlock& block : load.blocks) {
            for (int k = 0; k < std::max(block.cycles, 1); ++k) {
                go({.cycle = cycle, .from = 0, .to = block.max, .at_maximum = true, .ends_cycle = cycle > 0});
                if (block.cycles > 0) go({.cycle = ++cycle, .from = 0, .to = block.min, .at_minimum = true});
            }
        }
    }
    if (cycle > 0)
        go({.cycle = cycle, .from = 0, .to = load.blocks.back().max, .at_maximum = true, .ends_cycle = true});
    mark_reversals(all);
    return all;
}

int cycle_count(const LoadSection& load) {
    int cycles = 0;
    for (const LoadBlock& block : load.blocks) cycles += block.cycles;
    return load.repeat * cycles;
}

bool varies(const Case& input) { return are_unlike(input.load.blocks) || load_cases_vary(input); }

bool load_cases_vary(const Case& input) {
    return std::ranges::any_of(input.load_cases,
                               [](const LoadCaseSection& load_case) { return are_unlike(load_case.blocks); });
}

LoadSection cycles_ahead(const LoadSection& load, int passed) {
    LoadSection ahead = load;
    if (load.repeat > 1) return ahead;
    const int all = cycle_count(load), least = (all + 9) / 10;
    int left = std::min(passed, all - least);
    for (LoadBlock& block : ahead.blocks) {
        const int gone = std::min(left, block.cycles);
        block.cycles -= gone;
        left -= gone;
    }
    std::erase_if(ahead.blocks, [](const LoadBlock& block) { return block.cycles == 0; });
    return ahead.blocks.empty() ? load : ahead;
}

double largest_value(const LoadSection& load) {
    double largest = 0.0;
    for (const LoadBlock& block : load.blocks)
        largest = std::max({largest, load.scale * block.max, load.scale * block.min});
    return largest;
}

double smallest_value(const LoadSection& load) {
    double smallest = 0.0;
    for (const LoadBlock& block : load.blocks)
        smallest = std::min({smallest, load.scale * block.max, load.scale * block.min});
    return smallest;
}

double median_maximum(const LoadSection& load, double m) {
    const double largest = largest_value(load);
    std::map<double, double> growth;  // by maxima
    double all = 0.0;
    for (const LoadBlock& block : load.blocks) {
        const double max = std::max(load.scale * block.max, 0.0), min = std::max(load.scale * block.min, 0.0);
        if (max == 0.0) continue;
        const double part = block.cycles * std::pow((max - min) / largest, m);
        growth[max] += part;
        all += part;
    }
    double below = 0.0;
    for (const auto& [max, part] : growth)
        if ((below += part) >= 0.5 * all) return max;
    return largest;
}

}  // namespace stria::coarse
