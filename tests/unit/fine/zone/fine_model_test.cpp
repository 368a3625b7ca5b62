// The zone as a superelement: its condensed tangent, and iterates that are those of Newton's method on the whole
// system.
#include "fine/zone/fine_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/index.hpp"
#include "tests/support/pulled_zone.hpp"
#include "tests/support/whole_tangent.hpp"

namespace stria::test {
namespace {

using coupling::PatchResponse;
using fine::FineModel;

const Case scene = plate_case({mouth_of_pulled, tip_of_pulled});
const Case rough_scene = [] {
    Case rough = scene;
    rough.cracks[0].contact->friction = 0.3;
    return rough;
}();
const EnrichedMesh plate = plate_mesh(6, 5, scene);
const coupling::Patch patch = plate_patch(plate);

Eigen::VectorXd pulled(double strain) { return stretched(patch, strain); }
Eigen::VectorXd sheared(double strain, double shear) { return stretched(patch, strain, 1, shear); }

/// The answer once the interior is in equilibrium. Every call is a new attempt at the same increment.
PatchResponse settled(FineModel& model, const Eigen::VectorXd& boundary) {
    for (int iteration = 0; iteration < 30; ++iteration) {
        model.request({.iteration = iteration, .boundary = boundary});
        PatchResponse response = model.collect();
        if (response.interior_residual + response.contact_residual < 1e-10 * response.interior_force) return response;
    }
    throw std::runtime_error("the interior finds no equilibrium");
}

long yielding(const PatchResponse& response) {
    long sum = 0;
    for (const int count : response.digest.yielding_points) sum += count;
    return sum;
}

/// Strains from one to another in increments that Newton's full steps can follow, each committed.
void follow(FineModel& model, double from, double to) {
    const int steps = static_cast<int>(std::ceil(std::abs(to - from) / 2.5e-4));
    for (int k = 1; k <= steps; ++k) {
        settled(model, pulled(from + (to - from) * k / steps));
        model.commit({});
    }
}

struct Loading {
    const char* name;
    double peak, strain;  // there, then here
    bool plastic, closed;
};

class Superelement : public testing::TestWithParam<Loading> {};

TEST_P(Superelement, CondensedTangentIsTheDerivativeOfTheCondensedForce) {
    const Loading& loading = GetParam();
    FineModel model(scene);
    model.set_patch(patch);
    follow(model, 0.0, loading.peak);
    follow(model, loading.peak, loading.strain);
    const Eigen::VectorXd u = stretched(patch, loading.strain * 1.1, 2);
    const PatchResponse here = settled(model, u);
    EXPECT_EQ(yielding(here) > 0, loading.plastic);
    EXPECT_EQ(std::ranges::count(here.digest.status, 1) > 0, loading.closed);
    const Eigen::VectorXd v = random_vector(u.size(), 1.0, 3);
    constexpr double h = 1e-8;
    const Eigen::VectorXd difference = (settled(model, u + h * v).force - settled(model, u - h * v).force) / (2.0 * h);
    EXPECT_LT((whole(here.tangent) * v - difference).norm(), 3e-6 * difference.norm());
}

INSTANTIATE_TEST_SUITE_P(States, Superelement,
                         testing::Values(Loading{"elastic_open", 0.0, 1e-5, false, false},
                                         Loading{"elastic_closed", 0.0, -1e-5, false, true},
                                         Loading{"plastic_open", 0.0, 2e-3, true, false},
                                         Loading{"plastic_closed", 0.0, -2e-3, true, true},
                                         Loading{"closed_after_opening", 1.5e-3, -1.5e-3, true, true}),
                         [](const auto& test) { return test.param.name; });

/// Strains that flow, unload, close and flow back, with a shear besides; faces of the condensed model that slid.
long follow_both(const Case& input, double shear, const std::vector<double>& strains) {
    FineModel model(input);
    model.set_patch(patch);
    FullNewton full(patch, input);
    double last = 0.0;
    long sliding = 0;
    for (const double strain : strains) {
        const double predictor = strain * last > 0.0 && strain > last ? 0.5 : 0.0;
        last = strain;
        for (int iteration = 0; iteration < 8; ++iteration) {
            // The boundary moves between the iterations too, as it does in a run.
            const double now = strain * (1.0 + 0.1 * std::pow(0.1, iteration));
            const Eigen::VectorXd boundary = sheared(now, shear * now);
            model.request({.iteration = iteration, .predictor = predictor, .boundary = boundary});
            const PatchResponse condensed = model.collect();
            const PatchResponse whole = iteration == 0 ? full.begin(boundary, predictor) : full.iterate(boundary);
            EXPECT_NEAR(condensed.interior_residual, whole.interior_residual, 1e-9 * whole.interior_force);
            EXPECT_NEAR(condensed.interior_displacement, whole.interior_displacement, 1e-11);
            EXPECT_EQ(condensed.digest.yielding_points, whole.digest.yielding_points);
            EXPECT_EQ(condensed.digest.status, whole.digest.status);
        }
        for (const coupling::FaceSample& face : model.commit({}).faces) sliding += face.status == 2 ? 1 : 0;
        full.commit({});
        EXPECT_LT((model.state().displacement - full.displacement()).lpNorm<Eigen::Infinity>(), 1e-12) << strain;
    }
    return sliding;
}

TEST(FineModel, ItsIteratesAreThoseOfNewtonOnTheWholeSystem) {
    EXPECT_EQ(follow_both(scene, 0.0, {5e-4, 1e-3, 1.5e-3, 1e-3, 5e-4, 0.0, -5e-4, -1e-3}), 0);
}

TEST(FineModel, AlsoWhereItsFacesSlide) {
    EXPECT_GT(follow_both(rough_scene, 1.0, {5e-4, 1e-3, 1.5e-3, 1e-3, 5e-4, 0.0, -5e-4, -1e-3, -5e-4}), 0);
}

/// Shear under pressure, there, then here.
struct Rubbing {
    const char* name;
    double there, here;
    std::int8_t status;
};

class RoughSuperelement : public testing::TestWithParam<Rubbing> {};

TEST_P(RoughSuperelement, CondensedTangentIsTheDerivativeOfTheCondensedForce) {
    const Rubbing& rubbing = GetParam();
    FineModel model(rough_scene);
    model.set_patch(patch);
    settled(model, sheared(-2e-4, 0.5 * rubbing.there));
    model.commit({});
    settled(model, sheared(-4e-4, rubbing.there));
    model.commit({});
    const Eigen::VectorXd u = sheared(-4.5e-4, rubbing.here);
    const PatchResponse here = settled(model, u);
    EXPECT_GT(std::ranges::count(here.digest.status, rubbing.status), 0);
    const bool slides = std::ranges::any_of(here.digest.status, [](std::int8_t status) { return status > 1; });
    EXPECT_EQ(here.tangent.symmetry, slides ? Symmetry::General : Symmetry::Symmetric);
    const Eigen::VectorXd v = random_vector(u.size(), 1.0, 3);
    constexpr double h = 1e-9;
    const Eigen::VectorXd difference = (settled(model, u + h * v).force - settled(model, u - h * v).force) / (2.0 * h);
    EXPECT_LT((whole(here.tangent) * v - difference).norm(), 1e-5 * difference.norm());
    const Eigen::MatrixXd s = whole(here.tangent);
    EXPECT_EQ((s - s.transpose()).cwiseAbs().maxCoeff() > 1e-6 * s.cwiseAbs().maxCoeff(), slides);
}

INSTANTIATE_TEST_SUITE_P(States, RoughSuperelement,
                         testing::Values(Rubbing{"sticks", 1e-5, 1.1e-5, 1}, Rubbing{"slides_on", 6e-4, 8e-4, 2},
                                         Rubbing{"slides_back", -6e-4, -8e-4, 3},
                                         Rubbing{"turns_round", 8e-4, -4e-4, 3}, Rubbing{"locks", 8e-4, 7.5e-4, 1}),
                         [](const auto& test) { return test.param.name; });

TEST(FineModel, ARolledBackAttemptLeavesNoTrace) {
    FineModel model(scene);
    model.set_patch(patch);
    follow(model, 0.0, 1e-3);
    const PatchResponse first = settled(model, pulled(1.2e-3));
    for (const int iteration : {0, 1, 2}) {  // far away, and not settled
        model.request({.iteration = iteration, .predictor = 0.5, .boundary = pulled(-1e-2)});
        model.collect();
    }
    model.rollback();
    const PatchResponse again = settled(model, pulled(1.2e-3));
    EXPECT_EQ(again.force, first.force);
    EXPECT_EQ(whole(again.tangent), whole(first.tangent));
    EXPECT_EQ(again.digest.multiplier, first.digest.multiplier);
}

TEST(FineModel, TellsOfACommitWhatIsReadOfIt) {
    coupling::Patch with_ring = patch;
    with_ring.rings = {{.tip = 0, .number = 0, .inner_radius = 1.0, .outer_radius = 2.0}};
    FineModel model(scene);
    model.set_patch(with_ring);
    const auto told = [&](const coupling::Commit& what) {
        static_cast<void>(settled(model, pulled(1e-3)));
        const coupling::StepReport report = model.commit(what);
        EXPECT_EQ(report.contact_length.size(), 1U);
        return std::pair(!report.rings.empty(), !report.faces.empty());
    };
    EXPECT_EQ(told({}), std::pair(true, true));
    EXPECT_EQ(told({.brief = true}), std::pair(false, true));
    EXPECT_EQ(told({.no_faces = true}), std::pair(true, false));
}

TEST(FineModel, WithoutContactSaysNothingOfIt) {
    Case free = scene;
    free.cracks[0].contact.reset();
    FineModel model(free);
    model.set_patch(patch);
    const PatchResponse response = settled(model, pulled(1e-3));
    EXPECT_TRUE(response.digest.status.empty() && response.digest.multiplier.empty());
    const coupling::StepReport report = model.commit({});
    EXPECT_FALSE(report.faces.empty());
    for (const coupling::FaceSample& face : report.faces)
        EXPECT_TRUE(face.opening > 0.0 && face.pressure == 0.0 && face.status == 0) << face.s;
    EXPECT_EQ(report.multipliers + report.work.interface_elements + report.work.gaps_evaluated, 0);
}

}  // namespace
}  // namespace stria::test
