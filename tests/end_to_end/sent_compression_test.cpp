// The paper's first example as shipped: an edge-cracked plate is pulled, then pushed until its crack closes.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "common/case/case_questions.hpp"
#include "common/index.hpp"
#include "common/io/number_table.hpp"
#include "tests/end_to_end/figures.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::test {
namespace {

constexpr double crack_length = 20.0, element = 0.1;  // mm, at the tip
constexpr double rounding_floor = 1e-12;              // of a relative residual
// At the largest load, with every element half as large (docs/verification/zone.md, zone radius and mesh).
constexpr double refined_J = 3.280235, refined_CMOD = 0.060711;  // N/mm, mm

/// A fine component that remembers its zone and what became of it.
class Witness final : public coupling::FineScale {
public:
    explicit Witness(const Case& input) : model_(input) {}
    void set_patch(const coupling::Patch& given) override {
        patch = given;
        model_.set_patch(given);
    }
    void request(const coupling::PatchDisplacement& displacement) override { model_.request(displacement); }
    coupling::PatchResponse collect() override { return last_ = model_.collect(); }
    coupling::StepReport commit(const coupling::Commit& what) override {
        coupling::StepReport report = model_.commit(what);
        statuses.push_back(last_.digest.status);
        displacements.push_back(model_.state().displacement);
        return report;
    }
    void rollback() override { model_.rollback(); }
    coupling::ZoneState state() override { return model_.state(); }
    coupling::ZoneSnapshot snapshot() override { return model_.snapshot(); }
    void restore(const coupling::Patch& given, const coupling::ZoneSnapshot& snapshot) override {
        patch = given;
        model_.restore(given, snapshot);
    }

    coupling::Patch patch;
    std::vector<std::vector<std::int8_t>> statuses;  // per increment and multiplier
    std::vector<Eigen::VectorXd> displacements;      // per increment, of the zone

private:
    coupling::PatchResponse last_;
    fine::FineModel model_;
};

void expect_shipped_table(const RunHistory& run) {
    const NumberTable table =
        read_table(std::filesystem::path(source_folder) / "cases/sent-compression/reference/history.csv");
    ASSERT_EQ(table.rows, run.increments.size());
    const auto compare = [&](const std::string& column, const auto& value) {
        const std::vector<double>& expected = table[column];
        const double scale = std::abs(*std::ranges::max_element(expected, {}, [](double x) { return std::abs(x); }));
        for (std::size_t k = 0; k < expected.size(); ++k)
            EXPECT_NEAR(value(run.increments[k]), expected[k], 1e-6 * scale) << column << ", increment " << k + 1;
    };
    const auto tip = [](auto member) {
        return [member](const coarse::Increment& increment) { return increment.tips[0].*member; };
    };
    compare("load_factor", [](const coarse::Increment& increment) { return increment.load_factor; });
    compare("K_I", tip(&coarse::TipResult::K_I));
    compare("J", tip(&coarse::TipResult::J));
    compare("CMOD", tip(&coarse::TipResult::CMOD));
    compare("CTOD", tip(&coarse::TipResult::CTOD));
    compare("plastic_zone", tip(&coarse::TipResult::plastic_zone));
    compare("contact_length", [](const coarse::Increment& increment) { return increment.zone.contact_length[0]; });
    compare("dissipation", [](const coarse::Increment& increment) { return increment.work.dissipated; });
    compare("external_work", [](const coarse::Increment& increment) { return increment.work.external; });
}

/// To the digits that it gives.
void expect_figures_of_readme(const RunHistory& run) {
    const auto readme = [](const std::string& row) { return figures_of("sent-compression", row).at(0); };
    const coarse::Increment &most = run.at_maximum(), &least = run.at_minimum();
    EXPECT_EQ(most.number, 20);
    EXPECT_EQ(least.number, 40);
    EXPECT_NEAR(most.tips[0].J, readme("J | largest load, increment 20"), 0.00006);
    EXPECT_NEAR(most.tips[0].CMOD, readme("CMOD | largest load"), 0.000006);
    EXPECT_NEAR(most.tips[0].plastic_zone, readme("farthest point that flowed, from the tip | largest load"), 0.0006);
    EXPECT_NEAR(least.zone.faces.front().pressure, readme("contact pressure nearest the mouth | smallest load"), 0.006);
    const auto edge = std::ranges::find(least.zone.faces, 0.0, &coupling::FaceSample::pressure);
    EXPECT_NEAR(std::prev(edge)->s, readme("contact edge | smallest load, increment 40"), 0.006);
    EXPECT_NEAR(run.increments.back().tips[0].J, readme("J | largest load again, increment 60"), 0.00006);
}

class SentCompression : public testing::Test {
protected:
    static void SetUpTestSuite() {
        input = std::make_unique<Case>(sent_case({"solver.tolerance=1e-8"}));  // so that several ratios lie above it
        witness = std::make_unique<Witness>(*input);
        coarse::CondensedFactory factory(witness.get(), *input);
        run = std::make_unique<RunHistory>(run_analysis(*input, factory));
    }
    static void TearDownTestSuite() {
        run.reset();
        witness.reset();
        input.reset();
    }

