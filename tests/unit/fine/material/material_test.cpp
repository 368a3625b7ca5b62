// What every law of the catalogue must keep, on random strain paths.
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <ostream>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "common/error.hpp"
#include "common/index.hpp"
#include "fine/material/hardening_curve.hpp"
#include "tests/support/material_point.hpp"

namespace stria::test {
namespace {

namespace state = fine::state;

struct Law {
    std::string name;
    MaterialSection material;
    PlaneState plane = PlaneState::Strain;
};

void PrintTo(const Law& law, std::ostream* out) { *out << law.name; }

MaterialSection steel(double isotropic, std::vector<KinematicHardening> kinematic) {
    return {.young = 200e3,
            .poisson = 0.3,
            .yield_stress = 350.0,
            .isotropic = {.law = "linear", .modulus = isotropic},
            .kinematic = std::move(kinematic)};
}

MaterialSection curved(IsotropicHardening isotropic, std::vector<KinematicHardening> kinematic = {}) {
    MaterialSection material = steel(0.0, std::move(kinematic));
    material.isotropic = std::move(isotropic);
    return material;
}

const IsotropicHardening voce{.law = "voce", .Q = 80.0, .b = 20.0};
const std::vector<KinematicHardening> recalling{{60e3, 300.0}, {9e3, 30.0}, {2e3, 0.0}};

std::vector<Law> in_both_plane_states(std::vector<Law> laws) {
    const auto count = laws.size();
    for (std::size_t k = 0; k < count; ++k)
        laws.push_back({laws[k].name + "_plane_stress", laws[k].material, PlaneState::Stress});
    return laws;
}

const std::vector<Law> laws = in_both_plane_states({
    {"elastic", {.young = 200e3, .poisson = 0.3, .yield_stress = {}, .isotropic = {}, .kinematic = {}}},
    {"perfect", steel(0.0, {})},
    {"isotropic", steel(2000.0, {})},
    {"prager", steel(0.0, {{5000.0, 0.0}})},
    {"mixed", steel(1000.0, {{3000.0, 0.0}, {20000.0, 0.0}})},
    {"voce", curved(voce, {{3000.0, 0.0}})},
    {"power", curved({.law = "power", .n = 8.0, .alpha = 0.5, .reference = 400.0})},
    {"table",
     curved({.law = "table", .plastic_strain = {0.0, 0.002, 0.01, 0.1}, .stress = {350.0, 380.0, 400.0, 450.0}})},
    {"recall", curved(voce, recalling)},
});

bool recalls(const MaterialSection& material) {
    return std::ranges::any_of(material.kinematic, [](const KinematicHardening& term) { return term.gamma > 0.0; });
}

class EveryLaw : public testing::TestWithParam<Law> {
protected:
    /// Zero-mean in-plane strain increments, about one yield strain each.
    Mandel random_increment() {
        std::normal_distribution<double> normal(0.0, 1.5e-3);
        return {normal(random_), normal(random_), 0.0, normal(random_)};
    }

