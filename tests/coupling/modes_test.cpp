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
#include "tests/support/deadline.hpp"
#include "tests/support/program.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

/// Plastic flow in tension, contact in compression, 36 increments.
const std::vector<std::string> small_scene{mesh_at_tip(0.3), "mesh.size=10.0", "load.steps=12",
                                           "solver.tolerance=1e-12"};

/// The same on large elements that the zone splits; the crack runs through their middles, and from large into small.
const std::vector<std::string> refined_scene{"mesh.grading=[]", "mesh.size=7.4", "fine.refine=16", "fine.growth=0.25",
                                             "solver.tolerance=1e-12"};

/// The zone of the first, begun too small: new elements join while others have a history.
const std::vector<std::string> extended_scene{mesh_at_tip(0.3), "mesh.size=10.0", "fine.radius=1.0",
                                              "solver.tolerance=1e-12"};

/// The crack grows through elements and across their edges, at the maximum of two cycles.
const std::vector<std::string> growing_scene{mesh_at_tip(0.4),         "mesh.size=10.0",
                                             "solver.tolerance=1e-12", "load.blocks=[{cycles=2, max=50.0, ratio=-1.0}]",
                                             "load.steps=14",          "growth.increment=0.25"};

/// Small elements follow the tip of a crack that grows.
const std::vector<std::string> following_scene{"mesh.grading=[]",
                                               "mesh.size=7.4",
                                               "fine.refine=8",
                                               "fine.radius=1.0",
                                               "solver.tolerance=1e-12",
                                               "load.steps=6",
                                               "load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]",
                                               "growth.increment=0.6"};

/// An inclined crack whose faces slide against friction while they are closed.
const std::vector<std::string> sliding_scene{
    "mesh.grading=[{at=[[20.0,100.0]], size=0.3, outer_size=0.6, radius=3.0, growth=0.25}]",
    "mesh.size=10.0",
    "solver.tolerance=1e-12",
    "crack.0.points=[[0.0, 88.0], [20.0, 100.0]]",
    "crack.0.contact.friction=0.3",
    "load.steps=12",
    "load.blocks=[{cycles=1, max=50.0, ratio=-1.0}]"};

/// The ends are held, and nothing is left to the structure.
const std::vector<std::string> whole_scene{
    "mesh.grading=[]",
    "mesh.size=12.4",
    "fine.radius=300.0",
    "boundary=[{on=\"top\", displacement=[0.0, 1e-3]}, {on=\"bottom\", displacement=[0.0, 0.0]}]",
    "load.steps=12",
    "load.blocks=[{cycles=1, max=200.0, ratio=-1.0}]",
    "solver.tolerance=1e-12"};

/// The plastic zone reaches into a weaker metal ahead, and from there into a strip that never yields. The weaker one
/// has a misfit, and the plate a stress across it before any load.
const std::vector<std::string> layered_scene{
    mesh_at_tip(0.6),
    "mesh.size=10.0",
    "load.steps=12",
    "solver.tolerance=1e-12",
    "region=[{outline=[[21.0,0.0],[23.0,200.0]], initial_stress={yy=25.0, xx=10.0}, material={young=120e3, "
    "poisson=0.34, yield_stress=150.0, isotropic={law='voce', Q=80.0, b=20.0}, kinematic=[{C=5e3, gamma=30.0}]}}, "
    "{outline=[[23.0,0.0],[50.0,90.0],[50.0,200.0],[23.0,200.0]], material={young=300e3, poisson=0.2}}]",
    "initial_stress={sigma_y={at=[0.0,12.5,25.0,37.5,50.0], stress=[20.0,0.0,-20.0,0.0,20.0]}}"};

/// Under a dead load, a shear behind the tension, an end that a load case moves, and a wheel on the side of the zone
/// that rolls over the mouth of the crack.
const std::vector<std::string> loaded_scene{
    mesh_at_tip(0.6),
    "mesh.size=10.0",
    "load.steps=12",
    "solver.tolerance=1e-12",
    "fine.radius=30.0",
    "load.blocks=[{cycles=1, max=35.0, min=-75.0}]",
    "load_case=[{name='dead', constant=15.0}, {name='shear', factor=0.3, phase=90.0}, {name='moved', factor=1e-3}]",
    "boundary=[{on='top', traction=[0.0,1.0]}, {on='top', traction=[0.0,1.0], case='dead'}, "
    "{on='bottom', displacement=[0.0,0.0]}, {on='bottom', displacement=[0.0,-1.0], case='moved'}, "
    "{on='top', traction=[1.0,0.0], case='shear'}, {on='left', origin=[0.0,100.0], travelling={p0=40.0, "
    "half_width=3.0, friction=0.2, from=-12.0, to=12.0}}]"};

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
    return {tip.a,    tip.K_I,  tip.K_II,           J_of(tip),        tip.T_stress,
            tip.CTOD, tip.CMOD, tip.contact_length, tip.plastic_zone, tip.plastic_zone_axis};
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

