// The zone as a superelement: its condensed tangent, and iterates that are those of Newton's method on the whole
// system.
#include "fine/zone/fine_model.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "common/index.hpp"
#include "tests/support/plates.hpp"
#include "tests/support/whole_tangent.hpp"

namespace stria::test {
namespace {

using coupling::PatchResponse;
using fine::FaceStatus;
using fine::FineModel;
using fine::ZoneSystem;

const Vec2 mouth{0.0, 2.4}, tip{3.3, 2.6};
const Case scene = plate_case({mouth, tip});
const Case rough_scene = [] {
    Case rough = scene;
    rough.cracks[0].contact->friction = 0.3;
    return rough;
}();
const EnrichedMesh plate = plate_mesh(6, 5, scene);
const coupling::Patch patch = plate_patch(plate);

/// Boundary displacements: stretched across the crack by a strain, with some noise.
Eigen::VectorXd stretched(double strain, unsigned seed = 1, const coupling::Patch& zone = patch, double shear = 0.0) {
    const double middle = zone.mesh.nodes.back().y() / 2.0;
    const auto pull = [&](const Vec2& x) {
        const double y = x.y() - middle;
        return Vec2(0.1 * strain * x.x() + shear * y, strain * y);
    };
    const Eigen::VectorXd u =
        two_sided(zone.mesh, mouth, tip, pull, pull) + random_vector(zone.mesh.unknowns, 0.02 * std::abs(strain), seed);
    return gather(u, zone.boundary);
}
Eigen::VectorXd sheared(double strain, double shear) { return stretched(strain, 1, patch, shear); }

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
        settled(model, stretched(from + (to - from) * k / steps));
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
    const Eigen::VectorXd u = stretched(loading.strain * 1.1, 2);
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

/// Newton's method on all interior unknowns and multipliers in one dense matrix, the boundary imposed.
class FullNewton {
public:
    explicit FullNewton(const coupling::Patch& zone = patch, const Case& input = scene)
        : system_(input), modulus_(elasticity_of(input.material, input.model.plane).plane_modulus()) {
        system_.set_patch(zone);
    }

    PatchResponse begin(const Eigen::VectorXd& boundary, const Predictor& predictor) {
        system_.predict(predictor);
        return evaluate(boundary);
    }

    PatchResponse iterate(const Eigen::VectorXd& boundary) {
        const coupling::Patch& zone = system_.patch();
        const Eigen::Index n = zone.mesh.unknowns, m = system_.contact().tractions();
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + m, n + m);
        for (int e = 0; e < system_.bulk().elements().count(); ++e) {
            const std::vector<int>& unknowns = system_.bulk().elements().op(e).unknowns;
            matrix(unknowns, unknowns) += system_.bulk().tangent(e);
        }
        add_contact(matrix);
        Eigen::VectorXd right(n + m);
        right << system_.load(), system_.contact_right_hand_side();
        const Eigen::VectorXd step = boundary - gather(system_.displacement(), zone.boundary);
        for (std::size_t k = 0; k < zone.boundary.size(); ++k) {
            matrix.row(zone.boundary[k]).setZero();
            matrix(zone.boundary[k], zone.boundary[k]) = 1.0;
            right[zone.boundary[k]] = step[static_cast<Eigen::Index>(k)];
        }
        const Eigen::VectorXd correction = matrix.partialPivLu().solve(right);
        system_.move(correction.head(n), correction.tail(m));
        return evaluate(boundary);
    }

