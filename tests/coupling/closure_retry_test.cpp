// An increment in which faces open or close is tried in parts, and then made as it was. Where Newton's method does not
// get there again it is halved like any other.
#include <gtest/gtest.h>

#include <algorithm>

#include "common/error.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

/// Hands everything on to the fine component of a case, but for one failure.
class FailsOnce final : public coupling::FineScale {
public:
    explicit FailsOnce(const Case& input) : model_(input) {}

    void set_patch(const coupling::Patch& patch) override { model_.set_patch(patch); }
    void request(const coupling::PatchDisplacement& displacement) override { model_.request(displacement); }
    coupling::PatchResponse collect() override {
        coupling::PatchResponse response = model_.collect();
        if (fails) throw NumericalFailure("as asked for");
        return response;
    }
    coupling::StepReport commit(const coupling::Commit& what) override { return model_.commit(what); }
    void rollback() override { model_.rollback(); }
    coupling::ZoneState state() override { return model_.state(); }
    coupling::ZoneSnapshot snapshot() override { return model_.snapshot(); }
    void restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) override {
        model_.restore(patch, snapshot);
    }

    bool fails = false;

private:
    fine::FineModel model_;
};

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
    FailsOnce fine(input);
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

}  // namespace
}  // namespace stria::test
