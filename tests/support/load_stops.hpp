// The loads at which a controller stops on its way through a history.
#pragma once

#include <gtest/gtest.h>

#include "coarse/load/case_histories.hpp"
#include "coarse/load/load_controller.hpp"

namespace stria::coarse {

inline Case cycles(int steps, std::vector<LoadBlock> blocks) {
    Case input;
    input.load = {.steps = steps, .grading = 1.0, .blocks = std::move(blocks)};
    return input;
}

struct Stop {
    double main;
    std::vector<double> cases;
    bool operator==(const Stop&) const = default;
};

inline std::vector<Stop> stops(LoadController loads) {
    std::vector<Stop> all;
    for (; loads.next(); loads.accepted()) {
        const Target target = loads.next()->target;
        all.push_back({target.value, {target.cases.begin(), target.cases.end()}});
    }
    return all;
}

inline LoadController controller(const Case& input) {
    return LoadController(input.load, input.solver, CaseHistories(input));
}

inline void expect_close(const std::vector<Stop>& found, const std::vector<Stop>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        EXPECT_NEAR(found[k].main, expected[k].main, 1e-12) << k;
        ASSERT_EQ(found[k].cases.size(), expected[k].cases.size());
        for (std::size_t c = 0; c < found[k].cases.size(); ++c)
            EXPECT_NEAR(found[k].cases[c], expected[k].cases[c], 1e-12) << k << " " << c;
    }
}

}  // namespace stria::coarse