    MaterialPoint point_{GetParam().material, GetParam().plane};
    std::mt19937 random_{7};
};

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryLaw, testing::ValuesIn(laws), [](const auto& law) { return law.param.name; });

// Backward Euler has a potential: what an increment stores and dissipates. So the work balance has no error of the law.
// Recall takes back stress against the direction of flow: it has none.
TEST_P(EveryLaw, StressIsTheDerivativeOfWhatIsStoredAndDissipated) {
    if (recalls(GetParam().material)) return;
    const double h = 1e-7;
    const auto energy = [&](const std::vector<double>& committed, const Mandel& increment) {
        const PointUpdate trial = update_point(point_.law(), committed, increment);
        return point_.law().stored_energy(trial.state.data(), 1) + trial.scalar(state::dissipation);
    };
    for (int step = 0; step < 200; ++step) {
        const std::vector<double> committed = point_.last().state;
        const Mandel increment = random_increment();
        Mandel derivative = Mandel::Zero();
        for (const int j : {0, 1, 3}) {
            const Mandel nudge = h * Mandel::Unit(j);
            derivative[j] = (energy(committed, increment + nudge) - energy(committed, increment - nudge)) / (2.0 * h);
        }
        Mandel stress = point_.strain_by(increment).stress();
        stress[2] = 0.0;
        EXPECT_LT((derivative - stress).norm(), 1e-5 * 350.0) << step;
    }
}

// Of the stress's derivative the symmetric part, which is all of it without recall.
TEST_P(EveryLaw, TangentIsTheDerivativeOfTheStressAndSymmetric) {
    const double h = 1e-8;
    const bool symmetric = !recalls(GetParam().material);
    int compared = 0;
    for (int step = 0; step < 200; ++step) {
        const std::vector<double> committed = point_.last().state;
        const Mandel increment = random_increment();
        const PointUpdate here = point_.strain_by(increment);
        MandelMatrix derivative = here.tangent;
        for (int j = 0; j < 4; ++j) {
            const PointUpdate plus = update_point(point_.law(), committed, increment + h * Mandel::Unit(j));
            const PointUpdate minus = update_point(point_.law(), committed, increment - h * Mandel::Unit(j));
            if (plus.yields != minus.yields) continue;  // the stress has a kink there
            derivative.col(j) = (plus.stress() - minus.stress()) / (2.0 * h);
            ++compared;
        }
        if (!symmetric) derivative = (0.5 * (derivative + derivative.transpose())).eval();
        EXPECT_LT((derivative - here.tangent).norm(), 1e-6 * point_.law().elastic().norm()) << step;
        EXPECT_EQ(here.tangent, here.tangent.transpose());
    }
    EXPECT_GT(compared, 700);
}

TEST_P(EveryLaw, SameInputsGiveTheSameBits) {
    for (int step = 0; step < 50; ++step) {
        const std::vector<double> committed = point_.last().state;
        const Mandel increment = random_increment();
        const PointUpdate first = point_.strain_by(increment);
        const PointUpdate second = update_point(point_.law(), committed, increment);
        EXPECT_EQ(first.state, second.state);
        EXPECT_EQ(first.tangent, second.tangent);
        EXPECT_EQ(first.yields, second.yields);
    }
}

TEST_P(EveryLaw, StressChangesByTheElasticPartOfTheStrain) {
    Mandel strain = Mandel::Zero();
    for (int step = 0; step < 50; ++step) {
        const Mandel increment = random_increment();
        strain += increment;
        const PointUpdate& now = point_.strain_by(increment);
        const Mandel plastic = now.tensor(state::plastic_strain);
        EXPECT_LT((now.stress() - point_.law().elastic() * (strain - plastic)).norm(), 1e-9);
        EXPECT_NEAR(trace(plastic), 0.0, 1e-15);
    }
}

TEST_P(EveryLaw, ElasticIncrementsAddUpAndWorkIsHalfStressTimesStrain) {
    const Mandel whole{2e-4, 9e-4, 0.0, -3e-4};
    MaterialPoint other{GetParam().material, GetParam().plane};
    other.strain_by(0.3 * whole);
    other.strain_by(0.7 * whole);
    const PointUpdate& once = point_.strain_by(whole);
    EXPECT_FALSE(once.yields);
    EXPECT_EQ(once.tangent, point_.law().elastic());
    EXPECT_LT((once.stress() - other.last().stress()).norm(), 1e-12);
    const double work = point_.law().work(once.state.data(), 1);
    EXPECT_NEAR(work, 0.5 * once.stress().dot(whole), 1e-14);
    EXPECT_NEAR(point_.law().work(other.last().state.data(), 1), work, 1e-14);
    std::vector<double> begun(once.state.size(), 0.0);
    point_.law().begin(whole, Mandel::Zero(), begun.data(), 1);
    EXPECT_NEAR(point_.law().work(begun.data(), 1), work, 1e-14);
    for (std::size_t c = 0; c < begun.size(); ++c) EXPECT_NEAR(begun[c], once.state[c], 1e-12);
    const Mandel initial{20.0, -10.0, 0.0, 5.0};
    point_.law().begin(whole, initial, begun.data(), 1);
    EXPECT_LT((fine::tensor_at(begun.data(), 1, state::stress) - initial - once.stress()).norm(), 1e-12);
    EXPECT_NEAR(point_.law().work(begun.data(), 1), point_.law().stored_energy(begun.data(), 1), 1e-14);
    EXPECT_EQ(once.scalar(state::dissipation), 0.0);
}

TEST_P(EveryLaw, NothingFlowsInAnIncrementOfNothing) {
    for (int step = 0; step < 200; ++step) {
        point_.strain_by(random_increment());
        const PointUpdate still = update_point(point_.law(), point_.last().state, Mandel::Zero());
        EXPECT_FALSE(still.yields);
        EXPECT_EQ(still.state, point_.last().state);
    }
}

TEST_P(EveryLaw, StaysInsideTheYieldSurfaceAndOnItWhereItFlows) {
    const MaterialSection& material = GetParam().material;
    if (!material.yield_stress) return;
    for (int step = 0; step < 200; ++step) {
        const PointUpdate& now = point_.strain_by(random_increment());
        Mandel relative = now.stress();
        for (std::size_t k = 0; k < material.kinematic.size(); ++k)
            relative -= now.tensor(state::back_stress + 4 * static_cast<int>(k));
        const double yield_stress =
            *material.yield_stress + fine::HardeningCurve(material).value(now.scalar(state::accumulated));
        const double overstress = von_mises(relative) / yield_stress - 1.0;
        EXPECT_LT(overstress, 1e-10);
        EXPECT_GT(overstress, now.yields ? -1e-12 : -1.1);
    }
}

TEST_P(EveryLaw, NoStressThroughTheThicknessInPlaneStress) {
    if (GetParam().plane == PlaneState::Strain) return;
    for (int step = 0; step < 50; ++step) {
        const Mandel increment = random_increment(), through = 1e-3 * Mandel::Unit(2);
        const PointUpdate other = update_point(point_.law(), point_.last().state, increment + through);
        const PointUpdate& now = point_.strain_by(increment);
        EXPECT_EQ(now.stress()[2], 0.0);
        EXPECT_TRUE(now.tangent.row(2).isZero(0.0) && now.tangent.col(2).isZero(0.0));
        EXPECT_EQ(other.state, now.state);  // that strain is not looked at
    }
}

TEST_P(EveryLaw, BlocksEqualSinglePoints) {
    constexpr int points = 11, stride = 13;  // neither is a multiple of any vector length
    const auto size = at(point_.law().state_size());
    std::vector<double> increments(4 * stride), committed(size * stride), trial(size * stride), tangent(16 * stride);
    std::vector<unsigned char> yields(points);
    std::vector<MaterialPoint> singles;
    for (std::size_t q = 0; q < points; ++q) {
        singles.emplace_back(GetParam().material, GetParam().plane).strain_by(random_increment());
        for (std::size_t c = 0; c < size; ++c) committed[c * stride + q] = singles[q].last().state[c];
        const Mandel increment = random_increment();
        for (std::size_t c = 0; c < 4; ++c) increments[c * stride + q] = increment[static_cast<Eigen::Index>(c)];
        singles[q].strain_by(increment);
    }
    point_.law().update(points, stride, increments.data(), committed.data(), trial.data(), tangent.data(),
                        yields.data());
    for (std::size_t q = 0; q < points; ++q) {
        const PointUpdate& single = singles[q].last();
        EXPECT_EQ(yields[q] != 0, single.yields);
        for (std::size_t c = 0; c < size; ++c)
            EXPECT_NEAR(trial[c * stride + q], single.state[c], 1e-12 * (1.0 + std::abs(single.state[c])));
        for (int c = 0; point_.law().can_yield() && c < 16; ++c)
            EXPECT_NEAR(tangent[at(c) * stride + q], single.tangent(c / 4, c % 4), 1e-6);
    }
}

TEST_P(EveryLaw, WorkIsStoredOrDissipated) {
    const MaterialSection& material = GetParam().material;
    for (int step = 0; step < 4000; ++step) {  // small steps along a loop: the trapezoid rule's error vanishes
        const double phase = step * 2.0 * std::numbers::pi / 4000.0;
        point_.strain_by(1e-5 * Mandel(std::cos(phase), -0.4 * std::cos(phase), 0.0, std::sin(phase)));
    }
    const PointUpdate& end = point_.last();
    const double p = end.scalar(state::accumulated);
    const Mandel elastic_strain = point_.law().elastic().completeOrthogonalDecomposition().solve(end.stress());
    double stored = 0.5 * end.stress().dot(elastic_strain);
    if (material.yield_stress) {
        EXPECT_GT(p, 1e-3);
        const double by_recall = end.scalar(state::dissipation) - *material.yield_stress * p;
        EXPECT_EQ(by_recall > 1e-9, recalls(material));
        EXPECT_GT(by_recall, -1e-9);
        stored += fine::HardeningCurve(material).stored(p);
    }
    for (std::size_t k = 0; k < material.kinematic.size(); ++k)
        stored +=
            0.75 / material.kinematic[k].C * end.tensor(state::back_stress + 4 * static_cast<int>(k)).squaredNorm();
    const double dissipated = end.scalar(state::dissipation);
    const double work = point_.law().work(end.state.data(), 1);
    EXPECT_NEAR(work, stored + dissipated, 1e-4 * (1e-9 + stored + dissipated));
}

TEST(MaterialLaw, WithoutAYieldStressRemembersItsStressAlone) {
    const MaterialSection elastic{.young = 200e3, .poisson = 0.3, .yield_stress = {}, .isotropic = {}, .kinematic = {}};
    for (const PlaneState plane : {PlaneState::Strain, PlaneState::Stress}) {
        EXPECT_EQ(fine::make_material_law(elastic, plane)->state_size(), 4);
        EXPECT_FALSE(fine::make_material_law(elastic, plane)->can_yield());
        EXPECT_TRUE(fine::make_material_law(steel(0.0, {}), plane)->can_yield());
    }
}

TEST(MaterialLaw, RefusesWhatItDoesNotKnow) {
    const std::vector<MaterialSection> wrong{steel(0.0, {{5000.0, -20.0}}), steel(0.0, {{-5000.0, 0.0}}),
                                             curved({.law = "swift"})};
    for (const MaterialSection& material : wrong)
        for (const PlaneState plane : {PlaneState::Strain, PlaneState::Stress})
            EXPECT_THROW(fine::make_material_law(material, plane), CaseError) << material.isotropic.law;
}

TEST(MaterialLaw, AStrainThatIsNoNumberFails) {
    for (const PlaneState plane : {PlaneState::Strain, PlaneState::Stress}) {
        MaterialPoint point(steel(0.0, {}), plane);
        EXPECT_THROW(point.strain_by(Mandel(std::numeric_limits<double>::quiet_NaN(), 0, 0, 0)), NumericalFailure);
        EXPECT_THROW(point.strain_by(Mandel(1e300, 0.0, 0.0, 0.0)), NumericalFailure);
    }
}

// Any strain leads to a stress on the surface, however far it goes at once.
TEST(MaterialLaw, FindsItsWayFromAnyStrain) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> exponent(-7.0, 0.0), sign(-1.0, 1.0);
    for (const Law& law : laws) {
        MaterialPoint point(law.material, law.plane);
        for (int step = 0; step < 3000; ++step) {
            const double size = std::pow(10.0, exponent(random));
            ASSERT_NO_THROW(point.strain_by(size * Mandel(sign(random), sign(random), 0.0, sign(random)))) << law.name;
            ASSERT_TRUE(point.last().tangent.allFinite()) << law.name;
        }
    }
}

// An increment in parts is those parts one after the other, in plane stress too.
TEST(MaterialLaw, TakesAnIncrementInParts) {
    constexpr int parts = 5;
    const Mandel whole{2e-3, 1e-3, 0.0, -3e-3};
    for (const PlaneState plane : {PlaneState::Strain, PlaneState::Stress}) {
        for (const MaterialSection& material : {curved(voce, recalling), steel(1000.0, {{3000.0, 0.0}})}) {
            const auto in_parts = fine::make_material_law(material, plane, parts);
            MaterialPoint point(material, plane);
            point.strain_by({1e-3, -3e-3, 0.0, 1e-3});
            const PointUpdate once = update_point(*in_parts, point.last().state, whole);
            for (int part = 0; part < parts; ++part) point.strain_by(whole / parts);
            for (std::size_t c = 0; c < once.state.size(); ++c) {
                if (c == at(state::work)) continue;  // by the trapezoid rule of each
                EXPECT_NEAR(once.state[c], point.last().state[c], 1e-10 * (1.0 + std::abs(once.state[c]))) << c;
            }
        }
    }
}

}  // namespace
}  // namespace stria::test
