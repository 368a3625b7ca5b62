// A tip that moves on inside its element changes nothing else: the zone stays, and answers as a new one would.
#include <gtest/gtest.h>

#include <algorithm>

#include "common/enrichment/same_functions.hpp"
#include "common/index.hpp"
#include "fine/zone/fine_model.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

using coupling::PatchResponse;
using fine::FineModel;

Case with_tip_at(double x) { return plate_case({{0.0, 5.5}, {x, 5.5}}); }
Case with_first_point_at(double x) { return plate_case({{x, 5.5}, {0.0, 5.5}}); }
EnrichedMesh mesh_with_tip_at(double x) { return plate_mesh(24, 11, with_tip_at(x), 0); }

Eigen::VectorXd pulled(const coupling::Patch& zone, double strain) {
    const Field pull = [&](const Vec2& x) { return Vec2(0.0, strain * (x.y() - 5.5)); };
    return gather(two_sided(zone.mesh, {0.0, 5.5}, {12.0, 5.5}, pull, pull), zone.boundary);
}

PatchResponse in_equilibrium(FineModel& model, const Eigen::VectorXd& boundary) {
    for (int iteration = 0; iteration < 30; ++iteration) {
        model.request({.iteration = iteration, .check_rest = true, .boundary = boundary});
        PatchResponse response = model.collect();
        if (response.interior_residual + response.contact_residual < 1e-11 * response.interior_force) return response;
    }
    throw std::runtime_error("the interior finds no equilibrium");
}

/// After a cycle in which metal flows at the tip.
void flow(FineModel& model, const coupling::Patch& zone) {
    model.set_patch(zone);
    for (const double strain : {2.5e-4, 5e-4, 7.5e-4, 1e-3, 7.5e-4, 5e-4, 2.5e-4, 0.0, 2.5e-4, 5e-4}) {
        in_equilibrium(model, pulled(zone, strain));
        model.commit({.reversal = strain == 1e-3 || strain == 0.0});
    }
}

TEST(MovedTips, AreNothingButMovedTips) {
    EXPECT_TRUE(same_but_for_tips(mesh_with_tip_at(12.2), mesh_with_tip_at(12.4)));
    EXPECT_FALSE(same_but_for_tips(mesh_with_tip_at(12.4), mesh_with_tip_at(13.2)));  // another element
    EXPECT_FALSE(same_but_for_tips(plate_mesh(24, 11, with_tip_at(12.2), 1), plate_mesh(24, 11, with_tip_at(12.4), 1)));
    EnrichedMesh turned = mesh_with_tip_at(12.4);
    std::vector<Vec2> nodes = turned.nodes.copy();
    nodes[3].y() += 1e-15;
    turned.nodes = std::move(nodes);
    EXPECT_FALSE(same_but_for_tips(mesh_with_tip_at(12.2), turned));
    EXPECT_TRUE(same_arc_lengths(mesh_with_tip_at(12.2), mesh_with_tip_at(12.2)));
}

TEST(MovedTips, LeaveTheZoneAsItIs) {
    const coupling::Patch before = plate_patch(mesh_with_tip_at(12.2)), after = plate_patch(mesh_with_tip_at(12.4));
    coupling::Patch anew =
        after;  // none of its elements is a part of another one, but the zone asks element by element
    anew.part_of.assign(after.mesh.elements.size(), -1);
    FineModel model(with_tip_at(12.2)), other(with_tip_at(12.2));
    for (FineModel* each : {&model, &other}) {
        flow(*each, before);
        for (int iteration = 0; iteration < 3; ++iteration) {  // an attempt in which faces meet
            each->request({.iteration = iteration, .boundary = pulled(before, -3e-4)});
            EXPECT_EQ(std::ranges::count(each->collect().digest.status, 1) > 0, iteration > 0);
        }
        each->rollback();
    }
    model.set_patch(after);
    other.set_patch(anew);
    const Eigen::MatrixXd increments = other.increments();
    EXPECT_GT(increments.cols(), 0);
    ASSERT_EQ(model.increments().cols(), increments.cols());
    EXPECT_LT((model.increments() - increments).norm(), 1e-12 * increments.norm());
    for (const double strain : {7e-4, 9e-4, 1.1e-3, 9e-4, 6e-4, 3e-4, 0.0, -3e-4, 0.0, 3e-4}) {
        const PatchResponse response = in_equilibrium(model, pulled(after, strain));
        const PatchResponse expected = in_equilibrium(other, pulled(after, strain));
        EXPECT_GT(expected.force.norm(), 1.0);
        EXPECT_LT((response.force - expected.force).norm(), 1e-12 * expected.force.norm());
        EXPECT_EQ(response.digest.yielding_points, expected.digest.yielding_points);
        EXPECT_EQ(response.digest.status, expected.digest.status);
        EXPECT_EQ(std::ranges::count(response.digest.status, 1) > 0, strain <= 0.0);
        const coupling::StepReport report = model.commit({}), wanted = other.commit({});
        ASSERT_EQ(report.tips.size(), 1U);
        EXPECT_FALSE(wanted.tips[0].flow_ever.empty());
        for (const auto shells : {&coupling::TipReport::flow, &coupling::TipReport::flow_ever}) {
            const auto &own = report.tips[0].*shells, &others = wanted.tips[0].*shells;
            ASSERT_EQ(own.size(), others.size());
            for (std::size_t k = 0; k < own.size(); ++k) EXPECT_NEAR(own[k].reach, others[k].reach, 1e-12);
        }
        EXPECT_NEAR(report.energy.stored, wanted.energy.stored, 1e-12 * wanted.energy.stored);
        EXPECT_EQ(report.work.fronts_refactored, wanted.work.fronts_refactored);  // a new tree takes them over
    }
}

// What faces bear is known by its place along the crack, and that counts from there.
TEST(MovedTips, ThatAreFirstPointsMakeTheZoneAnew) {
    const auto patch_with = [](double x) { return plate_patch(plate_mesh(24, 11, with_first_point_at(x), 0)); };
    const coupling::Patch before = patch_with(12.2), after = patch_with(12.4);
    FineModel model(with_first_point_at(12.2));
    flow(model, before);
    model.set_patch(after);
    for (const double strain : {7e-4, 3e-4, -3e-4}) {
        const PatchResponse response = in_equilibrium(model, pulled(after, strain));
        EXPECT_GT(response.force.norm(), 1.0) << strain;
        const std::vector<coupling::FaceSample> faces = model.commit({}).faces;
        ASSERT_FALSE(faces.empty());
        for (const coupling::FaceSample& face : faces) {
            EXPECT_NEAR(face.s, 12.4 - face.x, 1e-12);
            EXPECT_EQ(face.pressure > 0.0, strain < 0.0) << face.x;
        }
    }
}

}  // namespace
}  // namespace stria::test
