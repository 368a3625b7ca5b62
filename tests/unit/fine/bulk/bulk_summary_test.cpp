// What a bulk has stored and dissipated and where it flows, kept up from commit to commit.
#include "fine/bulk/bulk_summary.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "common/index.hpp"
#include "tests/support/plate_bulk.hpp"
#include "tests/support/point_histories.hpp"

namespace stria::test {
namespace {

using fine::Bulk;

// The corners behind the tip are farther off than those ahead. Where nothing flows but the faces, a tip has no zone.
TEST(BulkSummary, CountsNoFlowOfTheWake) {
    const Case edge = plate_case({{0.0, 2.4}, {3.3, 2.6}});
    const EnrichedMesh mesh = plate_mesh(6, 5, edge);
    const Eigen::VectorXd u = random_vector(mesh.unknowns, 4e-2, 1);
    const auto extents_at = [&](const Eigen::VectorXd& displacement) {
        Bulk bulk = make_bulk(mesh, edge);
        bulk.evaluate(displacement);
        bulk.commit(false);
        return fine::BulkSummary(bulk).plastic_extents(mesh)[0];
    };
    const auto everywhere = extents_at(u);
    EXPECT_GT(everywhere.flow_ever.at(0).reach, 3.8);
    EXPECT_GT(everywhere.flow.at(0).reach, 3.0);
    EXPECT_LT(everywhere.flow.at(0).reach, std::hypot(6.0 - 3.3, 2.6));
    Eigen::VectorXd at_the_mouth = Eigen::VectorXd::Zero(mesh.unknowns);
    for (int node = 0; node < std::ssize(mesh.nodes); ++node) {
        const Vec2& x = mesh.nodes[at(node)];
        if (x.x() > 0.5 || std::abs(x.y() - 2.5) > 1.0) continue;
        const int first = mesh.unknown(node, 0, 0);
        at_the_mouth.segment<2>(first) = u.segment<2>(first);
    }
    const auto wake = extents_at(at_the_mouth);
    EXPECT_FALSE(wake.flow_ever.empty());
    EXPECT_TRUE(wake.flow.empty());
}

// Rounding decides which points that come back to the yield stress flow by as little.
TEST(BulkSummary, CountsNoFlowOfRounding) {
    const PlatePoints plate;
    const Eigen::VectorXd u = random_vector(plate.mesh.unknowns, 4e-3, 1);
    const auto extents_at = [&](double scale) {
        Bulk bulk = make_bulk(plate.mesh, plate.input);
        bulk.evaluate(scale * u);
        bulk.commit(false);
        return fine::BulkSummary(bulk).plastic_extents(plate.mesh)[0];
    };
    const auto yields_at = [&](double scale) {
        Bulk bulk = make_bulk(plate.mesh, plate.input);
        bulk.evaluate(scale * u);
        bulk.commit(false);
        bool yields = false;
        for (int e = 0; e < bulk.elements().count(); ++e) yields = yields || bulk.history().is_plastic(e);
        return yields;
    };
    double elastic = 0.0, flows = 1.0;
    while (flows - elastic > 1e-6 * flows) {
        const double middle = 0.5 * (elastic + flows);
        (yields_at(middle) ? flows : elastic) = middle;
    }
    EXPECT_TRUE(extents_at(flows).flow_ever.empty());
    EXPECT_TRUE(extents_at(flows).flow.empty()) << "nor of a half cycle";
    EXPECT_FALSE(extents_at(1.1 * flows).flow_ever.empty());
    EXPECT_FALSE(extents_at(1.1 * flows).flow.empty());
}

// After each commit as if all of them had been looked at: at rest, woken, and in a new half cycle.
TEST(BulkSummary, LooksAtWhatMayHaveChanged) {
    const Case input = plate_case({{0.0, 2.4}, {3.3, 2.6}});
    const EnrichedMesh mesh = plate_mesh(6, 5, input);
    Bulk bulk = make_bulk(mesh, input);
    fine::BulkSummary summary(bulk);
    const Eigen::VectorXd u = random_vector(mesh.unknowns, 4e-2, 1);
    ElementSet half(bulk.elements().count());
    for (int e = 0; e < half.size(); e += 2) half.insert(e);
    const auto commit = [&](double share, bool reversal) {
        const bool begins = bulk.history().half_cycle_ended();
        bulk.evaluate(share * u);
        bulk.commit(reversal);
        summary.update(bulk, begins);
    };
    const auto expect_all_seen = [&] {
        const fine::BulkSummary anew(bulk);
        EXPECT_GT(anew.dissipation(), 0.0);
        EXPECT_DOUBLE_EQ(summary.dissipation(), anew.dissipation());
        EXPECT_DOUBLE_EQ(summary.stored_energy(), anew.stored_energy());
        for (std::size_t t = 0; t < mesh.tips.size(); ++t) {
            const auto seen = summary.plastic_extents(mesh)[t], all = anew.plastic_extents(mesh)[t];
            for (const auto shells :
                 {&fine::BulkSummary::PlasticExtent::flow, &fine::BulkSummary::PlasticExtent::flow_ever}) {
                ASSERT_EQ((seen.*shells).size(), (all.*shells).size());
                for (std::size_t k = 0; k < (all.*shells).size(); ++k) {
                    EXPECT_EQ((seen.*shells)[k].reach, (all.*shells)[k].reach);
                    EXPECT_EQ((seen.*shells)[k].axis, (all.*shells)[k].axis);
                }
            }
        }
    };
    commit(0.5, false);
    expect_all_seen();
    commit(1.0, true);
    expect_all_seen();
    bulk.rest(half, u);
    commit(0.99, false);  // nothing flows, and no zone is left of the half cycle before
    expect_all_seen();
    EXPECT_TRUE(summary.plastic_extents(mesh)[0].flow.empty());
    commit(0.0, false);
    bulk.wake_all_but(ElementSet(half.size()));
    for (const int e : half.members()) summary.look_at(bulk, e);
    expect_all_seen();
}

}  // namespace
}  // namespace stria::test