    void commit(const coupling::Commit& what) { last_ = system_.commit(what); }
    [[nodiscard]] const coupling::StepReport& last() const { return last_; }
    [[nodiscard]] coupling::ZoneState state() const { return system_.state(); }
    /// On the boundary.
    [[nodiscard]] Eigen::VectorXd force() const { return -gather(system_.load(), system_.patch().boundary); }
    [[nodiscard]] const Eigen::VectorXd& displacement() const { return system_.displacement(); }

private:
    void add_contact(Eigen::MatrixXd& matrix) const {
        const fine::ContactInterface& contact = system_.contact();
        const fine::FaceOperators& faces = contact.operators();
        const Eigen::MatrixXd B = faces.operator_B(), T = faces.operator_T();
        const Eigen::Index n = B.cols();
        for (int k = 0; k < contact.multipliers(); ++k) {
            const FaceStatus status = contact.statuses()[at(k)];
            const double idle = -faces.weight(k) * faces.weight(k) / (0.1 * modulus_);
            const Eigen::Index p = n + k, q = n + contact.shear_of(k);
            matrix.col(p).head(n) = -B.row(k).transpose();
            if (status == FaceStatus::Open)
                matrix(p, p) = idle;
            else
                matrix.row(p).head(n) = -B.row(k);
            if (q < n) continue;
            matrix.col(q).head(n) = T.row(k).transpose();
            if (status == FaceStatus::Stick)
                matrix.row(q).head(n) = T.row(k);
            else
                matrix(q, q) = idle;
            if (contact.slides(k)) matrix(q, p) = (status == FaceStatus::SlipBack ? idle : -idle) * faces.friction(k);
        }
    }

    PatchResponse evaluate(const Eigen::VectorXd& boundary) {
        system_.set_boundary(boundary);
        system_.linearise();
        return system_.measure();
    }
    ZoneSystem system_;
    double modulus_;
    coupling::StepReport last_;
};

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

/// A plate whose crack sees little of it: after a whole cycle most of it rests.
class Resting : public testing::Test {
protected:
    explicit Resting(const Case& input = scene, int columns = 11)
        : mesh_(plate_mesh(columns, 9, input)), model_(input), full_(zone_, input) {}

    /// Both to equilibrium, and committed.
    coupling::StepReport go_to(double strain, bool reversal) {
        const Eigen::VectorXd boundary = stretched(strain, 1, zone_);
        const auto settled_whole = [](const PatchResponse& r) {
            return r.interior_residual + r.contact_residual < 1e-11 * r.interior_force;
        };
        PatchResponse condensed, whole;
        for (int iteration = 0; iteration < 40; ++iteration) {
            model_.request({.iteration = iteration, .boundary = boundary});
            condensed = model_.collect();
            whole = iteration == 0 ? full_.begin(boundary, {}) : full_.iterate(boundary);
            if (iteration > 2 && settled_whole(condensed) && settled_whole(whole)) break;
        }
        EXPECT_LT((condensed.force - full_.force()).lpNorm<Eigen::Infinity>(), 1e-9 * condensed.interior_force);
        coupling::StepReport report = model_.commit({.reversal = reversal});
        full_.commit({.reversal = reversal});
        const Eigen::VectorXd difference = model_.state().displacement - full_.displacement();
        EXPECT_LT(difference.lpNorm<Eigen::Infinity>(), 1e-11) << strain;
        return report;
    }

    /// Between nothing and a peak, in increments that Newton's full steps can follow.
    coupling::StepReport cycles(int count, double peak) {
        coupling::StepReport last;
        const int steps = static_cast<int>(std::ceil(peak / 2.5e-4));
        for (int half = 0; half < 2 * count; ++half) {
            for (int k = 1; k <= steps; ++k) last = go_to(peak * (half % 2 == 0 ? k : steps - k) / steps, k == steps);
        }
        return last;
    }