/// history.csv by columns; empty cells are NaN.
std::map<std::string, std::vector<double>> columns_of(const std::string& text) {
    std::istringstream lines(text);
    std::string line, cell;
    std::getline(lines, line);
    std::vector<std::string> names;
    for (std::istringstream header(line); std::getline(header, cell, ',');) names.push_back(cell);
    std::map<std::string, std::vector<double>> columns;
    while (std::getline(lines, line)) {
        std::istringstream row(line);
        for (const std::string& name : names) {
            cell.clear();
            std::getline(row, cell, ',');
            columns[name].push_back(cell.empty() ? std::nan("") : std::stod(cell));
        }
    }
    return columns;
}

class Programs : public testing::Test {
protected:
    [[nodiscard]] std::string run(const std::string& mode, const std::string& ranks = "1",
                                  const std::vector<std::string>& scene = small_scene) const {
        std::vector<std::string> words{
            "run",   shipped_sent,          "--mode", mode, "--fine", ranks, "-o", folder_ / mode, "--quiet",
            "--set", "output.faces=\"all\""};
        for (const std::string& value : scene) words.insert(words.end(), {"--set", value});
        EXPECT_EQ(run_program("stria", words, folder_ / (mode + ".log")), 0) << text_of(folder_ / (mode + ".log"));
        return folder_ / mode;
    }

    void expect_same_tables(const std::string& one, const std::string& other) const {
        for (const char* file : {"/history.csv", "/faces.csv"}) {
            EXPECT_GT(text_of(one + file).size(), 1000U);
            EXPECT_TRUE(text_of(one + file) == text_of(other + file)) << file;
        }
    }
    TemporaryFolder folder_;
};

TEST_F(Programs, TwoProgramsAndOneLeaveTheSameBytes) { expect_same_tables(run("mpi"), run("inprocess")); }

TEST_F(Programs, ThreeProgramsAndOneLeaveTheSameBytes) { expect_same_tables(run("mpi", "3"), run("inprocess", "3")); }

TEST_F(Programs, TwoRanksGrowACrackAsInOneProgram) {
    expect_same_tables(run("mpi", "2", growing_scene), run("inprocess", "2", growing_scene));
}

TEST_F(Programs, TwoRanksSlideAsInOneProgram) {
    expect_same_tables(run("mpi", "2", sliding_scene), run("inprocess", "2", sliding_scene));
}

TEST_F(Programs, MonolithicLeavesTheSameColumnsToRounding) {
    const auto one = columns_of(text_of(run("inprocess") + "/history.csv"));
    const auto whole = columns_of(text_of(run("monolithic") + "/history.csv"));
    ASSERT_EQ(one.size(), whole.size());
    const auto largest = [](const std::vector<double>& values) {
        double size = 0.0;
        for (const double value : values) size = std::max(size, std::abs(value));
        return size;
    };
    for (const auto& [name, values] : one) {
        const std::vector<double>& other = whole.at(name);
        // Spreads are relative to what passes through zero: the difference between the rings is what has to agree.
        const std::string spread_of = name == "J_spread" ? "J" : name == "K_spread" ? "K_I" : "";
        // K_II is zero by symmetry, and the balance is what large numbers leave.
        const double size = largest(one.at(name == "K_II"            ? "K_I"
                                           : name == "balance_error" ? "external_work"
                                           : spread_of.empty()       ? name
                                                                     : spread_of));
        ASSERT_EQ(values.size(), other.size());
        for (std::size_t k = 0; k < values.size(); ++k) {
            const bool both_empty = std::isnan(values[k]) && std::isnan(other[k]);
            const double unit = spread_of.empty() ? 1.0 : std::abs(one.at(spread_of)[k]);
            EXPECT_TRUE(both_empty || unit * std::abs(values[k] - other[k]) <= 1e-9 * size) << name << ' ' << k + 1;
        }
    }
}

}  // namespace
}  // namespace stria::test
