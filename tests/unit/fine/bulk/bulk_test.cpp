// The bulk of the zone: repeatable evaluation, tangents, history that survives an extension.
#include "common/enrichment/part_of_mesh.hpp"
#include "fine/bulk/bulk_report.hpp"
#include "fine/bulk/bulk_summary.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/index.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"
#include "tests/support/plate_bulk.hpp"

namespace stria::test {
namespace {

using coupling::ZoneState;
using fine::Bulk;

const Case scene = plate_case({{0.0, 2.4}, {2.3, 2.6}});  // ends inside the plate: cut, tip and plain elements
const EnrichedMesh plate = plate_mesh(5, 5, scene);

/// A bulk that yielded and unloaded in part.
Bulk strained_bulk(const EnrichedMesh& mesh) {
    Bulk bulk = make_bulk(mesh, scene);
    for (const unsigned seed : {1U, 2U}) {
        bulk.evaluate(random_vector(mesh.unknowns, 4e-3, seed));
        bulk.commit(false);
    }
    return bulk;
}

Eigen::VectorXd times_tangent(const Bulk& bulk, const Eigen::VectorXd& v) {
    Eigen::VectorXd product = Eigen::VectorXd::Zero(v.size());
    for (int e = 0; e < bulk.elements().count(); ++e) {
        const std::vector<int>& unknowns = bulk.elements().op(e).unknowns;
        product(unknowns) += bulk.tangent(e) * v(unknowns);
    }
    return product;
}

std::vector<Eigen::MatrixXd> tangents_of(const Bulk& bulk) {
    std::vector<Eigen::MatrixXd> tangents;
    for (int e = 0; e < bulk.elements().count(); ++e) tangents.push_back(bulk.tangent(e));
    return tangents;
}

int yielding(const Bulk& bulk) {
    int sum = 0;
    for (const int count : yielding_points(bulk)) sum += count;
    return sum;
}

TEST(Bulk, EvaluatingTwiceGivesTheSameBits) {
    Bulk bulk = strained_bulk(plate);
    const Eigen::VectorXd u = random_vector(plate.unknowns, 4e-3, 3), other = random_vector(plate.unknowns, 8e-3, 4);
    bulk.evaluate(u);
    const Eigen::VectorXd force = bulk.internal_force();
    const std::vector<Eigen::MatrixXd> tangents = tangents_of(bulk);
    for (const Eigen::VectorXd& between : {u, other}) {  // what was tried in between leaves no trace
        bulk.evaluate(between);
        bulk.evaluate(u);
        EXPECT_EQ(bulk.internal_force(), force);
        EXPECT_EQ(tangents_of(bulk), tangents);
    }
}

TEST(Bulk, NamesTheElementsWhoseTangentChanged) {
    Bulk bulk = strained_bulk(plate);
    for (const unsigned seed : {5U, 6U, 7U}) {
        const std::vector<Eigen::MatrixXd> before = tangents_of(bulk);
        bulk.evaluate(bulk.committed_displacement() + random_vector(plate.unknowns, 3e-4 * (seed - 4), seed));
        for (int e = 0; e < bulk.elements().count(); ++e)
            EXPECT_TRUE(bulk.changed().contains(e) || bulk.tangent(e) == before[at(e)]) << e;
    }
}

TEST(Bulk, TangentIsTheDerivativeOfTheForce) {
    Bulk bulk = strained_bulk(plate);
    for (const unsigned seed : {3U, 4U, 5U}) {
        const Eigen::VectorXd u = bulk.committed_displacement() + random_vector(plate.unknowns, 3e-3, seed);
        const Eigen::VectorXd v = random_vector(plate.unknowns, 1.0, seed + 10);
        constexpr double h = 1e-9;
        bulk.evaluate(u + h * v);
        Eigen::VectorXd difference = bulk.internal_force();
        bulk.evaluate(u - h * v);
        difference = (difference - bulk.internal_force()) / (2.0 * h);
        bulk.evaluate(u);
        EXPECT_GT(yielding(bulk), bulk.history().points() / 4);
        EXPECT_LT((times_tangent(bulk, v) - difference).norm(), 1e-6 * difference.norm()) << seed;
        bulk.commit(false);
    }
}

// Its forces are those of the flow, and so is what is told of it.
TEST(Bulk, WhatFlowsSlightlyKeepsItsElasticTangent) {
    Bulk bulk = strained_bulk(plate);
    const Eigen::VectorXd u = bulk.committed_displacement() + random_vector(plate.unknowns, 1e-3, 3);
    bulk.evaluate(u);
    const Eigen::VectorXd force = bulk.internal_force();
    const int yields = yielding(bulk), softened = bulk.softened().count();
    const double most = largest_plastic_increment(bulk), slight = 0.3 * most;
    bulk.evaluate(u, false, slight);
    EXPECT_EQ(bulk.internal_force(), force);
    EXPECT_EQ(yielding(bulk), yields);
    EXPECT_EQ(largest_plastic_increment(bulk), most);
    EXPECT_GT(bulk.softened().count(), 0);
    EXPECT_LT(bulk.softened().count(), softened);
    for (int e = 0; e < bulk.elements().count(); ++e) {
        EXPECT_EQ(bulk.softened().contains(e), bulk.history().largest_plastic_increment(e) >= slight) << e;
        if (bulk.softened().contains(e)) continue;
        EXPECT_EQ(bulk.tangent(e), bulk.elements().stiffness()[at(e)]) << e;
    }
    bulk.evaluate(u);
    EXPECT_EQ(bulk.softened().count(), softened);
}

// As if no point flowed: forces are linear in the way, and none of that is left afterwards.
TEST(Bulk, IsElasticWhereItIsToldTo) {
    Bulk bulk = strained_bulk(plate);
    const Eigen::VectorXd from = bulk.committed_displacement(), way = random_vector(plate.unknowns, 4e-3, 3);
    bulk.evaluate(from + way);
    const Eigen::VectorXd flown = bulk.internal_force();
    ASSERT_GT(yielding(bulk), 0);
    bulk.evaluate(from, true);
    const Eigen::VectorXd start = bulk.internal_force();
    for (const double part : {0.5, 2.0}) {
        bulk.evaluate(from + part * way, true);
        EXPECT_EQ(yielding(bulk), 0);
        const Eigen::VectorXd linear = start + part * times_tangent(bulk, way);
        EXPECT_LT((bulk.internal_force() - linear).norm(), 1e-12 * linear.norm());
    }
    EXPECT_GT((bulk.internal_force() - start - 2.0 * (flown - start)).norm(), 1e-2 * flown.norm());
    bulk.evaluate(from + way);
    EXPECT_EQ(bulk.internal_force(), flown);
}

// An inner crack from tip to tip in a plate of 9 x 5 that has yielded everywhere: to the left of the middle a tip sees
// no point farther off than the corner, to the right the other one.
TEST(Bulk, PlasticPointsBelongToTheNearestTip) {
    const Case inner = plate_case({{2.3, 2.4}, {6.7, 2.6}});
    const EnrichedMesh mesh = plate_mesh(9, 5, inner);
    ASSERT_EQ(mesh.tips.size(), 2U);
    Bulk bulk = make_bulk(mesh, inner);
    bulk.evaluate(random_vector(mesh.unknowns, 4e-2, 1));
    bulk.commit(false);
    for (const auto& [flow, flow_ever] : fine::BulkSummary(bulk).plastic_extents(mesh)) {
        ASSERT_EQ(flow.size(), 1U);
        EXPECT_GT(flow[0].reach, 3.0);
        EXPECT_LT(flow[0].reach, std::hypot(2.3, 2.6));
        EXPECT_DOUBLE_EQ(flow_ever.at(0).reach, flow[0].reach);
        EXPECT_LT(flow[0].axis, 2.4);
        EXPECT_GT(flow[0].axis, 1.8);
    }
}

TEST(Bulk, ElasticBulkIsLinear) {
    const Case elastic = plate_case(scene.cracks[0].points, false);
    const Eigen::VectorXd u = random_vector(plate.unknowns, 1e-2, 1);
    Bulk bulk = make_bulk(plate, elastic, u);
    bulk.evaluate(u);
    const Eigen::VectorXd force = times_tangent(bulk, u);
    EXPECT_LT((bulk.internal_force() - force).norm(), 1e-13 * force.norm());
    EXPECT_EQ(yielding(bulk), 0);
}

void expect_elastic_stress(const Bulk& bulk, const ZoneState& state, const std::vector<char>& known) {
    const MandelMatrix C = elasticity_of(scene.material, scene.model.plane).stiffness();
    std::size_t point = 0;
    for (std::size_t e = 0; e < bulk.operators().size(); ++e) {
        const ElementOperator& op = bulk.operators()[e];
        for (std::size_t q = 0; q < op.points.size(); ++q, ++point) {
            if (known[e] != 0) continue;
            const Mandel stress = C * op.strain(gather(bulk.committed_displacement(), op.unknowns), q);
            EXPECT_EQ(Mandel(state.stress.data() + 4 * point), stress);
        }
    }
}

TEST(Bulk, ExtensionKeepsHistoryBitForBit) {
    const std::vector<int> inner{6, 7, 11, 12, 16, 17};
    std::vector<int> outer(25);
    for (int e = 0; e < 25; ++e) outer[at(e)] = e;
    const EnrichedMesh smaller = extract(plate, inner), larger = extract(plate, outer);
    Bulk old = strained_bulk(smaller);
    const ZoneState before = state_of(old);
    const Eigen::VectorXd u =
        carry_over(smaller, old.committed_displacement(), larger, random_vector(larger.unknowns, 1e-3, 8));
    const Bulk bulk = make_bulk(larger, scene, u, &old);

    const ZoneState now = state_of(bulk);
    std::vector<char> known(outer.size(), 0);
    std::size_t kept = 0;
    for (std::size_t point = 0; point < now.element.size(); ++point) {
        const auto found =
            std::ranges::find(inner, now.element[point]);  // element k of `larger` is element k of the plate
        if (found == inner.end()) continue;
        known[at(now.element[point])] = 1;
        EXPECT_EQ(before.element[kept], found - inner.begin());
        for (std::size_t c = 0; c < 4; ++c) {
            EXPECT_EQ(now.stress[4 * point + c], before.stress[4 * kept + c]);
            EXPECT_EQ(now.plastic_strain[4 * point + c], before.plastic_strain[4 * kept + c]);
        }
        EXPECT_EQ(now.accumulated[point], before.accumulated[kept++]);
    }
    EXPECT_EQ(kept, before.element.size());
    EXPECT_GT(*std::ranges::max_element(before.accumulated), 1e-3);
    expect_elastic_stress(bulk, now, known);
}

// Forces, derivatives and tangents that a bulk has from the last one are those that a resumed run finds again.
TEST(Bulk, WhatItTakesOverIsAsIfItHadBeenMadeAnew) {
    Bulk old = make_bulk(plate, scene);
    Eigen::VectorXd u = random_vector(plate.unknowns, 4e-3, 1);
    u.tail(plate.unknowns / 2) *= 0.03;  // much of it does not yield
    old.evaluate(u);
    old.commit(false);
    Bulk bulk = make_bulk(plate, scene, u, &old);
    coupling::ZoneSnapshot snapshot;
    bulk.remember(snapshot);
    snapshot.displacement = u;
    const Materials materials(scene);
    Bulk anew(plate, materials, fine::make_material_laws(materials), {.subcells = 2, .tip_points = 4}, snapshot);
    ASSERT_GT(bulk.elements().count(), bulk.elements().built());
    for (const double size : {1e-6, 1e-5, 1e-4, 1e-3}) {
        const Eigen::VectorXd trial = u + random_vector(plate.unknowns, size, 3);
        for (Bulk* each : {&bulk, &anew}) each->evaluate(trial);
        EXPECT_EQ(bulk.internal_force(), anew.internal_force());
        EXPECT_EQ(tangents_of(bulk), tangents_of(anew));
        EXPECT_EQ(bulk.counts().points_proven_elastic - old.counts().points_proven_elastic,
                  anew.counts().points_proven_elastic);
    }
    EXPECT_GT(anew.counts().points_proven_elastic, 0);
    EXPECT_GT(yielding(anew), 0);
}

}  // namespace
}  // namespace stria::test