    EnrichedMesh mesh_;
    coupling::Patch zone_ = plate_patch(mesh_);
    FineModel model_;
    FullNewton full_;
    void SetUp() override { model_.set_patch(zone_); }
};

TEST_F(Resting, ChangesNoDisplacementAndNoForce) {
    EXPECT_EQ(cycles(1, 8e-4).work.points_at_rest, 0);
    const coupling::WorkCounts work = cycles(2, 8e-4).work;
    EXPECT_GT(work.points_at_rest, work.points_evaluated / 4);
}

TEST_F(Resting, WhatWouldYieldIsWoken) {
    cycles(2, 8e-4);
    const coupling::StepReport overload = cycles(1, 2.4e-3);
    EXPECT_GT(overload.work.elements_woken, 0);
    cycles(1, 8e-4);
}

TEST_F(Resting, ItsReportsAreThoseOfAnAwakeZone) {
    cycles(3, 8e-4);
    const coupling::StepReport condensed = go_to(5e-4, false);
    EXPECT_GT(condensed.work.points_at_rest, 0);
    const coupling::StepReport whole = full_.last();
    EXPECT_NEAR(condensed.energy.stored, whole.energy.stored, 1e-11 * whole.energy.stored);
    EXPECT_NEAR(condensed.dissipation, whole.dissipation, 1e-10 * whole.dissipation);
    const coupling::ZoneState resting = model_.state(), awake = full_.state();
    double largest = 0.0;
    for (std::size_t i = 0; i < awake.stress.size(); ++i)
        largest = std::max(largest, std::abs(resting.stress[i] - awake.stress[i]));
    EXPECT_LT(largest, 1e-6);  // MPa
}

// A growth, which may come between, wakes all: who rests is looked for when the zone is asked again.
TEST_F(Resting, ItBeginsWhenTheZoneIsAskedAgain) {
    cycles(3, 8e-4);
    EXPECT_TRUE(model_.system().bulk().resting().elements().none());
    const auto still = [](const coupling::ZoneSnapshot& snapshot) { return std::ranges::count(snapshot.resting, 1); };
    model_.keep();
    EXPECT_EQ(still(model_.kept()), 0);
    EXPECT_GT(still(model_.snapshot()), 0);  // as a run that goes on
    EXPECT_EQ(model_.system().bulk().resting().elements().count(), still(model_.snapshot()));
}

/// The same with a crack, rough or not, most of whose faces are far from its tip.
class RestingFaces : public Resting, public testing::WithParamInterface<double> {
protected:
    static Case long_crack() {
        Case input = plate_case({mouth, mouth + 2.5 * (tip - mouth)});
        input.cracks[0].contact->friction = GetParam();
        return input;
    }
    RestingFaces() : Resting(long_crack(), 16) {}

    /// Between two strains that do not change who touches, until faces rest; how many of them in the last half cycle.
    int cycle_between(double one, double other) {
        int resting = 0;
        for (int half = 0; half < 6; ++half) {
            go_to(0.5 * (one + other), false);
            resting = model_.system().contact().resting().multipliers().count();
            go_to(half % 2 == 0 ? other : one, true);
        }
        return resting;
    }
    [[nodiscard]] int closed() const {
        return static_cast<int>(std::ranges::count_if(model_.system().contact().statuses(), fine::is_closed));
    }
};

TEST_P(RestingFaces, WhereTheyTouchAndWhereTheyAreApart) {
    go_to(-2e-4, false);
    const int all = closed();
    EXPECT_GT(all, 5);
    EXPECT_GT(cycle_between(-4e-4, -2e-4), all / 2);
    go_to(2e-4, true);  // they part, at rest
    EXPECT_EQ(closed(), 0);
    EXPECT_GT(cycle_between(4e-4, 2e-4), all / 2);
    go_to(-2e-4, true);  // and meet
    EXPECT_GT(closed(), 5);
}

INSTANTIATE_TEST_SUITE_P(Friction, RestingFaces, testing::Values(0.0, 0.6),
                         [](const auto& test) { return test.param > 0.0 ? "rough" : "smooth"; });

TEST(FineModel, ARolledBackAttemptLeavesNoTrace) {
    FineModel model(scene);
    model.set_patch(patch);
    follow(model, 0.0, 1e-3);
    const PatchResponse first = settled(model, stretched(1.2e-3));
    for (const int iteration : {0, 1, 2}) {  // far away, and not settled
        model.request({.iteration = iteration, .predictor = 0.5, .boundary = stretched(-1e-2)});
        model.collect();
    }
    model.rollback();
    const PatchResponse again = settled(model, stretched(1.2e-3));
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
        static_cast<void>(settled(model, stretched(1e-3)));
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
    const PatchResponse response = settled(model, stretched(1e-3));
    EXPECT_TRUE(response.digest.status.empty() && response.digest.multiplier.empty());
    const coupling::StepReport report = model.commit({});
    EXPECT_FALSE(report.faces.empty());
    for (const coupling::FaceSample& face : report.faces)
        EXPECT_TRUE(face.opening > 0.0 && face.pressure == 0.0 && face.status == 0) << face.s;
    EXPECT_EQ(report.multipliers + report.work.interface_elements + report.work.gaps_evaluated, 0);
}

}  // namespace
}  // namespace stria::test
