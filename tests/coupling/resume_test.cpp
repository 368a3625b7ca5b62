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
#include "tests/support/specimens.hpp"
#include "tests/support/stopped_runs.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

/// A part of an analysis; where it was stopped, what it left.
struct Part {
    std::vector<double> K_at_start, K_at_end;  // largest K_I of the history, for the cracks there are
    std::vector<Followed> increments;
    std::optional<coarse::AnalysisState> left;
};

/// After an increment: when its load has been reached, or before the next equilibrium is looked for, be it that of
/// cracks which have grown.
enum class Stop : std::uint8_t { Reached, InGrowth };

Part run_part(const Case& input, coarse::EquilibriumFactory& factory, const coarse::AnalysisState* from, int stop,
              Stop where) {
    use_one_thread();
    const coarse::Scene scene = coarse::refined_scene(input);
    Part part;
    coarse::Listener listener;
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure&) {
        part.increments.push_back({increment, increment.equilibrium->structure_displacement()});
    };
    const auto is_before = [&] { return part.increments.empty() || part.increments.back().number < stop; };
    if (where == Stop::Reached) listener.reached = [&](const coarse::LoadStep&) { return is_before(); };
    if (where == Stop::InGrowth) listener.goes_on = is_before;
    coarse::FatigueAnalysis analysis(scene, factory, listener, from);
    part.K_at_start = analysis.largest_K();
    analysis.run();
    part.K_at_end = analysis.largest_K();
    if (!analysis.finished()) part.left = analysis.state();
    return part;
}

/// By one fine rank or several in this process, or in one matrix (0).
Part run_by(int ranks, const Case& input, const coarse::AnalysisState* from = nullptr,
            int stop = std::numeric_limits<int>::max(), Stop where = Stop::Reached) {
    if (ranks == 0) {
        MonolithicFactory factory(input);
        return run_part(input, factory, from, stop, where);
    }
    FineSide fine(input, ranks);
    coarse::CondensedFactory factory(&fine.scale(), input);
    return run_part(input, factory, from, stop, where);
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
    const Case input = sent_case(stopped::followed.settings);
    const Part first = run_by(1, input, nullptr, stopped::followed.stop);
    const coarse::AnalysisState state = through_a_file(input, first.left.value());
    const Part rest = run_by(1, input, &state, stopped::followed.stop + 1);
    EXPECT_GT(first.K_at_end.at(0), 1.01 * first.K_at_start.at(0));
    EXPECT_EQ(rest.K_at_start, first.K_at_end);
}

/// A pressed crack whose faces slide, in a body of which nothing may yield; it grows while they do.
Case sliding_in_elastic_metal() {
    Case input = specimen("plate", 40.0, {{13.03, 13.37}, {23.03, 23.37}});
    input.mesh.width = 40.0;
    input.cracks[0].contact = ContactSection{.friction = 0.3};
    input.boundaries = {at_end("top", End::Pulled, -1.0), at_end("bottom", End::Pulled, 1.0)};
    input.load = {.steps = 4, .blocks = {{.cycles = 2, .max = 100.0, .min = 0.0}}};
    input.solver.tolerance = 1e-11;
    input.growth = GrowthSection{.increment = 0.5, .direction = GrowthDirection::Straight};
    return input;
}

// Between the two acts of a growth functions have been let go, and faces slide on from where these had them.
TEST(ResumedGrowth, OfAnElasticBodyKnowsHowFarItsFacesHaveSlid) {
    const Case input = sliding_in_elastic_metal();
    for (const int ranks : {1, 2, 0}) {
        const Part one = run_by(ranks, input);
        const auto release =
            std::ranges::find_if(one.increments, [](const Followed& now) { return now.step.releases; });
        ASSERT_NE(release, one.increments.end());
        const coarse::AnalysisState state =
            through_a_file(input, run_by(ranks, input, nullptr, release->number - 1, Stop::InGrowth).left.value());
        ASSERT_EQ(state.release.held, 1.0);
        const Part rest = run_by(ranks, input, &state);
        ASSERT_EQ(rest.increments.at(0).number, release->number);
        EXPECT_EQ(rest.increments[0].displacement, release->displacement) << ranks;
        EXPECT_EQ(bits_of(rest.increments[0].zone), bits_of(release->zone)) << ranks;
        EXPECT_EQ(rest.increments.back().displacement, one.increments.back().displacement) << ranks;
    }
}

INSTANTIATE_TEST_SUITE_P(Scene, Resume,
                         testing::Values(stopped::still, stopped::again, stopped::sliding, stopped::sliding_growing,
                                         stopped::extended, stopped::growing, stopped::slotted, stopped::small,
                                         stopped::within, stopped::followed, stopped::halved, stopped::displaced,
                                         stopped::displaced_beside, stopped::displaced_by_stress, stopped::elastic,
                                         stopped::layered, stopped::loaded, stopped::lengthened),
                         testing::PrintToStringParamName());

class ResumeInOneMatrix : public Resume {};

TEST_P(ResumeInOneMatrix, ChangesNoBit) { expect_same_bits(0); }

TEST_P(ResumeInOneMatrix, IsTheSameToRounding) { expect_same_to_rounding(1, 0); }

TEST_P(ResumeInOneMatrix, OutOfItIsTheSameToRounding) { expect_same_to_rounding(0, 1); }

INSTANTIATE_TEST_SUITE_P(Scene, ResumeInOneMatrix, testing::Values(stopped::small, stopped::displaced_by_stress),
                         testing::PrintToStringParamName());

class ResumeSharedZone : public Resume {};

TEST_P(ResumeSharedZone, ChangesNoBitWithAsManyRanks) { expect_same_bits(2); }

TEST_P(ResumeSharedZone, WithAnotherNumberOfRanksIsTheSameToRounding) {
    expect_same_to_rounding(1, 2);
    expect_same_to_rounding(2, 1);
    expect_same_to_rounding(2, 3);
}

INSTANTIATE_TEST_SUITE_P(Scene, ResumeSharedZone,
                         testing::Values(stopped::still, stopped::extended, stopped::growing, stopped::slotted,
                                         stopped::followed, stopped::sliding_growing, stopped::layered,
                                         stopped::loaded),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace stria::test
