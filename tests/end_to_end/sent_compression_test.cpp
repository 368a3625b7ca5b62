// The paper's first example as shipped: an edge-cracked plate is pulled, then pushed until its crack closes.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "tests/support/sent_analysis.hpp"

#include "common/index.hpp"

namespace stria::test {
namespace {

constexpr double crack_length = 20.0, element = 0.1;  // mm, at the tip
constexpr double rounding_floor = 1e-12;              // of a relative residual

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
    coupling::StepReport commit(bool reversal) override {
        coupling::StepReport report = model_.commit(reversal);
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

class SentCompression : public testing::Test {
protected:
    static void SetUpTestSuite() {
        input = std::make_unique<Case>(sent_case({}));
        witness = std::make_unique<Witness>(*input);
        coarse::CondensedFactory factory(witness.get(), *input);
        run = std::make_unique<RunHistory>(run_analysis(*input, factory));
    }
    static void TearDownTestSuite() {
        run.reset();
        witness.reset();
        input.reset();
    }

    /// Relative residuals of an increment once the set of flowing points and closed multipliers stays as it is.
    static std::vector<double> settled_residuals(const coarse::Increment& increment) {
        const auto& iterations = increment.newton.iterations;
        const auto same_branches = [](const coarse::Residual& a, const coarse::Residual& b) {
            return a.yielding_points == b.yielding_points && a.closed == b.closed && b.status_changes == 0;
        };
        std::size_t first = iterations.size() - 1;
        while (first > 0 && same_branches(iterations[first - 1].residual, iterations[first].residual)) --first;
        std::vector<double> residuals;
        for (std::size_t k = first; k < iterations.size(); ++k) {
            const coarse::Residual& r = iterations[k].residual;
            residuals.push_back(r.largest() / r.scale);
        }
        return residuals;
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
    EXPECT_NEAR(tip.J, 3.28, 0.02 * 3.28);
    EXPECT_NEAR(tip.CMOD, 0.0607, 0.02 * 0.0607);
    EXPECT_GT(tip.CTOD, 0.0);
}

// The faces meet as they parted: nothing slides, so friction changes nothing, and no front is general for it.
TEST_F(SentCompression, FrictionChangesNothingOfASymmetricCrack) {
    const Case rough = sent_case({"crack.0.contact.friction=0.3"});
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
    EXPECT_EQ(last.work.by_friction, 0.0);
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
                                         input->fine.subcells, 1.0);
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

TEST_F(SentCompression, ConvergesQuadraticallyOnceBranchesHaveSettled) {
    const auto onset =
        std::ranges::find_if(run->increments, [](const auto& i) { return i.zone.contact_length[0] > 0.0; });
    const auto reversal = std::ranges::find_if(run->increments, [](const auto& i) { return i.step.cycle == 1; });
    const std::vector<const coarse::Increment*> chosen{&run->at_maximum(), &*onset, &*reversal};
    for (const coarse::Increment* increment : chosen) {
        const std::vector<double> residual = settled_residuals(*increment);
        ASSERT_GE(residual.size(), 2U) << increment->newton.table();
        for (std::size_t k = 1; k < residual.size(); ++k) {
            // Quadratic: e' <= C e^2, or what rounding leaves.
            EXPECT_LT(residual[k], std::max(100.0 * residual[k - 1] * residual[k - 1], rounding_floor))
                << increment->newton.table();
        }
    }
}

}  // namespace
}  // namespace stria::test
