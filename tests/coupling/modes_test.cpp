// One analysis, three compositions: direct and over a transport bit for bit, monolithic to 1e-9 (docs/method.md,
// section 11).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <map>
#include <semaphore>

#include "app/run/fine_side.hpp"
#include "app/run/monolithic/monolithic.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coupling/transport/memory_transport.hpp"
#include "coupling/transport/remote_fine_scale.hpp"
#include "coupling/transport/serve.hpp"
#include "tests/coupling/scenes_of_modes.hpp"
#include "tests/support/deadline.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

struct SettingsOfCase {
    const char* name;
    std::vector<std::string> settings;
};

/// An end at which nobody computes but in turn: the serial OpenBLAS of tools/packages.txt is no library for two threads
/// of one process, and a zone may change while the structure is busy.
class InTurn : public coupling::Transport {
public:
    /// `begins`: has the turn first.
    InTurn(coupling::Transport& end, std::binary_semaphore& turn, bool begins) : end_(end), turn_(turn) {
        if (begins) take();
    }
    ~InTurn() override { give(); }

    void send(coupling::Tag tag, std::vector<std::byte> bytes) override { end_.send(tag, std::move(bytes)); }
    coupling::Message receive() override {
        give();
        coupling::Message message = end_.receive();
        take();
        return message;
    }

private:
    void take() {
        turn_.acquire();
        mine_ = true;
    }
    void give() {
        if (std::exchange(mine_, false)) turn_.release();
    }

    coupling::Transport& end_;
    std::binary_semaphore& turn_;
    bool mine_ = false;
};

RunHistory run_over_memory(const Case& input) {
    auto [coarse_end, fine_end] = coupling::make_memory_transports();
    std::binary_semaphore turn(1);
    auto server = std::async(std::launch::async, [&input, &turn, end = std::move(fine_end)] {
        fine::FineModel model(input);
        InTurn transport(*end, turn, false);
        coupling::serve(transport, model, digest(input));
    });
    RunHistory history;
    {
        InTurn transport(*coarse_end, turn, true);
        coupling::RemoteFineScale remote(transport, digest(input));
        coarse::CondensedFactory factory(&remote, input);
        history = run_analysis(input, factory);
    }
    server.get();
    return history;
}

class Modes : public testing::TestWithParam<SettingsOfCase> {
protected:
    [[nodiscard]] static Case input() { return sent_case(GetParam().settings); }

    void SetUp() override {
        std::unique_ptr<RunHistory>& known = histories_[GetParam().name];
        if (!known) known = std::make_unique<RunHistory>(run_direct(input()));
        direct = known.get();
    }

    const RunHistory* direct = nullptr;

private:
    inline static std::map<std::string, std::unique_ptr<RunHistory>> histories_;
    const Deadline deadline_{std::chrono::seconds(120)};
};

/// Zero where another metal is too close: nothing equals a NaN.
double J_of(const coarse::TipResult& tip) { return std::isnan(tip.J) ? 0.0 : tip.J; }

std::vector<double> numbers_of(const coarse::TipResult& tip) {
    return {tip.a,        tip.K_I,  tip.K_II, tip.K_I_of_wake,    tip.K_II_of_wake, J_of(tip),
            tip.T_stress, tip.CTOD, tip.CMOD, tip.contact_length, tip.plastic_zone, tip.plastic_zone_axis};
}

