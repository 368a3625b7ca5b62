#include "tests/stress/tally.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iostream>
#include <regex>

namespace stria::test {

void Tally::measure(const std::string& name, unsigned seed, double value, double limit) {
    Measure& measure = measures_[name];
    measure.limit = limit;
    measure.values.push_back(value);
    if (!(value <= measure.worst)) measure.worst = value, measure.worst_seed = seed;
    if (!(value <= limit)) fail(name, seed, fmt::format("{:.3g}, at most {:.3g}", value, limit));
}

void Tally::fail(const std::string& name, unsigned seed, const std::string& text) {
    failures_.push_back(fmt::format("seed {}: {}: {}", seed, name, text));
    std::cout << failures_.back() << std::endl;
}

void Tally::refuse(const std::string& sentence, unsigned seed) {
    static const std::regex number("-?[0-9]+(\\.[0-9]+)?(e[-+][0-9]+)?");
    Refusal& refusal = refusals_[std::regex_replace(sentence, number, "#")];
    if (refusal.count++ == 0) refusal.first_seed = seed;
}

void Tally::print() const {
    for (const auto& [name, measure] : measures_) {
        std::vector<double> sorted = measure.values;
        std::ranges::sort(sorted);
        std::cout << fmt::format("{:52s} {:5d} trials, median {:.2g}, worst {:.2g} (seed {}), allowed {:.2g}\n", name,
                                 sorted.size(), sorted[sorted.size() / 2], measure.worst, measure.worst_seed,
                                 measure.limit);
    }
    for (const auto& [sentence, refusal] : refusals_)
        std::cout << fmt::format("refused {} times, first seed {}: {}\n", refusal.count, refusal.first_seed, sentence);
    std::cout << fmt::format("{} failures\n", failures_.size());
}

}  // namespace stria::test
