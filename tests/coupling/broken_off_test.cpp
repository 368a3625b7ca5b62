// Runs that end before their end: where nobody waits any more, and where the geometry of a longer crack leaves the zone
// without an equilibrium.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include "app/results/run_files.hpp"
#include "app/run/coarse_run.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/results/checkpoint.hpp"
#include "common/error.hpp"
#include "common/io/number_table.hpp"
#include "tests/support/deadline.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

/// Of an analysis that is not to go on once so many equilibria have been looked for.
struct BrokenOff {
    std::size_t attempts = 0, increments = 0;
    int times = 0;
    bool finished = true;
};

BrokenOff broken_off(const Case& input, std::size_t patience) {
    const Deadline deadline(std::chrono::seconds(20));
    BrokenOff seen;
    coarse::Listener listener;
    listener.attempted = [&](const coarse::LoadStep&, const coarse::NewtonReport&) { ++seen.attempts; };
    listener.accepted = [&](const coarse::Increment&, const coarse::Structure&) { ++seen.increments; };
    listener.goes_on = [&] { return seen.attempts < patience; };
    listener.breaks_off = [&] { ++seen.times; };
    const coarse::Scene scene = coarse::refined_scene(input);
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    coarse::FatigueAnalysis analysis(scene, factory, listener);
    analysis.run();
    seen.finished = analysis.finished();
    return seen;
}

const std::vector<std::string> short_scene{mesh_at_tip(0.6), "mesh.size=12.5", "load.steps=6",
                                           "load.blocks=[{cycles=2, max=50.0, ratio=-1.0}]", "growth.increment=0.8"};

TEST(BrokenOff, BetweenTwoHalvingsOfAnIncrement) {
    Case input = sent_case(short_scene);
    input.load.steps = 2;  // flows at once
    input.solver.max_iterations = 1;
    input.solver.max_cuts = 40;
    const BrokenOff seen = broken_off(input, 5);
    EXPECT_EQ(seen.attempts, 5U);
    EXPECT_EQ(seen.times, 1);
    EXPECT_FALSE(seen.finished);
}

TEST(BrokenOff, BeforeTheNewFacesAreReleased) {
    const Case input = sent_case(short_scene);
    const RunHistory whole = run_direct(input);
    std::size_t before_release = 0;
    while (whole.attempts.at(before_release).first.cycle < 1 || !whole.attempts[before_release].first.ends_cycle)
        ++before_release;
    const BrokenOff seen = broken_off(input, before_release + 1);
    EXPECT_EQ(seen.attempts, before_release + 1);
    EXPECT_EQ(seen.times, 1);
    EXPECT_FALSE(seen.finished);
}

/// Its zone cannot take the small elements that a longer crack wants.
class WithoutSmallerElements : public coarse::CondensedFactory {
public:
    using CondensedFactory::CondensedFactory;
    void extend_zone(const coupling::Patch& patch) override {
        if (!patch.part_of.empty()) throw NumericalFailure("the tangent of the zone is singular");
        CondensedFactory::extend_zone(patch);
    }
};

const std::vector<std::string> scene_that_splits{
    "mesh.grading=[]",      "mesh.size=7.4",      "fine.refine=8",
    "fine.radius=1.0",      "load.steps=6",       "load.blocks=[{cycles=5, max=50.0, ratio=-1.0}]",
    "growth.increment=0.6", "output.fields=none", "output.checkpoint_every=0"};

/// Its zone cannot grow without the cracks.
template <class Error> class WithoutALargerZone : public coarse::CondensedFactory {
public:
    using CondensedFactory::CondensedFactory;
    std::unique_ptr<coarse::Equilibrium> make(const coarse::Structure& structure, const coupling::Patch* patch,
                                              const Eigen::VectorXd& committed,
                                              const coarse::LoadFactors& factors) override {
        if (factors.main > 41.0) throw Error("no room");
        return CondensedFactory::make(structure, patch, committed, factors);
    }
};