std::vector<double> numbers_of(const coupling::StepReport& report) {
    std::vector<double> numbers{report.dissipation,
                                report.energy.stored,
                                report.energy.released,
                                report.energy.friction,
                                static_cast<double>(report.unknowns),
                                static_cast<double>(report.multipliers)};
    for (const coupling::TipReport& tip : report.tips) {
        numbers.push_back(tip.CTOD);
        for (const auto* shells : {&tip.flow, &tip.flow_ever})
            for (const coupling::FlowShell& shell : *shells)
                numbers.insert(numbers.end(), {shell.begin, shell.end, shell.reach, shell.axis});
    }
    for (const coupling::RingReport& ring : report.rings) {
        const DomainIntegral& sums = ring.sums;
        numbers.insert(numbers.end(),
                       {sums.J, sums.interaction_I, sums.interaction_II, sums.interaction_T, sums.area, sums.rotation});
    }
    for (const coupling::FaceSample& face : report.faces) {
        numbers.insert(numbers.end(), {face.s, face.x, face.y, face.opening, face.slip, face.pressure, face.shear,
                                       static_cast<double>(face.status)});
    }
    numbers.insert(numbers.end(), report.contact_length.begin(), report.contact_length.end());
    numbers.insert(numbers.end(), report.mouth_opening.begin(), report.mouth_opening.end());
    return numbers;
}

TEST_P(Modes, SceneFlowsAndCloses) {
    EXPECT_GT(direct->increments.back().work.dissipated, 0.1);
    EXPECT_GT(direct->at_minimum().zone.contact_length[0], 15.0);
    EXPECT_EQ(direct->at_maximum().zone.contact_length[0], 0.0);
    EXPECT_EQ(direct->cuts, 0);
}

TEST_P(Modes, FrontsAreGeneralWhereFacesSlide) {
    const bool slides = GetParam().name == std::string("sliding");
    const Followed& last = direct->increments.back();
    EXPECT_EQ(last.zone.work.fronts_general > 0, slides);
    EXPECT_EQ(last.work.by_friction > 0.0, slides);
    EXPECT_LT(last.zone.work.fronts_general, last.zone.work.fronts_refactored);
    const auto sliding = [](const coupling::FaceSample& face) { return face.status == 2; };
    EXPECT_EQ(std::ranges::any_of(direct->at_minimum().zone.faces, sliding), slides);
}

TEST_P(Modes, OverATransportEveryBitIsTheSame) {
    const RunHistory remote = run_over_memory(input());
    ASSERT_EQ(remote.increments.size(), direct->increments.size());
    for (std::size_t k = 0; k < remote.increments.size(); ++k) {
        const Followed &a = direct->increments[k], &b = remote.increments[k];
        EXPECT_EQ(a.newton.table(), b.newton.table());
        EXPECT_EQ(a.displacement, b.displacement);
        EXPECT_EQ(a.machine.displacement, b.machine.displacement);
        EXPECT_EQ(a.machine.force, b.machine.force);
        EXPECT_EQ(numbers_of(a.tips[0]), numbers_of(b.tips[0]));
        EXPECT_EQ(numbers_of(a.zone), numbers_of(b.zone));
    }
}

TEST_P(Modes, MonolithicIsTheSameToRounding) {
    MonolithicFactory factory(input());
    const RunHistory whole = run_analysis(input(), factory);
    ASSERT_EQ(whole.increments.size(), direct->increments.size());
    const coarse::TipResult& scale = direct->at_maximum().tips[0];
    std::int64_t rested = 0;
    for (std::size_t k = 0; k < whole.increments.size(); ++k) {
        const Followed &a = direct->increments[k], &b = whole.increments[k];
        const coarse::TipResult &p = a.tips[0], &q = b.tips[0];
        // What rests joins the iterations when it is woken; one matrix knows no rest.
        if (std::exchange(rested, a.zone.work.points_at_rest) == a.zone.work.points_at_rest) {
            EXPECT_EQ(a.newton.count(), b.newton.count()) << "increment " << k + 1;
        }
        EXPECT_NEAR(J_of(p), J_of(q), 1e-9 * J_of(scale));
        EXPECT_NEAR(p.K_I, q.K_I, 1e-9 * scale.K_I);
        EXPECT_NEAR(p.K_II, q.K_II, 1e-9 * scale.K_I);  // zero by symmetry
        EXPECT_NEAR(p.CMOD, q.CMOD, 1e-9 * scale.CMOD);
        EXPECT_NEAR(p.CTOD, q.CTOD, 1e-9 * scale.CTOD);
        EXPECT_NEAR(a.zone.contact_length[0], b.zone.contact_length[0], 1e-9 * 20.0);
        EXPECT_NEAR(a.work.dissipated, b.work.dissipated, 1e-9 * direct->increments.back().work.dissipated);
        EXPECT_NEAR(a.work.stored, b.work.stored, 1e-9 * direct->increments.back().work.external);
        EXPECT_LT((a.displacement - b.displacement).lpNorm<Eigen::Infinity>(),
                  1e-9 * a.displacement.lpNorm<Eigen::Infinity>());
    }
}

