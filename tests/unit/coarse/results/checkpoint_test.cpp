// checkpoint.h5: what is written comes back, what is damaged is refused with a sentence.
#include "coarse/results/checkpoint.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "common/error.hpp"
#include "common/geometry/vec2.hpp"
#include "coupling/transport/wire.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::coarse {
namespace {

using test::refusal_of;
using test::TemporaryFolder;

Checkpoint some_checkpoint() {
    Checkpoint checkpoint;
    checkpoint.mark = {"young = 1.0\n", {{.cycles = 3, .max = 50.0, .min = -50.0}}, 0.1, 2, 1, 1ULL << 63U};
    AnalysisState& state = checkpoint.analysis;
    state.load.cases = Eigen::Vector2d(0.25, -0.0);
    state.cracks = {{{0.0, 20.25}, {100.0, 1.0 / 3.0}}};
    state.in_zone = ElementSet::of_flags({0, 1, 1});
    state.still = {.far = ElementSet::of_flags({1, 0, 0}), .middle = ElementSet::of_flags({0, 1, 0})};
    state.still_of_nominal = {.far = ElementSet::of_flags({1, 0, 0}),
                              .middle = ElementSet::of_flags({0, 0, 0}),
                              .behind = ElementSet::of_flags({0, 0, 1})};
    state.nominal = {{.a = 7.0, .K_I = 0.1, .CMOD = -0.0}};
    state.displacement = Eigen::Vector3d(1e-300, -0.0, 0.1);
    state.closure = {.signal = {1.5},
                     .nearest = {{.behind = 0.25, .pressure = 40.0, .excess = -3.5, .closed = 7, .sliding = 2}, {}},
                     .largest = {9.5},
                     .opened = {.loads = {2.5, 2.25, 2.0}, .rates = {-4.5, -5.5}},
                     .closed = {.loads = {3.5, 3.25, 3.0}, .rates = {-6.5, -7.5}}};
    state.counts.increments = 57;
    state.growth.ended = true;
    state.growth.increment = {.increment = 0.07, .points = {{.a = 10.0, .per_mm = 3e5, .closure = 0.25}, {.a = 10.1}}};
    state.growth.rates.life = {.uncounted = 0.02, .rate_at_turn = 1e-4};
    state.growth.rates.at_turn = {1.5e-6, 0.0};
    state.growth.rates.owed = {0.0, -0.02};
    state.growth.rates.last = 0.25;
    state.growth.K_reached = {{.of_break = 610.5, .K_I = 600.0}, {}};
    state.growth.before = {{20.5, 590.25}, {0.0, 0.0}};
    state.growth.turns_late = true;
    state.growth.turning = {.minimum = {{1.0, 2.0}}, .cycles = {{3.0, 4.0}, {1.0, 2.0}}};
    state.growth.extremes = {.maximum = {50.0, Eigen::Vector2d(0.5, -0.5)}, .minimum = {-5.0}, .tips = {{.a = 20.5}}};
    state.growth.extremes.faces = tractions_of({{.crack = 1, .s = 0.5, .pressure = 7.0, .in_wake = true}});
    state.growth.extremes.tips_at_minimum = {{.a = 20.25}};
    state.growth.extremes.faces_at_minimum = tractions_of({{.crack = 1, .s = 0.5, .pressure = 9.0}});
    state.growth.rates.period = {.sum = {1.0}, .cycles = 2, .grown = {3.0}, .before = {4.0}};
    state.load.reached = -1.0 / 3.0;
    state.load.taken = {{2, 0.0, 5.0, Eigen::Vector2d(0.0, 1.0), state.load.cases}, {2, 5.0, 10.0}};
    state.equilibrium.increments = {Vec2(1.0, 2.0), Vec2(3.0, 4.0)};
    state.equilibrium.load_increments = {0.5, 0.25};
    state.zone.weighed_cost = 12.5;
    state.zone.element = {4, 9};
    state.zone.history = {0.1, 0.2};
    state.zone.increments = {Vec2(-1.0, 0.0)};
    state.zone.multipliers = {{.crack = 1,
                               .place = {1.0, 2.0},
                               .pressure = 3.0,
                               .shear = -0.5,
                               .status = 3,
                               .widened = -1.5,
                               .slid = 0.5,
                               .until_met = 0.75,
                               .settled_slip = -0.375,
                               .increments = {0.5},
                               .shear_increments = {0.25}}};
    state.zone.frozen_tips = {{.mesh = {}, .displacement = Vec2(1.0, 2.0), .crack = 1}};
    checkpoint.recorder.history_rows = 58;
    checkpoint.recorder.fields = {{10, 10.0}, {30, 30.0}};
    state.cycle.tips.resize(1);
    state.cycle.tips[0].signal.resize(2);
    state.cycle.tips[0].signal[1].rest.K_op = 7.0;
    state.cycle.tips[0].up = {{1.0}, {3.0}, {2.0}};
    state.cycle.last = {
        {.unit_K = 1.0, .K = -0.0, .CMOD = 3.0, .load_factor = 4.0, .zone = 5.0, .zone_axis = 6.0, .rose = true}};
    state.last_cycle.resize(1);
    return checkpoint;
}

TEST(Checkpoint, ComesBackBitForBit) {
    const TemporaryFolder folder;
    const Checkpoint in = some_checkpoint();
    write_checkpoint(folder / "checkpoint.h5", in);
    const Checkpoint out = read_checkpoint(folder / "checkpoint.h5");
    EXPECT_EQ(out.mark.text, in.mark.text);
    EXPECT_EQ(out.mark.blocks, in.mark.blocks);
    EXPECT_EQ(out.mark.legs_before, in.mark.legs_before);
    EXPECT_EQ(out.mark.mesh, in.mark.mesh);
    EXPECT_EQ(out.analysis.load.cases, in.analysis.load.cases);
    EXPECT_EQ(out.analysis.load.taken.at(0).cases_to, in.analysis.load.taken[0].cases_to);
    EXPECT_EQ(out.analysis.cracks.at(0).y, in.analysis.cracks[0].y);
    EXPECT_EQ(out.analysis.in_zone, in.analysis.in_zone);
    EXPECT_EQ(out.analysis.still, in.analysis.still);
    EXPECT_EQ(out.analysis.still_of_nominal, in.analysis.still_of_nominal);
    EXPECT_EQ(out.analysis.nominal.at(0).K_I, in.analysis.nominal[0].K_I);
    EXPECT_TRUE(std::signbit(out.analysis.nominal[0].CMOD));
    EXPECT_EQ(out.analysis.displacement, in.analysis.displacement);
    EXPECT_TRUE(std::signbit(out.analysis.displacement[1]));
    EXPECT_EQ(out.analysis.closure.signal, in.analysis.closure.signal);
    EXPECT_EQ(out.analysis.closure.nearest, in.analysis.closure.nearest);
    EXPECT_EQ(out.analysis.closure.largest, in.analysis.closure.largest);
    EXPECT_EQ(out.analysis.closure.opened.loads, in.analysis.closure.opened.loads);
    EXPECT_EQ(out.analysis.closure.opened.rates, in.analysis.closure.opened.rates);
    EXPECT_EQ(out.analysis.closure.closed.loads, in.analysis.closure.closed.loads);
    EXPECT_EQ(out.analysis.closure.closed.rates, in.analysis.closure.closed.rates);
    EXPECT_EQ(out.analysis.counts.increments, 57);
    EXPECT_TRUE(out.analysis.growth.ended);
    EXPECT_EQ(out.analysis.growth.increment.increment, 0.07);
    ASSERT_EQ(out.analysis.growth.increment.points.size(), 2U);
    EXPECT_EQ(out.analysis.growth.increment.points[0].closure, 0.25);
    EXPECT_EQ(out.analysis.growth.increment.points[0].per_mm, 3e5);
    EXPECT_EQ(out.analysis.growth.rates.life.uncounted, 0.02);
    EXPECT_EQ(out.analysis.growth.rates.life.rate_at_turn, 1e-4);
    EXPECT_EQ(out.analysis.growth.rates.at_turn, in.analysis.growth.rates.at_turn);
    EXPECT_EQ(out.analysis.growth.rates.owed, in.analysis.growth.rates.owed);
    EXPECT_EQ(out.analysis.growth.rates.last, in.analysis.growth.rates.last);
    EXPECT_EQ(out.analysis.growth.K_reached, in.analysis.growth.K_reached);
    ASSERT_EQ(out.analysis.growth.before.size(), 2U);
    EXPECT_EQ(out.analysis.growth.before[0].a, 20.5);
    EXPECT_EQ(out.analysis.growth.before[0].K, 590.25);
    EXPECT_EQ(out.analysis.growth.turning.minimum, in.analysis.growth.turning.minimum);
    EXPECT_EQ(out.analysis.growth.turning.cycles, in.analysis.growth.turning.cycles);
    EXPECT_TRUE(out.analysis.growth.turns_late);
    EXPECT_EQ(out.analysis.growth.extremes.maximum.main, 50.0);
    EXPECT_EQ(out.analysis.growth.extremes.maximum.cases, in.analysis.growth.extremes.maximum.cases);
    EXPECT_EQ(out.analysis.growth.extremes.minimum.main, -5.0);
    EXPECT_EQ(out.analysis.growth.extremes.tips.at(0).a, 20.5);
    EXPECT_EQ(out.analysis.growth.extremes.tips_at_minimum.at(0).a, 20.25);
    EXPECT_EQ(out.analysis.growth.extremes.faces_at_minimum.at(1, 0.5).pressure, 9.0);
    EXPECT_EQ(out.analysis.growth.extremes.faces.at(1, 0.5).pressure, 7.0);
    EXPECT_EQ(out.analysis.growth.extremes.faces.in_wake.at(0), 1);
    EXPECT_EQ(out.analysis.growth.rates.period.cycles, 2);
    EXPECT_EQ(out.analysis.growth.rates.period.before.at(0), 4.0);
    EXPECT_EQ(out.analysis.zone.weighed_cost, 12.5);
    EXPECT_EQ(out.analysis.load.reached, in.analysis.load.reached);
    EXPECT_EQ(out.analysis.load.taken.at(1).from, 5.0);
    EXPECT_EQ(out.analysis.equilibrium.increments, in.analysis.equilibrium.increments);
    EXPECT_EQ(out.analysis.equilibrium.load_increments, in.analysis.equilibrium.load_increments);
    EXPECT_EQ(coupling::pack(out.analysis.zone), coupling::pack(in.analysis.zone));
    EXPECT_EQ(out.recorder.history_rows, 58U);
    EXPECT_EQ(out.recorder.fields.at(1).time, 30.0);
    EXPECT_TRUE(std::isnan(out.analysis.cycle.tips.at(0).signal.at(1).found.K_op));
    EXPECT_EQ(out.analysis.cycle.tips[0].signal[1].rest.K_op, 7.0);
    EXPECT_EQ(out.analysis.cycle.tips[0].up.opening, in.analysis.cycle.tips[0].up.opening);
    EXPECT_EQ(out.analysis.cycle.tips[0].up.force, in.analysis.cycle.tips[0].up.force);
    EXPECT_EQ(out.analysis.cycle.last.at(0).zone_axis, 6.0);
    EXPECT_TRUE(out.analysis.cycle.last[0].rose);
    EXPECT_EQ(out.analysis.last_cycle.at(0).dN, 1.0);
}

TEST(Checkpoint, IsRefusedWhereItIsDamaged) {
    const TemporaryFolder folder;
    const std::string path = folder / "checkpoint.h5";
    write_checkpoint(path, some_checkpoint());
    const auto whole = std::filesystem::file_size(path);
    for (const auto size : {whole - 1, whole / 2, whole / 10, whole - whole}) {
        std::filesystem::resize_file(path, size);
        EXPECT_NE(refusal_of([&] { (void)read_checkpoint(path); }).find("checkpoint.h5: cannot go on"),
                  std::string::npos)
            << size;
    }
    std::ofstream(path) << "no HDF5 at all";
    EXPECT_THROW((void)read_checkpoint(path), CaseError);
    EXPECT_THROW((void)read_checkpoint(folder / "nothing"), CaseError);
}

TEST(Checkpoint, IsRefusedWithOneBitThatIsAnother) {
    const TemporaryFolder folder;
    const std::string path = folder / "checkpoint.h5";
    write_checkpoint(path, some_checkpoint());
    const std::string whole = test::text_of(path);
    for (std::size_t k = 0; k < 160; ++k) {
        std::string damaged = whole;
        damaged[k * whole.size() / 160] ^= static_cast<char>(1 << (k % 8));
        std::ofstream(path, std::ios::binary) << damaged;
        EXPECT_NE(refusal_of([&] { (void)read_checkpoint(path); }).find("is damaged"), std::string::npos) << k;
    }
}

TEST(Checkpoint, LeavesTheOneBefore) {
    const TemporaryFolder folder;
    const std::string path = folder / "checkpoint.h5";
    Checkpoint checkpoint = some_checkpoint();
    write_checkpoint(path, checkpoint);
    EXPECT_FALSE(std::filesystem::exists(previous_checkpoint(path)));
    checkpoint.analysis.counts.increments = 58;
    write_checkpoint(path, checkpoint);
    EXPECT_EQ(read_checkpoint(path).analysis.counts.increments, 58);
    EXPECT_EQ(previous_checkpoint(path), folder / "checkpoint.previous.h5");
    EXPECT_EQ(read_checkpoint(previous_checkpoint(path)).analysis.counts.increments, 57);
}

TEST(Checkpoint, ForgetsExtremesOfACycleThatIsNoLongerTheLast) {
    OutputSection output{.faces = Written::Extremes, .fields = Written::Cycles};
    Checkpoint checkpoint = some_checkpoint();
    checkpoint.recorder.face_rows = 9;
    CaseMark longer = checkpoint.mark;
    forget_former_end(checkpoint, longer, output);
    EXPECT_EQ(checkpoint.recorder.face_rows, 9U);
    longer.repeat += 1;
    forget_former_end(checkpoint, longer, output);
    EXPECT_EQ(checkpoint.recorder.face_rows, 0U);
    EXPECT_EQ(checkpoint.recorder.fields.size(), 2U);
    output.fields = Written::Extremes;
    forget_former_end(checkpoint, longer, output);
    EXPECT_TRUE(checkpoint.recorder.fields.empty());
}

LoadStep step_of(int cycle, bool ends_cycle) {
    LoadStep step;
    step.cycle = cycle;
    step.reversal = true;
    step.ends_cycle = ends_cycle;
    return step;
}

TEST(CheckpointIsDue, AtTheFirstReversalAndAfterSoManyCycles) {
    const LoadStep reversal = step_of(1, false), fourth = step_of(4, true);
    EXPECT_TRUE(checkpoint_is_due(3, reversal, {}));
    EXPECT_FALSE(checkpoint_is_due(3, reversal, {.has_one = true}));
    EXPECT_FALSE(checkpoint_is_due(3, fourth, {.has_one = true}));
    EXPECT_TRUE(checkpoint_is_due(2, fourth, {.has_one = true, .seconds = 9.0, .of_the_run_s = 10.0}));
    EXPECT_FALSE(checkpoint_is_due(0, reversal, {}));
}

TEST(CheckpointIsDue, AsLongAsItTakesATwentiethOfTheTimeWhereNobodySaysHowOften) {
    const LoadStep tenth = step_of(10, true), eleventh = step_of(11, true);
    EXPECT_TRUE(checkpoint_is_due({}, tenth, {.has_one = true, .seconds = 0.4, .of_the_run_s = 10.0}));
    EXPECT_FALSE(checkpoint_is_due({}, tenth, {.has_one = true, .seconds = 0.6, .of_the_run_s = 10.0}));
    EXPECT_FALSE(checkpoint_is_due({}, eleventh, {.has_one = true, .seconds = 0.0, .of_the_run_s = 10.0}));
    EXPECT_TRUE(checkpoint_is_due({}, step_of(1, false), {.has_one = false, .seconds = 0.6, .of_the_run_s = 1.0}));
}

}  // namespace
}  // namespace stria::coarse