const std::vector<std::string> scene_that_spreads{
    mesh_at_tip(0.4),
    "mesh.size=12.5",
    "load.steps=12",
    "fine.radius=0.5",
    "output.fields=none",
    "output.checkpoint_every=0",
    "load.blocks=[{cycles=1, max=40, ratio=-1}, {cycles=1, max=60, ratio=0}]"};

/// What it says where it fails.
template <class Factory>
std::string run_of(const std::string& folder, bool resume,
                   const std::vector<std::string>& settings = scene_that_splits) {
    const Case input = sent_case(settings);
    RunOptions options;
    options.case_path = shipped_sent;
    options.output_directory = folder;
    options.quiet = true;
    options.resume = resume;
    std::filesystem::create_directory(folder);
    fine::FineModel fine(input);
    Factory factory(&fine, input);
    try {
        CoarseRun(options, input, {RunMode::InProcess, 1, false}).perform(factory, nullptr);
    } catch (const std::runtime_error& failure) {
        return failure.what();
    }
    return "";
}

TEST(BrokenOff, InTheMiddleOfAGrowthSaysSoAndLeavesASummary) {
    const TemporaryFolder folder;
    const std::string said = run_of<WithoutSmallerElements>(folder / "out", false);
    EXPECT_NE(said.find("the cracks cannot grow: the tangent of the zone is singular; "), std::string::npos) << said;
    const auto summary = read_json(folder / "out/summary.json");
    EXPECT_EQ(summary.words.at("status"), "failed");
    EXPECT_GT(summary.numbers.at("coarse_unknowns"), 0.0);
    EXPECT_GT(summary.numbers.at("fine_points"), 0.0);
}

// The growth is what a resumed run does first: fails in the same words, or goes on as if nothing had been.
TEST(BrokenOff, InTheMiddleOfAGrowthLeavesTheStateBeforeIt) {
    const TemporaryFolder folder;
    const std::string said = run_of<WithoutSmallerElements>(folder / "out", false);
    const std::string rows = text_of(folder / "out/history.csv");
    const double last = read_table(folder / "out/history.csv")["increment"].back();
    EXPECT_TRUE(said.ends_with(fmt::format("after increment {}", last))) << said;
    EXPECT_EQ(run_of<WithoutSmallerElements>(folder / "out", true), said);
    EXPECT_EQ(text_of(folder / "out/history.csv"), rows);
    EXPECT_EQ(run_of<coarse::CondensedFactory>(folder / "out", true), "");
    EXPECT_EQ(run_of<coarse::CondensedFactory>(folder / "whole", false), "");
    EXPECT_EQ(text_of(folder / "out/history.csv"), text_of(folder / "whole/history.csv"));
    EXPECT_EQ(text_of(folder / "out/faces.csv"), text_of(folder / "whole/faces.csv"));
}

// The increments since the last checkpoint are kept, whatever the larger zone lacks.
template <class Error> class BrokenOffFor : public testing::Test {};
using LacksOfAZone = testing::Types<NumericalFailure, CaseError>;
TYPED_TEST_SUITE(BrokenOffFor, LacksOfAZone);

TYPED_TEST(BrokenOffFor, ALargerZoneLeavesTheStateBeforeIt) {
    const TemporaryFolder folder;
    const std::string said = run_of<WithoutALargerZone<TypeParam>>(folder / "out", false, scene_that_spreads);
    EXPECT_NE(said.find("no room"), std::string::npos) << said;
    const double last = read_table(folder / "out/history.csv")["increment"].back();
    ASSERT_TRUE(coarse::has_checkpoint(folder / "out"));
    EXPECT_EQ(coarse::read_checkpoint(folder / "out/checkpoint.h5").analysis.counts.increments, last);
    const std::string rows = text_of(folder / "out/history.csv");
    const auto whole_run = [&](const std::string& name, bool resume) {
        EXPECT_EQ(run_of<coarse::CondensedFactory>(folder / name, resume, scene_that_spreads), "");
        return text_of(folder / (name + "/history.csv"));
    };
    const std::string resumed = whole_run("out", true);
    EXPECT_TRUE(resumed.starts_with(rows));
    EXPECT_EQ(last, 17);
    EXPECT_EQ(resumed, whole_run("whole", false));
}

}  // namespace
}  // namespace stria::test