/// What does not depend on how many share the work: by column, the scale of its errors beside the two values.
void expect_same_to_rounding(const RunHistory& one, const RunHistory& other) {
    ASSERT_EQ(other.increments.size(), one.increments.size());
    const coarse::TipResult& scale = one.at_maximum().tips[0];
    const double work = one.increments.back().work.dissipated;
    for (std::size_t k = 0; k < one.increments.size(); ++k) {
        const Followed &a = one.increments[k], &b = other.increments[k];
        const coarse::TipResult &p = a.tips[0], &q = b.tips[0];
        EXPECT_NEAR(J_of(p), J_of(q), 1e-9 * J_of(scale)) << "increment " << k + 1;
        EXPECT_NEAR(p.K_I, q.K_I, 1e-9 * scale.K_I);
        EXPECT_NEAR(p.K_II, q.K_II, 1e-9 * scale.K_I);
        EXPECT_NEAR(p.CMOD, q.CMOD, 1e-9 * scale.CMOD);
        EXPECT_NEAR(p.CTOD, q.CTOD, 1e-9 * scale.CTOD);
        EXPECT_NEAR(p.contact_length, q.contact_length, 1e-9 * 20.0);
        EXPECT_NEAR(p.plastic_zone, q.plastic_zone, 1e-9 * 20.0);
        EXPECT_NEAR(a.work.dissipated, b.work.dissipated, 1e-9 * work);
        EXPECT_NEAR(a.zone.energy.released, b.zone.energy.released, 1e-9 * work);
        EXPECT_NEAR(a.work.by_friction, b.work.by_friction, 1e-9 * work);
        EXPECT_NEAR(a.work.error(), b.work.error(), 1e-9 * one.increments.back().work.external);
        for (std::size_t t = 0; t < a.cycles.size(); ++t) {
            const double K = a.cycles[t].opening.K_op, L = b.cycles[t].opening.K_op;
            EXPECT_TRUE((std::isnan(K) && std::isnan(L)) || std::abs(K - L) < 1e-9 * scale.K_I) << K << ' ' << L;
        }
        EXPECT_EQ(a.zone.points, b.zone.points);
        EXPECT_EQ(a.zone.unknowns, b.zone.unknowns);
        EXPECT_LT((a.displacement - b.displacement).lpNorm<Eigen::Infinity>(),
                  1e-9 * a.displacement.lpNorm<Eigen::Infinity>());
    }
}

class SharedZone : public Modes {};

TEST_P(SharedZone, SeveralFineRanksAreOneToRounding) {
    for (const int ranks : {2, 3, 4}) {
        const Case scene = input();
        FineSide fine(scene, ranks);
        coarse::CondensedFactory factory(&fine.scale(), scene);
        expect_same_to_rounding(*direct, run_analysis(scene, factory));
        for (const coupling::StepReport& rank : fine.reports({})) EXPECT_GT(rank.points, 0) << ranks << " ranks";
    }
}