    inline static std::unique_ptr<Case> input;
    inline static std::unique_ptr<Witness> witness;
    inline static std::unique_ptr<RunHistory> run;
};

TEST_F(SentCompression, ConvergesWithoutCuttingAStep) {
    EXPECT_EQ(run->cuts, 0);
    EXPECT_EQ(run->extensions, 0);
    EXPECT_EQ(run->yield_warnings, 0);
    EXPECT_EQ(run->increments.size(), 60U);
    for (const coarse::Increment& increment : run->increments) EXPECT_LE(increment.newton.count(), 12);
}

TEST_F(SentCompression, EnergyReleaseAndMouthOpeningAtMaximumLoad) {
    const coarse::TipResult& tip = run->at_maximum().tips[0];
    const double E = 200e3 / (1.0 - 0.09);
    EXPECT_NEAR(run->nominal[0].K_I * 50.0, 842.0, 0.01 * 842.0);  // handbook
    EXPECT_GT(tip.J, tip.K_I * tip.K_I / E * 0.98);
    EXPECT_NEAR(tip.J, refined_J, 0.002 * refined_J);
    EXPECT_NEAR(tip.CMOD, refined_CMOD, 0.002 * refined_CMOD);
    EXPECT_GT(tip.CTOD, 0.0);
}

TEST_F(SentCompression, LeavesTheTableAndTheFiguresThatAreShippedWithIt) {
    expect_shipped_table(*run);
    expect_figures_of_readme(*run);
}

// The faces meet as they parted: nothing slides, so friction changes nothing, and no front is general for it.
TEST_F(SentCompression, FrictionChangesNothingOfASymmetricCrack) {
    const Case rough = sent_case({"crack.0.contact.friction=0.3", "solver.tolerance=1e-8"});
    const RunHistory with_friction = run_direct(rough);
    ASSERT_EQ(with_friction.increments.size(), run->increments.size());
    const double scale = run->at_maximum().tips[0].J;
    int iterations = 0, more = 0;
    for (std::size_t k = 0; k < run->increments.size(); ++k) {
        const Followed &smooth = run->increments[k], &now = with_friction.increments[k];
        EXPECT_NEAR(now.tips[0].J, smooth.tips[0].J, 1e-8 * scale) << k + 1;
        iterations += smooth.newton.count();
        more += now.newton.count() - smooth.newton.count();
    }
    EXPECT_LE(more, iterations / 50);
    const Followed& last = with_friction.increments.back();
    EXPECT_EQ(last.zone.work.fronts_general, 0);
    EXPECT_LT(last.work.by_friction, 1e-12 * last.work.external);
    for (const coupling::FaceSample& face : with_friction.at_minimum().zone.faces) EXPECT_NE(face.status, 2);
}

TEST_F(SentCompression, AtMinimumLoadOpenAtTheTipAndClosedBehind) {
    const coarse::Increment& least = run->at_minimum();
    EXPECT_GT(least.zone.contact_length[0], 0.9 * crack_length);
    EXPECT_LT(least.zone.contact_length[0], crack_length - 2.0 * element);
    bool open = false;  // from the first open station on to the tip all are open
    for (const coupling::FaceSample& face : least.zone.faces) {
        open = open || face.pressure == 0.0;
        EXPECT_TRUE(!open || face.pressure == 0.0) << face.s;
        if (face.s > crack_length - element) {
            EXPECT_GT(face.opening, 1e-6);
        }
        if (face.s < 0.9 * crack_length) {
            EXPECT_GT(face.pressure, 0.0);
        }
    }
    EXPECT_TRUE(open);
}

TEST_F(SentCompression, FacesBearTheRemoteStressFarFromTheTip) {
    const coarse::Increment& least = run->at_minimum();
    double force = 0.0, length = 0.0;
    for (const coupling::FaceSample& face : least.zone.faces) {
        if (face.s < 2.0 || face.s > 10.0) continue;
        force += face.pressure;
        length += 1.0;
    }
    EXPECT_NEAR(force / length, 50.0, 5.0);  // MPa
}

TEST_F(SentCompression, ClosedFacesDoNotOverlap) {  // on the average over each multiplier
    const fine::ContactInterface contact(witness->patch.mesh, witness->patch.boundary, input->cracks,
                                         subcells_at_crack(input->fine), 1.0);
    const double limit = 1e-8 * run->at_maximum().tips[0].CMOD;
    for (std::size_t k = 0; k < run->increments.size(); ++k) {
        const Eigen::VectorXd gaps = contact.jumps(witness->displacements[k]).gap;
        for (Eigen::Index m = 0; m < gaps.size(); ++m) {
            const bool closed = witness->statuses[k][at(m)] != 0;
            EXPECT_GT(gaps[m], -limit);
            EXPECT_TRUE(!closed || gaps[m] < limit) << gaps[m];
        }
    }
}

// Quadratic: e' <= C e e_T, e_T that of the tangent's iterate, or what rounding leaves.
TEST_F(SentCompression, ConvergesQuadraticallyOnceBranchesHaveSettled) {
    constexpr double C = 300.0;
    int twice = 0;  // increments with two such ratios one after the other, both above rounding
    for (const coarse::Increment& increment : run->increments) {
        int in_turn = 0, most_in_turn = 0;
        for (const Correction& correction : settled_corrections(increment)) {
            const double bound = correction.bound(C);
            EXPECT_LT(correction.after, std::max(bound, rounding_floor)) << increment.newton.table();
            in_turn = bound < correction.before && bound > rounding_floor ? in_turn + 1 : 0;
            most_in_turn = std::max(most_in_turn, in_turn);
        }
        if (most_in_turn >= 2) ++twice;
    }
    EXPECT_GE(twice, 20);
    const auto onset =
        std::ranges::find_if(run->increments, [](const auto& i) { return i.zone.contact_length[0] > 0.0; });
    const auto reversal = std::ranges::find_if(run->increments, [](const auto& i) { return i.step.cycle == 1; });
    const std::vector<const coarse::Increment*> chosen{&run->at_maximum(), &*onset, &*reversal};
    for (const coarse::Increment* increment : chosen)
        EXPECT_GE(settled_corrections(*increment).size(), 1U) << increment->newton.table();
}

/// What a run says of the plate.
struct Said {
    double J, CMOD, dissipation;
};
Said said_by(const RunHistory& run) {
    const coarse::TipResult& tip = run.at_maximum().tips[0];
    return {tip.J, tip.CMOD, run.increments.back().work.dissipated};
}

// Radial return is of first order in the increment: each halving changes half as much as the one before it.
TEST(RefinedSentCompression, HalvedIncrementsChangeLittleAndHalfAsMuchAgain) {
    std::vector<Said> said;
    for (const int steps : {20, 40, 80, 160})
        said.push_back(said_by(run_direct(sent_case({mesh_at_tip(0.4), "load.steps=" + std::to_string(steps)}))));
    const auto expect = [&](const char* name, double Said::*member, double largest) {
        double before = 0.0;
        for (std::size_t k = 1; k < said.size(); ++k) {
            const double change = std::abs(said[k].*member / (said[k - 1].*member) - 1.0);
            EXPECT_LT(change, k == 1 ? largest : 0.7 * before) << name;
            before = change;
        }
    };
    expect("J", &Said::J, 1e-4);
    expect("CMOD", &Said::CMOD, 1e-4);
    expect("dissipation", &Said::dissipation, 4e-3);
}

TEST(RefinedSentCompression, HalvedElementsHalveTheError) {
    const Said coarse = said_by(run_direct(sent_case({mesh_at_tip(0.4)}))),
               fine = said_by(run_direct(sent_case({mesh_at_tip(0.2)})));
    for (const auto& [member, refined] : {std::pair{&Said::J, refined_J}, {&Said::CMOD, refined_CMOD}}) {
        const double first = coarse.*member / refined - 1.0, second = fine.*member / refined - 1.0;
        EXPECT_LT(std::abs(first), 0.01);
        EXPECT_LT(std::abs(second), 0.5 * std::abs(first));
    }
}

TEST(RefinedSentCompression, IsThatOfElementsHalfAsLargeLong) {
    const Said refined = said_by(run_direct(sent_case(
        {"mesh.size=2.5", "mesh.grading=[{at=[[20.0,100.0]],size=0.05,outer_size=0.1,radius=3.0,growth=0.125}]"})));
    EXPECT_NEAR(refined.J, refined_J, 1e-5 * refined_J);
    EXPECT_NEAR(refined.CMOD, refined_CMOD, 1e-5 * refined_CMOD);
    const Said as_shipped = said_by(run_direct(sent_case({})));
    EXPECT_NEAR(as_shipped.J, refined.J, 0.001 * refined.J);
    EXPECT_NEAR(as_shipped.CMOD, refined.CMOD, 0.001 * refined.CMOD);
}

}  // namespace
}  // namespace stria::test
