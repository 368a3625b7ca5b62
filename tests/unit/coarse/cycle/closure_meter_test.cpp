// Where contact comes and goes between two states, found by trying.
#include "coarse/cycle/closure_meter.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

#include "common/index.hpp"
#include "tests/support/closure_reports.hpp"

namespace stria::coarse {
namespace {

/// Faces that touch as far as `reach` behind the tip, and press or open in proportion.
NewtonReport with_reach(const ClosureMeter& meter, double reach, double ahead = 1.0) {
    NewtonReport report{.converged = true, .iterations = {{}}, .lost = {}, .failure = {}};
    for (const double distance : meter.distances(0))
        report.iterations.back().residual.faces.resize(1),
            report.iterations.back().residual.faces[0].push_back(reach - distance);
    report.iterations.back().residual.force_ahead = {ahead};
    return report;
}

TEST(ClosureMeter, HasEachDistanceOnce) {
    Case input = loaded();
    input.closure.distance = 0.4;
    input.closure.profile = {0.1, 0.4, 0.2, 0.1};
    const ClosureMeter meter(input.closure, {300.0}, input.cracks, {500.0});
    EXPECT_EQ(meter.distances(0), (std::vector<double>{0.4, 0.1, 0.2}));
}

TEST(ClosureMeter, CountsOnlyContactBeyondItsDistances) {
    Case input = loaded();
    input.closure.distance = 0.2;
    input.closure.profile = {0.05, 0.4};
    const ClosureMeter meter(input.closure, {300.0}, input.cracks, {500.0});
    EXPECT_EQ(meter.signals().all(), 3U);
    EXPECT_EQ(closed(meter.signal(with_reach(meter, 0.3), {})), (std::vector<bool>{1, 1, 0}));
    EXPECT_EQ(closed(meter.signal(with_reach(meter, 0.1), {})), (std::vector<bool>{0, 1, 0}));
    EXPECT_EQ(closed(meter.signal(with_reach(meter, -1.0), {})), (std::vector<bool>{0, 0, 0}));
    EXPECT_NEAR(ClosureMeter(loaded().closure, {300.0}, loaded().cracks, {500.0}).distances(0)[0],
                0.1 * 3.14159265 / 16.0 * 25.0 / 9.0, 1e-6);
}

TEST(ClosureMeter, SeesCompressionAheadWhereAsked) {
    Case input = loaded();
    input.closure.definition = OpeningDefinition::Tension;
    const ClosureMeter meter(input.closure, {300.0}, input.cracks, {500.0});
    EXPECT_EQ(meter.signals().all(), 2U);
    EXPECT_EQ(closed(meter.signal(with_reach(meter, -1.0, -2.0), {})), (std::vector<bool>{0, 1}));
    EXPECT_EQ(closed(meter.signal(with_reach(meter, -1.0, 2.0), {})), (std::vector<bool>{0, 0}));
}

TEST(ClosureMeter, FindsTheLoadAsPreciselyAsAsked) {
    Case input = loaded();
    input.closure.distance = 0.2;
    const ClosureMeter meter(input.closure, {300.0}, input.cracks, {500.0});
    int trials = 0;
    const auto solve = [&](double target) {
        ++trials;
        return ClosureMeter::Trial{with_reach(meter, target < 37.3 ? 1.0 : -1.0), target};
    };
    const auto opening = meter.locate({30.0, 30.0, {1.0}}, {40.0, 40.0, {-1.0}}, {0.2, solve});
    ASSERT_EQ(opening.size(), 1U);
    EXPECT_FALSE(opening[0].closes);
    EXPECT_NEAR(opening[0].load_factor, 37.3, 0.2);
    EXPECT_LE(trials, 12);  // of a signal that only says whether
    const auto closing = meter.locate({40.0, 40.0, {-1.0}}, {30.0, 30.0, {1.0}}, {0.2, solve});
    ASSERT_EQ(closing.size(), 1U);
    EXPECT_TRUE(closing[0].closes);
    EXPECT_NEAR(closing[0].load_factor, 37.3, 0.2);
    EXPECT_TRUE(meter.locate({30.0, 30.0, {1.0}}, {40.0, 40.0, {1.0}}, {0.2, solve}).empty());
}

// Faces press with another stiffness than they open with, and neither quite in proportion to the load.
TEST(ClosureMeter, GoesStraightToWhereContactIsLost) {
    Case input = loaded();
    input.closure.distance = 0.2;
    const ClosureMeter meter(input.closure, {300.0}, input.cracks, {500.0});
    for (const double stiffer : {0.05, 0.5, 1.0, 7.0, 60.0}) {
        for (const double root : {30.5, 33.0, 37.3, 39.8}) {
            int trials = 0;
            const auto signal = [&](double target) {
                const double x = root - target;
                return (x > 0.0 ? stiffer : 1.0) * x * (1.0 + 0.01 * x) + (x > 0.0 ? 1e-9 : 0.0);
            };
            const auto solve = [&](double target) {
                ++trials;
                return ClosureMeter::Trial{with_reach(meter, 0.2 + signal(target)), 2.0 * target};
            };
            for (const auto& [from, to] : {std::pair{30.0, 40.0}, {40.0, 30.0}}) {
                trials = 0;
                const auto changes =
                    meter.locate({from, 2.0 * from, {signal(from)}}, {to, 2.0 * to, {signal(to)}}, {0.1, solve});
                ASSERT_EQ(changes.size(), 1U);
                EXPECT_NEAR(changes[0].load_factor, 2.0 * root, 0.1) << stiffer << " " << root;
                EXPECT_LE(trials, 5) << stiffer << " " << root << " from " << from;
            }
        }
    }
}

/// A signal is looked for between two targets, at which it says otherwise.
struct Search {
    static constexpr double root = 37.3, precision = 0.1;
    OpeningChange found;
    int trials = 0;

