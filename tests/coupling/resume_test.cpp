// An analysis that is stopped between two increments, written to a file and taken up again by other objects: the same
// bits as if it had not been; the same numbers by another number of ranks and in one matrix.
#include <gtest/gtest.h>

#include <fmt/format.h>
#include <iostream>
#include <limits>
#include <map>
#include <optional>

#include "app/run/fine_side.hpp"
#include "app/run/monolithic/monolithic.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/results/checkpoint.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "coupling/transport/wire.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

struct StoppedRun {
    const char* name;
    std::vector<std::string> settings;
    int stop;  // increment after which the analysis is stopped
    void (*change)(Case&) = [](Case&) {};

    friend std::ostream& operator<<(std::ostream& out, const StoppedRun& run) { return out << run.name; }
};

/// Flow and contact; stopped while the faces close.
const StoppedRun still{"Still", {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=16", "solver.tolerance=1e-12"}, 13};

/// Its second cycle, which is predicted from the first.
const StoppedRun again{"Again",
                       {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=16", "solver.tolerance=1e-12",
                        "load.blocks=[{cycles=2, max=50.0, ratio=-1.0}]"},
                       30};

/// A zone that has been extended, and is once more where the load rises beyond what it was.
const StoppedRun extended{"Extended",
                          {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=12", "solver.tolerance=1e-12",
                           "fine.radius=0.5",
                           "load.blocks=[{cycles=1, max=40, ratio=-1}, {cycles=1, max=60, ratio=0}]"},
                          14};

/// A crack that has grown through elements and grows again, with a tip function that freezes.
const StoppedRun growing{"Growing",
                         {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=12", "solver.tolerance=1e-12",
                          "fine.enrichment=single", "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]",
                          "growth.increment=0.3"},
                         27};

/// A slot inside: growth at its first end leaves the slot behind, and before it are new faces.
const StoppedRun slotted{"Slotted",
                         {"mesh.grading=[{at=[[15.0,100.0],[25.0,100.0]],size=0.6,outer_size=1.2,radius=3.0}]",
                          "mesh.size=12.5", "load.steps=6", "solver.tolerance=1e-12",
                          "crack.0.points=[[15.0,100.03],[25.0,100.03]]", "crack.0.notch=10.0",
                          "load.blocks=[{cycles=4, max=80.0, ratio=-1.0}]", "growth.increment=0.4"},
                         20};

/// The same in fewer and larger elements and increments: one matrix takes its time.
const StoppedRun small{"Small",
                       {mesh_at_tip(0.6), "mesh.size=12.5", "load.steps=6", "solver.tolerance=1e-12",
                        "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]", "growth.increment=0.4"},
                       13};

/// Within a zone that holds its way for now: the whole run keeps its structure's factor, what resumes makes it anew.
const StoppedRun within{"Within",
                        {"mesh.grading=[]", "mesh.size=7.4", "fine.refine=8", "fine.growth=0.25", "load.steps=6",
                         "load.blocks=[{cycles=4, max=50.0, ratio=-1.0}]", "growth.increment=0.2"},
                        20};

/// Small elements follow the tip: some have been split before the stop, and others are after it.
const StoppedRun followed{"Followed",
                          {"mesh.grading=[]", "mesh.size=7.4", "fine.refine=8", "fine.radius=1.0", "load.steps=6",
                           "solver.tolerance=1e-12", "load.blocks=[{cycles=5, max=50.0, ratio=-1.0}]",
                           "growth.increment=0.6"},
                          20};

/// An inclined crack whose faces slide against friction; stopped while they do, and while K_slip is measured.
const StoppedRun sliding{"Sliding",
                         {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=16", "solver.tolerance=1e-12",
                          "closure.profile=[1.0]", "crack.0.points=[[0.0, 88.0], [20.0, 100.0]]",
                          "crack.0.contact.friction=0.3", "load.blocks=[{cycles=2, max=50.0, ratio=-1.0}]"},
                         31};

/// The same crack while it grows: what has slid is on functions that the next tip freezes.
const StoppedRun sliding_growing{"SlidingGrowing",
                                 {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=12", "solver.tolerance=1e-12",
                                  "closure.profile=[1.0]", "crack.0.points=[[0.0, 80.0], [20.0, 100.0]]",
                                  "crack.0.contact.friction=0.3", "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]",
                                  "growth.increment=0.3"},
                                 27};

/// Flow in two metals and a strip that never yields; the crack grows out of the one into the other.
const StoppedRun layered{
    "Layered",
    {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=12", "solver.tolerance=1e-12",
     "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]", "growth.increment=0.3",
     "region=[{outline=[[20.4,0.0],[23.0,200.0]], material={young=120e3, poisson=0.34, yield_stress=150.0, "
     "kinematic=[{C=5e3, gamma=30.0}]}, initial_stress={yy=20.0}}, {outline=[[23.0,0.0],[50.0,200.0]], "
     "material={young=300e3, poisson=0.2}}]",
     "initial_stress={sigma_y={at=[0.0,12.5,25.0,37.5,50.0], stress=[20.0,0.0,-20.0,0.0,20.0]}}"},
    27};

/// Under a dead load, a shear behind the tension and a wheel that rolls over the side, while the crack grows.
const StoppedRun loaded{"Loaded",
                        {mesh_at_tip(0.6), "mesh.size=12.5", "load.steps=6", "solver.tolerance=1e-12",
                         "load.blocks=[{cycles=3, max=35.0, ratio=-1.0}]", "growth.increment=0.4",
                         "load_case=[{name='dead', constant=15.0}, {name='shear', factor=0.3, phase=90.0}]",
                         "boundary=[{on='top', traction=[0.0,1.0]}, {on='top', traction=[0.0,1.0], case='dead'}, "
                         "{on='bottom', displacement=[0.0,0.0]}, {on='top', traction=[1.0,0.0], case='shear'}, "
                         "{on='left', origin=[0.0,100.0], travelling={p0=40.0, half_width=3.0, from=-12.0, to=12.0}}]"},
                        13};

/// Half way of an increment that was halved.
const StoppedRun halved{
    "Halved",
    {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=4", "solver.tolerance=1e-6", "solver.max_iterations=5"},
    6};

/// Where the load factor is found.
const StoppedRun displaced{"Displaced",
                           {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=8", "solver.tolerance=1e-12",
                            "load.control=displacement", "load.blocks=[{cycles=2, max=0.06, ratio=-1.0}]"},
                           14};

/// Likewise beside a dead load, stopped where that has come on: the displacement goes on from where the boundary is.
const StoppedRun displaced_beside{
    "DisplacedBesideADeadLoad",
    {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=8", "solver.tolerance=1e-12", "load.control=displacement",
     "load.blocks=[{cycles=1, max=0.06, ratio=-1.0}]", "load_case=[{name='dead', constant=25.0}]",
     "boundary=[{on='top', traction=[0.0,1.0]}, {on='top', traction=[0.0,1.0], case='dead'}, "
     "{on='bottom', displacement=[0.0,0.0]}]"},
    4};

/// Likewise on the way from where an initial stress has moved the boundary to a first displacement of zero.
const StoppedRun displaced_by_stress{"DisplacedByAnInitialStress",
                                     {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=8", "solver.tolerance=1e-12",
                                      "load.control=displacement", "load.blocks=[{cycles=1, max=0.0, min=-0.02}]",
                                      "initial_stress={sigma_y={at=[0.0,25.0,50.0], stress=[100.0,-100.0,100.0]}}"},
                                     3};

/// No zone at all.
const StoppedRun elastic{"Elastic",
                         {mesh_at_tip(0.4), "mesh.size=12.5", "load.steps=4",
                          "load.blocks=[{cycles=3, max=50.0, ratio=0.0}]", "growth.increment=0.4"},
                         9,
                         [](Case& input) {
                             input.material.yield_stress.reset();
                             input.material.kinematic.clear();
                             input.cracks[0].contact.reset();
                         }};

/// A tip that opens as the load falls: no opening behind it is known before it has grown, and then all the increments
/// of the half cycle that begins are chosen by it.
const StoppedRun lengthened{"Lengthened",
                            {"mesh.grading=[{at=[[2.0,100.0]],size=0.2,outer_size=0.8,radius=2.0}]", "mesh.size=12.5",
                             "load.steps=auto", "crack.0.points=[[0.0,100.0],[2.0,100.0]]", "closure.distance=2.1",
                             "growth.increment=0.2", "load.blocks=[{cycles=2, max=100.0, min=-120.0}]",
                             "boundary=[{on='top', traction=[0.0,-1.0]}, {on='bottom', displacement=[0.0,0.0]}]"},
                            19};

/// A part of an analysis; where it was stopped, what it left.
struct Part {
    std::vector<double> K_at_start, K_at_end;  // largest K_I of the history, for the cracks there are
    std::vector<Followed> increments;
    std::optional<coarse::AnalysisState> left;
};

Part run_part(const Case& input, coarse::EquilibriumFactory& factory, const coarse::AnalysisState* from = nullptr,
              int stop = std::numeric_limits<int>::max()) {
    use_one_thread();
    const coarse::Scene scene = coarse::refined_scene(input);
    Part part;
    coarse::Listener listener;
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure&) {
        part.increments.push_back({increment, increment.equilibrium->structure_displacement()});
    };
    listener.reached = [&](const coarse::LoadStep&) { return part.increments.back().number < stop; };
    coarse::FatigueAnalysis analysis(scene, factory, listener, from);
    part.K_at_start = analysis.largest_K();
    analysis.run();
    part.K_at_end = analysis.largest_K();
    if (!analysis.finished()) part.left = analysis.state();
    return part;
}

/// By one fine rank or several in this process, or in one matrix (0).
Part run_by(int ranks, const Case& input, const coarse::AnalysisState* from = nullptr,
            int stop = std::numeric_limits<int>::max()) {
    if (ranks == 0) {
        MonolithicFactory factory(input);
        return run_part(input, factory, from, stop);
    }
    FineSide fine(input, ranks);
    coarse::CondensedFactory factory(&fine.scale(), input);
    return run_part(input, factory, from, stop);
}

coarse::AnalysisState through_a_file(const Case& input, const coarse::AnalysisState& state) {
    const TemporaryFolder folder;
    coarse::write_checkpoint(folder / "checkpoint.h5",
                             {coarse::mark_of(coarse::refined_scene(input)), state, coarse::RecorderState(), {}});
    return coarse::read_checkpoint(folder / "checkpoint.h5").analysis;
}

/// Without what only says how the work was done.
std::vector<std::byte> bits_of(coupling::StepReport report) {
    report.work = {};
    report.constitutive_s = report.contact_s = report.factor_s = 0.0;
    return coupling::pack(report);
}

class Resume : public testing::TestWithParam<StoppedRun> {
protected:
    [[nodiscard]] static Case input() {
        Case input = sent_case(GetParam().settings);
        GetParam().change(input);
        return input;
    }

    static const Part& whole(int ranks) {
        auto& known = wholes_[{GetParam().name, ranks}];
        if (!known) known = run_by(ranks, input());
        return *known;
    }
    static const coarse::AnalysisState& left(int ranks) {
        auto& known = lefts_[{GetParam().name, ranks}];
        if (!known) known = through_a_file(input(), run_by(ranks, input(), nullptr, GetParam().stop).left.value());
        return *known;
    }

    static void expect_same_bits(int ranks) {
        const Part &one = whole(ranks), rest = run_by(ranks, input(), &left(ranks));
        const std::size_t before = one.increments.size() - rest.increments.size();
        ASSERT_EQ(rest.increments.front().number, one.increments.at(before).number);
        for (std::size_t k = 0; k < rest.increments.size(); ++k) {
            const Followed &a = one.increments[before + k], &b = rest.increments[k];
            EXPECT_EQ(b.newton.table(), a.newton.table()) << "increment " << a.number;
            EXPECT_EQ(b.displacement, a.displacement) << "increment " << a.number;
            EXPECT_EQ(b.machine.force, a.machine.force);
            EXPECT_EQ(bits_of(b.zone), bits_of(a.zone)) << "increment " << a.number;
            EXPECT_EQ(b.signal, a.signal);
            EXPECT_EQ(b.work.at_start, a.work.at_start) << "increment " << a.number;
            for (std::size_t t = 0; t < a.cycles.size(); ++t) {
                EXPECT_EQ(b.cycles.at(t).K_max, a.cycles[t].K_max);
                EXPECT_EQ(b.cycles[t].K_initial, a.cycles[t].K_initial);
                EXPECT_EQ(slip_text(b.cycles.at(t).K_slip), slip_text(a.cycles[t].K_slip));
                EXPECT_EQ(slip_text(b.cycles[t].K_slip_unloading), slip_text(a.cycles[t].K_slip_unloading));
            }
        }
    }

    static std::string slip_text(const std::vector<double>& K_slip) { return fmt::to_string(fmt::join(K_slip, " ")); }

    static void expect_same_to_rounding(int before, int after) {
        const Part &one = whole(before), rest = run_by(after, input(), &left(before));
        const std::size_t first = one.increments.size() - rest.increments.size();
        double largest = 0.0;
        for (std::size_t k = 0; k < rest.increments.size(); ++k) {
            const Followed &a = one.increments.at(first + k), &b = rest.increments[k];
            ASSERT_EQ(b.number, a.number);
            const double difference =
                (b.displacement - a.displacement).lpNorm<Eigen::Infinity>() / a.displacement.lpNorm<Eigen::Infinity>();
            largest = std::max(largest, difference);
            EXPECT_LT(difference, 1e-9) << "increment " << a.number;
            EXPECT_NEAR(b.tips[0].CTOD, a.tips[0].CTOD, 1e-9 * one.increments.back().tips[0].CTOD);
            EXPECT_NEAR(b.zone.contact_length[0], a.zone.contact_length[0], 1e-9 * 20.0);
            EXPECT_NEAR(b.work.dissipated, a.work.dissipated, 1e-9 * one.increments.back().work.dissipated);
            EXPECT_EQ(b.zone.unknowns, a.zone.unknowns);
            for (std::size_t t = 0; t < a.cycles.size(); ++t) expect_near(b.cycles[t], a.cycles[t]);
        }
        const auto name = [](int ranks) { return ranks > 0 ? fmt::format("{} fine", ranks) : "one matrix"; };
        std::cout << fmt::format("{}, begun by {}, ended by {}: displacements differ by {:.1e}\n", GetParam().name,
                                 name(before), name(after), largest);
    }

    /// K_slip as precisely as it is found.
    static void expect_near(const coarse::CycleResult& one, const coarse::CycleResult& other) {
        ASSERT_EQ(one.K_slip.size(), other.K_slip.size());
        for (std::size_t k = 0; k < one.K_slip.size(); ++k) {
            EXPECT_EQ(std::isnan(one.K_slip[k]), std::isnan(other.K_slip[k]));
            if (!std::isnan(one.K_slip[k])) {
                EXPECT_NEAR(one.K_slip[k], other.K_slip[k], 0.005 * one.K_max);
            }
        }
    }

private:
    using Key = std::pair<std::string, int>;
    inline static std::map<Key, std::optional<Part>> wholes_;
    inline static std::map<Key, std::optional<coarse::AnalysisState>> lefts_;
};

TEST_P(Resume, StopsWhereItMatters) {
    const coarse::AnalysisState& state = left(1);
    EXPECT_GE(state.counts.increments, GetParam().stop);
    EXPECT_LT(state.counts.increments, whole(1).increments.back().number);
    const std::string name = GetParam().name;
    EXPECT_EQ(state.zone.points.empty(), name == "Elastic");
    if (name == "Halved") {
        EXPECT_EQ(state.load.cuts, 1);
        EXPECT_EQ(state.load.reached, 25.0);
    }
    if (name == "Still") {
        EXPECT_TRUE(std::ranges::any_of(state.zone.multipliers, [](const auto& m) { return m.status != 0; }));
    }
    if (name == "Extended") {
        EXPECT_GT(state.counts.zone_extensions, 0);
        EXPECT_NE(whole(1).increments.back().zone.points, whole(1).increments.at(14).zone.points);
    }
    if (name == "Sliding" || name == "SlidingGrowing") {
        EXPECT_TRUE(std::ranges::any_of(whole(1).increments, [](const Followed& now) {
            return now.step.ends_cycle && !now.cycles.empty() && !std::isnan(now.cycles[0].K_slip.at(1));
        }));
    }
    if (name == "Slotted") {
        EXPECT_GT(state.cracks.at(0).grown_at_start, 0.3);
    }
    if (name == "Lengthened") {
        EXPECT_TRUE(state.load.schedule.tells);
        EXPECT_EQ(state.load.increments, 0);
    }
    if (name == "Growing") {
        EXPECT_FALSE(state.zone.frozen_tips.empty());
    }
}

TEST_P(Resume, ChangesNoBit) { expect_same_bits(1); }

// Eq. (3), and with it what is split at the next growth.
TEST(ResumedCrack, HasTheLargestKOfItsLength) {
    const Case input = sent_case(followed.settings);
    const Part first = run_by(1, input, nullptr, followed.stop);
    const coarse::AnalysisState state = through_a_file(input, first.left.value());
    const Part rest = run_by(1, input, &state, followed.stop + 1);
    EXPECT_GT(first.K_at_end.at(0), 1.01 * first.K_at_start.at(0));
    EXPECT_EQ(rest.K_at_start, first.K_at_end);
}

INSTANTIATE_TEST_SUITE_P(Scene, Resume,
                         testing::Values(still, again, sliding, sliding_growing, extended, growing, slotted, small,
                                         within, followed, halved, displaced, displaced_beside, displaced_by_stress,
                                         elastic, layered, loaded, lengthened),
                         testing::PrintToStringParamName());

class ResumeInOneMatrix : public Resume {};

TEST_P(ResumeInOneMatrix, ChangesNoBit) { expect_same_bits(0); }

TEST_P(ResumeInOneMatrix, IsTheSameToRounding) { expect_same_to_rounding(1, 0); }

TEST_P(ResumeInOneMatrix, OutOfItIsTheSameToRounding) { expect_same_to_rounding(0, 1); }

INSTANTIATE_TEST_SUITE_P(Scene, ResumeInOneMatrix, testing::Values(small, displaced_by_stress),
                         testing::PrintToStringParamName());

class ResumeSharedZone : public Resume {};

TEST_P(ResumeSharedZone, ChangesNoBitWithAsManyRanks) { expect_same_bits(2); }

TEST_P(ResumeSharedZone, WithAnotherNumberOfRanksIsTheSameToRounding) {
    expect_same_to_rounding(1, 2);
    expect_same_to_rounding(2, 1);
    expect_same_to_rounding(2, 3);
}

INSTANTIATE_TEST_SUITE_P(Scene, ResumeSharedZone,
                         testing::Values(still, extended, growing, slotted, followed, sliding_growing, layered, loaded),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace stria::test