// Gaps at rest that are not closed when they come to rest: growth turns back, and moves a bend to before its tip.
TEST(MovedBend, StoresAtItsTipWhatOneMatrixDoes) {
    const Case scene = sent_case(
        {"model.plane='stress'", "mesh={specimen='plate', width=10.0, height=20.0, size=0.9091}",
         "material.yield_stress=300.94058", "material.isotropic={law='power', n=3.881, alpha=0.2551}",
         "material.kinematic=[{C=17568.0, gamma=372.4}, {C=8762.4, gamma=277.9}]",
         "crack=[{points=[[0.0, 9.41428], [3.09399, 9.35474], [4.59399, 9.68432]], contact={friction=0.0}}]",
         "boundary=[{on='point', at=[8.86521, 17.1253], force=[0.0, 6.0]}, {on='point', at=[8.86521, 2.00797], "
         "force=[0.0, -6.0]}]",
         "load.steps=4", "load.blocks=[{cycles=2, max=50.0212, ratio=0.3}]", "fine.radius=1.953", "fine.beta=2.0",
         "growth.increment=0.21", "solver.tolerance=1e-12"});
    const RunHistory direct = run_direct(scene);
    MonolithicFactory factory(scene);
    const RunHistory whole = run_analysis(scene, factory);
    ASSERT_EQ(direct.increments.size(), 12U);
    EXPECT_GT(direct.increments.back().zone.work.points_at_rest, 0);
    for (std::size_t k = 0; k < whole.increments.size(); ++k)
        EXPECT_NEAR(direct.increments[k].work.stored, whole.increments[k].work.stored,
                    1e-9 * whole.increments[k].work.stored)
            << "increment " << k + 1;
}

/// Increments to predict from go along with a tip across a seam: without them two ranks take a third more iterations.
/// What rests hangs on the tree of fronts, and joins the iterations when it is woken: while faces open with one rank
/// all look at it in each iterate, or they take a twentieth more.
TEST(GrowthOnTwoRanks, TakesAsManyIterationsAsOnOne) {
    const Case scene =
        sent_case({"mesh.grading=[]", "mesh.size=3.2", "fine.refine=32", "load.steps=\"auto\"", "growth.increment=0.1",
                   "load.blocks=[{cycles=3, max=50.0, ratio=0.0}]", "fine.beta=1.0"});
    const auto iterations = [&](int ranks) {
        FineSide fine(scene, ranks);
        coarse::CondensedFactory factory(&fine.scale(), scene);
        int sum = 0;
        for (const auto& [step, report] : run_analysis(scene, factory).attempts) sum += report.count();
        return sum;
    };
    const int one = iterations(1);
    EXPECT_LE(iterations(2), 1.02 * one) << one;
}

INSTANTIATE_TEST_SUITE_P(
    Sceneries, Modes,
    testing::Values(SettingsOfCase{"graded", small_scene}, SettingsOfCase{"refined", refined_scene},
                    SettingsOfCase{"growing", growing_scene}, SettingsOfCase{"following", following_scene},
                    SettingsOfCase{"sliding", sliding_scene}, SettingsOfCase{"layered", layered_scene},
                    SettingsOfCase{"loaded", loaded_scene}, SettingsOfCase{"whole", whole_scene}),
    [](const auto& scenery) { return std::string(scenery.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Sceneries, SharedZone,
    testing::Values(SettingsOfCase{"graded", small_scene}, SettingsOfCase{"refined", refined_scene},
                    SettingsOfCase{"extended", extended_scene}, SettingsOfCase{"growing", growing_scene},
                    SettingsOfCase{"following", following_scene}, SettingsOfCase{"sliding", sliding_scene},
                    SettingsOfCase{"layered", layered_scene}, SettingsOfCase{"loaded", loaded_scene}),
    [](const auto& scenery) { return std::string(scenery.param.name); });

TEST_P(SharedZone, ExtendsWhereItsSceneSays) {
    const std::string name = GetParam().name;
    EXPECT_EQ(direct->extensions > 0, name == "extended" || name == "loaded");  // a wheel presses beyond the zone, too
}

TEST_P(SharedZone, SplitsElementsWhereItsSceneSays) {
    EXPECT_EQ(direct->mesh_splits > 0, std::string(GetParam().name) == "following");
}

}  // namespace
}  // namespace stria::test
