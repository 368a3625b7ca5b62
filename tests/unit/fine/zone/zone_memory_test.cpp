// What a zone remembers from one mesh to the next.
#include "fine/zone/zone_memory.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "common/enrichment/part_of_mesh.hpp"
#include "common/index.hpp"
#include "fine/zone/fine_model.hpp"
#include "tests/support/cut_plate.hpp"

namespace stria::test {
namespace {

// A block that has slid by 0.01 mm, and by 0.002 mm less than its faces remember: part of that was functions that have
// gone. It moves on to 0.03 mm.
TEST(ZoneMemory, HoldsFacesWhereTheyHaveSlidUntilEquilibrium) {
    const Cut cut(2.4, 2.4, 0.0, 0.4);
    const auto slid_by = [&](double slip) { return cut.opened([=](const Vec2&) { return Vec2(-slip, 0.0); }); };
    const Eigen::VectorXd committed = slid_by(0.01), now = slid_by(0.03);
    ContactInterface before = cut.contact();
    const ContactInterface next = cut.contact();
    before.settle(committed);
    EXPECT_EQ(fine::slips_to_hold(before, committed, next, now), next.operators().slips(now)) << "nothing is held";
    const Eigen::VectorXd gone = Eigen::VectorXd::Constant(before.multipliers(), 0.002);
    before.hold_slips(before.settled_slips() + gone);
    const Eigen::VectorXd held = fine::slips_to_hold(before, committed, next, now);
    EXPECT_LT((held - (next.operators().slips(now) + gone)).cwiseAbs().maxCoeff(), 1e-15);
    EXPECT_NEAR(before.operators().slips(committed).cwiseAbs().maxCoeff(), 0.01, 1e-12);
}

// Those of a mesh without the old faces' multipliers begin where they are.
TEST(ZoneMemory, HoldsNoSlipOfNewFaces) {
    const Cut cut(2.4, 2.4, 0.0, 0.4), other(3.4, 3.4, 0.0, 0.4);
    const Eigen::VectorXd still = Eigen::VectorXd::Zero(cut.mesh.unknowns);
    ContactInterface before = cut.contact();
    before.settle(still);
    before.hold_slips(Eigen::VectorXd::Constant(before.multipliers(), 0.002));
    const ContactInterface next = other.contact();
    EXPECT_TRUE(fine::slips_to_hold(before, still, next, Eigen::VectorXd::Zero(other.mesh.unknowns)).isZero(0.0));
}

/// The first columns of 12 x 7 unit elements with a crack to x as a zone, under a uniform strain across it.
coupling::Patch columns_as_zone(int columns, double x, const Field& field) {
    const EnrichedMesh whole = plate_mesh(12, 7, plate_case({{0.0, 3.4}, {x, 3.4}}, false), 1);
    std::vector<int> elements;
    for (int e = 0; e < 12 * 7; ++e)
        if (e % 12 < columns) elements.push_back(e);
    coupling::Patch zone = plate_patch(extract(whole, elements));
    zone.boundary.clear();
    for (const auto& [node, term, unknown] : zone.mesh.own_unknowns()) {
        const Vec2& at_node = zone.mesh.nodes[at(node)];
        if (term == 0) zone.displacement.segment<2>(unknown) = field(at_node);
        const bool inside = at_node.x() > 0.0 && at_node.x() < columns && at_node.y() > 0.0 && at_node.y() < 7.0;
        if (!inside) zone.boundary.insert(zone.boundary.end(), {unknown, unknown + 1});
    }
    std::ranges::sort(zone.boundary);
    return zone;
}

// A zone of which nothing may yield lets go of functions. Elements that join it with the growth push at their nodes as
// they did before, from outside: they have come out of no balance.
TEST(ZoneMemory, HoldsNothingAgainstElementsThatJoin) {
    const Field pulled = [](const Vec2& x) { return Vec2(0.0, 1e-3 * x.y()); };
    const coupling::Patch before = columns_as_zone(7, 3.3, pulled), next = columns_as_zone(10, 4.3, pulled);
    fine::FineModel model(plate_case({{0.0, 3.4}, {3.3, 3.4}}, false));
    model.set_patch(before);
    for (int iteration = 0; iteration < 6; ++iteration) {
        model.request({.iteration = iteration, .boundary = gather(before.displacement, before.boundary)});
        static_cast<void>(model.collect());
    }
    model.commit({});
    model.set_patch(next);
    const Eigen::VectorXd held = model.snapshot().held;
    double about_tip = 0.0, where_they_join = 0.0;
    for (const auto& [node, term, unknown] : next.mesh.own_unknowns()) {
        double& largest = next.mesh.nodes[at(node)].x() > 6.5 ? where_they_join : about_tip;
        largest = std::max(largest, held.segment<2>(unknown).norm());
    }
    EXPECT_GT(about_tip, 1.0);
    EXPECT_LT(where_they_join, 1e-9 * about_tip);
}

}  // namespace
}  // namespace stria::test
