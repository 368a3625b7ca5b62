// An increment in which faces open or close is tried in parts, and then made as it was. Where Newton's method does not
// get there again it is halved like any other.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "common/error.hpp"
#include "tests/support/fails_sometimes.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

struct Tried {
    int again = -1;  // the first attempt that makes an increment again after its parts
    int increments = 0, cuts = 0;
    std::vector<double> K_op;  // of each cycle
};

/// `failing`: the number of the attempt that fails, if any.
Tried run(int failing) {
    const Case input = sent_case({mesh_at_tip(0.4), "load.steps=12", "model.plane=stress", "growth.increment=0.4",
                                  "load.blocks=[{cycles=3, max=40.0, ratio=0.0}]"});
    use_one_thread();
    const coarse::Scene scene = coarse::refined_scene(input);
    FailsSometimes fine(input);
    coarse::CondensedFactory factory(&fine, input);
    Tried found;
    int attempts = 0;
    std::vector<double> targets;  // of the attempts of this increment
    coarse::Listener listener;
    listener.attempted = [&](const coarse::LoadStep& step, const coarse::NewtonReport&) {
        const double target = step.target.value;
        if (found.again < 0 && targets.size() > 1 && target == targets.front() && targets.back() != target)
            found.again = attempts;
        targets.push_back(target);
        fine.fails = ++attempts == failing;
    };
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure&) {
        targets.clear();
        ++found.increments;
        for (const coarse::CycleResult& cycle : increment.cycles)
            found.K_op.push_back(cycle.opening.K_op / cycle.K_max);
    };
    coarse::FatigueAnalysis analysis(scene, factory, listener);
    analysis.run();
    found.cuts = analysis.cuts();
    return found;
}

TEST(ClosureRetry, AnIncrementThatDoesNotConvergeAgainIsHalved) {
    const Tried undisturbed = run(-1);
    ASSERT_GT(undisturbed.again, 0);
    EXPECT_EQ(undisturbed.cuts, 0);
    const Tried disturbed = run(undisturbed.again);
    EXPECT_EQ(disturbed.cuts, 1);
    EXPECT_EQ(disturbed.increments, undisturbed.increments + 1);
    ASSERT_EQ(disturbed.K_op.size(), undisturbed.K_op.size());
    for (std::size_t k = 0; k < disturbed.K_op.size(); ++k) EXPECT_NEAR(disturbed.K_op[k], undisturbed.K_op[k], 0.01);
}

/// What a run says in its end that grows by dK_eff, its crack closed at the minimum; `only_at`: where equilibria are
/// found. Adds up the load factors of its increments.
std::string end_of_growth(const std::vector<double>& only_at, std::vector<double>& accepted, int& broken_off) {
    const Case input = sent_case({mesh_at_tip(0.4), "load.steps=12", "load.blocks=[{cycles=2, max=40.0, ratio=-1.0}]",
                                  "growth={law=\"paris\", increment=0.4, C=1e-13, m=3.0, driving=\"dK_eff\"}"});
    use_one_thread();
    const coarse::Scene scene = coarse::refined_scene(input);
    FailsSometimes fine(input);
    fine.only_at = only_at;
    coarse::CondensedFactory factory(&fine, input);
    coarse::Listener listener;
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure&) {
        accepted.push_back(increment.load_factor);
    };
    listener.breaks_off = [&] { ++broken_off; };
    coarse::FatigueAnalysis analysis(scene, factory, listener);
    return refusal_of<NumericalFailure>([&] { analysis.run(); });
}

TEST(ClosureRetry, AnOpeningLoadThatNoTrialTellsDrivesNoGrowth) {
    std::vector<double> loads, reached;
    int broken_off = 0;
    EXPECT_EQ(end_of_growth({}, loads, broken_off), "accepted");
    EXPECT_EQ(broken_off, 0);
    const std::string said = end_of_growth(loads, reached, broken_off);
    EXPECT_NE(said.find("cycle 1: the cracks cannot grow: K_op drives the growth, and no equilibrium of the last cycle "
                        "tells it for tip 0"),
              std::string::npos)
        << said;
    EXPECT_EQ(reached.size(), 18U);  // ramp and one cycle
    EXPECT_EQ(broken_off, 1);
}

}  // namespace
}  // namespace stria::test