    Search(const std::function<double(double)>& signal, const ExpectedCrossing& expected, double from = 30.0,
           double to = 40.0) {
        Case input = loaded();
        input.closure.distance = 0.2;
        const ClosureMeter meter(input.closure, {300.0}, input.cracks, {500.0});
        const auto solve = [&](double target) {
            ++trials;
            return ClosureMeter::Trial{with_reach(meter, 0.2 + signal(target)), target};
        };
        const auto changes =
            meter.locate({from, from, {signal(from)}}, {to, to, {signal(to)}}, {precision, solve, {expected}});
        EXPECT_EQ(changes.size(), 1U);
        found = changes.at(0);
        EXPECT_NEAR(found.target, root, precision);
    }
};

/// Faces press with another stiffness than they open with.
double bent(double target, double bend) {
    const double x = Search::root - target;
    return (x > 0.0 ? 7.0 : 1.0) * x * (1.0 + bend * x);
}

// A cycle opens and closes nearly where the last one did: then one trial tells, or two of a signal that only says
// whether. What is expected elsewhere costs a trial and changes nothing.
TEST(ClosureMeter, TriesFirstWhereItIsExpected) {
    const auto signal = [](double target) { return bent(target, 0.05); };
    const auto whether = [](double target) { return target < Search::root ? 1.0 : -1.0; };
    const auto trials = [](const auto& of, double expected) { return Search(of, {.target = expected}).trials; };
    for (const double off : {-0.04, 0.0, 0.04}) {
        EXPECT_EQ(trials(signal, Search::root + off), 1) << off;
        EXPECT_EQ(trials(whether, Search::root + off), 2) << off;
    }
    for (const double elsewhere : {29.0, 30.0, 31.0, 40.0, 55.0}) {
        EXPECT_LE(trials(signal, elsewhere), trials(signal, NAN) + 1) << elsewhere;
        EXPECT_LE(trials(whether, elsewhere), trials(whether, NAN) + 2) << elsewhere;
    }
}

// What a signal changed by beside zero a cycle ago leads from where it was expected to where it is.
TEST(ClosureMeter, FollowsTheRatesOfTheCycleBefore) {
    const auto signal = [](double target) { return bent(target, 0.01); };
    for (const double off : {-0.5, -0.3, 0.3, 0.5}) {
        const double expected = Search::root + off;
        const Search first(signal, {.target = expected});
        const std::size_t side = off < 0.0 ? 1 : 0;
        EXPECT_NEAR(first.found.rate[side], side == 1 ? -7.0 : -1.0, 0.05) << off;
        EXPECT_GT(first.trials, 2) << off;
        const Search second(signal, {.target = expected, .rate = first.found.rate});
        EXPECT_EQ(second.trials, 2) << off;
        for (const double wrong : {-70.0, -20.0, -2.0, 5.0}) {
            const Search misled(signal, {.target = expected, .rate = {wrong, wrong}});
            EXPECT_NEAR(misled.found.target, Search::root, 0.5 * Search::precision) << off << " " << wrong;
        }
    }
}

// Elastic faces meet in each cycle at the same load, where an increment ends: there the signal is zero, its sign is
// rounding, and no trial is needed.
TEST(ClosureMeter, TakesAStationThatIsOnZeroForThePlace) {
    for (const double rounding : {-1e-13, 1e-13}) {
        const auto signal = [&](double target) { return target == Search::root ? rounding : bent(target, 0.01); };
        const double other = rounding > 0.0 ? 40.0 : 30.0;  // says otherwise
        for (const auto& [from, to] : {std::pair{Search::root, other}, {other, Search::root}}) {
            const Search search(signal, {.target = Search::root, .rate = {-1.0, -7.0}}, from, to);
            EXPECT_EQ(search.trials, 0) << rounding << " to " << to;
            EXPECT_NEAR(search.found.target, Search::root, 1e-6) << rounding << " to " << to;
        }
    }
}

// A crack that unzips from its mouth: farther distances open earlier, and one trial serves all of them.
TEST(ClosureMeter, SharesItsTrialsAmongDistances) {
    Case input = loaded();
    input.closure.distance = 0.1;
    input.closure.profile = {0.2, 0.4};
    const ClosureMeter meter(input.closure, {300.0}, input.cracks, {500.0});
    int trials = 0;
    const auto solve = [&](double target) {
        ++trials;
        return ClosureMeter::Trial{with_reach(meter, (40.0 - target) / 10.0 * 0.5), target};
    };
    const auto station = [&](double target) {
        return ClosureStation{target, target, meter.signal(solve(target).report, {})};
    };
    const ClosureStation pressed = station(30.0), apart = station(40.0);
    trials = 0;
    const auto changes = meter.locate(pressed, apart, {0.1, solve});
    ASSERT_EQ(changes.size(), 3U);
    for (const OpeningChange& change : changes) {
        const double distance = meter.distances(0)[at(change.signal)];
        EXPECT_NEAR(change.load_factor, 40.0 - 20.0 * distance, 0.1);
    }
    EXPECT_LE(trials, 5);
}

TEST(ClosureMeter, TriesElsewhereWhereATrialFails) {
    Case input = loaded();
    input.closure.distance = 0.2;
    const ClosureMeter meter(input.closure, {300.0}, input.cracks, {500.0});
    const auto fails_about_35 = [&](double target) {
        if (std::abs(target - 35.0) < 0.5) return ClosureMeter::Trial{};
        return ClosureMeter::Trial{with_reach(meter, target < 37.3 ? 1.0 : -1.0), target};
    };
    const auto changes = meter.locate({30.0, 30.0, {1.0}}, {40.0, 40.0, {-1.0}}, {0.2, fails_about_35});
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_NEAR(changes[0].load_factor, 37.3, 0.2);
}

// A load that is as far off as the increment is long is none.
TEST(ClosureMeter, GivesNoLoadWhereNoTrialSucceeds) {
    const ClosureMeter meter(loaded().closure, {300.0}, loaded().cracks, {500.0});
    const auto fails = [](double) { return ClosureMeter::Trial{}; };
    const auto changes = meter.locate({30.0, 30.0, {1.0}}, {40.0, 40.0, {-1.0}}, {0.1, fails});
    ASSERT_EQ(changes.size(), 1U);
    EXPECT_TRUE(std::isnan(changes[0].load_factor));
    const auto fails_near = [&](double target) {
        if (target > 36.0 && target < 39.0) return ClosureMeter::Trial{};
        return ClosureMeter::Trial{with_reach(meter, target < 37.3 ? 1.0 : -1.0), target};
    };
    const auto near = meter.locate({30.0, 30.0, {1.0}}, {40.0, 40.0, {-1.0}}, {0.1, fails_near});
    ASSERT_EQ(near.size(), 1U);
    EXPECT_TRUE(std::isnan(near[0].load_factor));
}

}  // namespace
}  // namespace stria::coarse
