// The bulk of the zone: repeatable evaluation, tangents, history that survives an extension, two-sided patches.
#include "fine/bulk/zone.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "common/index.hpp"
#include "tests/support/material_point.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

using coupling::ZoneState;
using fine::Zone;

const Case scene = plate_case({{0.0, 2.4}, {2.3, 2.6}});  // ends inside the plate: cut, tip and plain elements
const EnrichedMesh plate = plate_mesh(5, 5, scene);

Zone make_zone(const EnrichedMesh& mesh, const Case& input, const Eigen::VectorXd& displacement,
               const Zone* old = nullptr) {
    return {mesh,
            fine::make_material_law(input.material, input.model.plane),
            elasticity_of(input.material, input.model.plane),
            IntegrationRule{.subcells = 2, .tip_points = 4},
            old,
            displacement};
}

Zone make_zone(const EnrichedMesh& mesh, const Case& input) {
    return make_zone(mesh, input, Eigen::VectorXd::Zero(mesh.unknowns));
}

ZoneState state_of(const Zone& zone) {
    ZoneState state;
    zone.describe(state);
    return state;
}

/// A zone that flowed and unloaded in part.
Zone strained_zone(const EnrichedMesh& mesh) {
    Zone zone = make_zone(mesh, scene);
    for (const unsigned seed : {1U, 2U}) {
        zone.evaluate(random_vector(mesh.unknowns, 4e-3, seed));
        zone.commit(false);
    }
    return zone;
}

Eigen::VectorXd times_tangent(const Zone& zone, const Eigen::VectorXd& v) {
    Eigen::VectorXd product = Eigen::VectorXd::Zero(v.size());
    for (std::size_t e = 0; e < zone.operators().size(); ++e) {
        const std::vector<int>& unknowns = zone.operators()[e].unknowns;
        product(unknowns) += zone.tangents()[e] * v(unknowns);
    }
    return product;
}

int yielding(const Zone& zone) {
    int sum = 0;
    for (const int count : zone.yielding_points()) sum += count;
    return sum;
}

TEST(Zone, EvaluatingTwiceGivesTheSameBits) {
    Zone zone = strained_zone(plate);
    const Eigen::VectorXd u = random_vector(plate.unknowns, 4e-3, 3), other = random_vector(plate.unknowns, 8e-3, 4);
    zone.evaluate(u);
    const Eigen::VectorXd force = zone.internal_force();
    const std::vector<Eigen::MatrixXd> tangents(zone.tangents().begin(), zone.tangents().end());
    for (const Eigen::VectorXd& between : {u, other}) {  // what was tried in between leaves no trace
        zone.evaluate(between);
        zone.evaluate(u);
        EXPECT_EQ(zone.internal_force(), force);
        EXPECT_TRUE(std::ranges::equal(zone.tangents(), tangents));
    }
}

TEST(Zone, NamesTheElementsWhoseTangentChanged) {
    Zone zone = strained_zone(plate);
    for (const unsigned seed : {5U, 6U, 7U}) {
        const std::vector<Eigen::MatrixXd> before(zone.tangents().begin(), zone.tangents().end());
        zone.evaluate(zone.committed_displacement() + random_vector(plate.unknowns, 3e-4 * (seed - 4), seed));
        for (std::size_t e = 0; e < before.size(); ++e) {
            EXPECT_TRUE(zone.changed()[e] != 0 || zone.tangents()[e] == before[e]) << e;
        }
    }
}

TEST(Zone, TangentIsTheDerivativeOfTheForce) {
    Zone zone = strained_zone(plate);
    for (const unsigned seed : {3U, 4U, 5U}) {
        const Eigen::VectorXd u = zone.committed_displacement() + random_vector(plate.unknowns, 3e-3, seed);
        const Eigen::VectorXd v = random_vector(plate.unknowns, 1.0, seed + 10);
        constexpr double h = 1e-9;
        zone.evaluate(u + h * v);
        Eigen::VectorXd difference = zone.internal_force();
        zone.evaluate(u - h * v);
        difference = (difference - zone.internal_force()) / (2.0 * h);
        zone.evaluate(u);
        EXPECT_GT(yielding(zone), zone.points() / 4);
        EXPECT_LT((times_tangent(zone, v) - difference).norm(), 1e-6 * difference.norm()) << seed;
        zone.commit(false);
    }
}

TEST(Zone, ElasticZoneIsLinear) {
    const Case elastic = plate_case(scene.cracks[0].points, false);
    const Eigen::VectorXd u = random_vector(plate.unknowns, 1e-2, 1);
    Zone zone = make_zone(plate, elastic, u);
    zone.evaluate(u);
    const Eigen::VectorXd force = times_tangent(zone, u);
    EXPECT_LT((zone.internal_force() - force).norm(), 1e-13 * force.norm());
    EXPECT_EQ(yielding(zone), 0);
}

void expect_elastic_stress(const Zone& zone, const ZoneState& state, const std::vector<char>& known) {
    const MandelMatrix C = elasticity_of(scene.material, scene.model.plane).stiffness();
    std::size_t point = 0;
    for (std::size_t e = 0; e < zone.operators().size(); ++e) {
        const ElementOperator& op = zone.operators()[e];
        for (std::size_t q = 0; q < op.points.size(); ++q, ++point) {
            if (known[e] != 0) continue;
            const Mandel stress = C * op.strain(gather(zone.committed_displacement(), op.unknowns), q);
            EXPECT_EQ(Mandel(state.stress.data() + 4 * point), stress);
        }
    }
}

TEST(Zone, ExtensionKeepsHistoryBitForBit) {
    const std::vector<int> inner{6, 7, 11, 12, 16, 17};
    std::vector<int> outer(25);
    for (int e = 0; e < 25; ++e) outer[at(e)] = e;
    const Zone old = strained_zone(extract(plate, inner));
    const EnrichedMesh larger = extract(plate, outer);
    const Zone zone = make_zone(larger, scene, random_vector(larger.unknowns, 1e-3, 8), &old);

    const ZoneState before = state_of(old), now = state_of(zone);
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
    expect_elastic_stress(zone, now, known);
}

/// A crack through the whole plate; each side is strained uniformly beyond yield, in two steps along different paths.
class TwoSidedPatch : public testing::TestWithParam<std::pair<Vec2, Vec2>> {};

TEST_P(TwoSidedPatch, EachSideHasItsOwnUniformStress) {
    const auto& [from, to] = GetParam();
    const Case input = plate_case({from, to});
    const EnrichedMesh mesh = plate_mesh(5, 5, input);
    Zone zone = make_zone(mesh, input);
    std::array<MaterialPoint, 2> expected{MaterialPoint(input.material), MaterialPoint(input.material)};
    using Gradient = Eigen::Matrix2d;
    const std::array above{Gradient{{4e-3, 1e-3}, {-2e-3, 1e-3}}, Gradient{{-2e-3, 3e-3}, {1e-3, 6e-3}}};
    const std::array below{Gradient{{-3e-3, 2e-3}, {2e-3, 4e-3}}, Gradient{{5e-3, 0.0}, {-1e-3, -4e-3}}};
    Gradient last_above = Gradient::Zero(), last_below = last_above;
    for (std::size_t step = 0; step < 2; ++step) {
        zone.evaluate(two_sided(
            mesh, from, to, [&](const Vec2& x) -> Vec2 { return above[step] * x; },
            [&](const Vec2& x) -> Vec2 { return below[step] * x; }));
        zone.commit(false);
        expected[0].strain_by(strain_of(above[step] - last_above));
        expected[1].strain_by(strain_of(below[step] - last_below));
        last_above = above[step];
        last_below = below[step];
    }
    const ZoneState state = state_of(zone);
    const Vec2 normal(from.y() - to.y(), to.x() - from.x());
    for (std::size_t point = 0; point < state.x.size(); ++point) {
        const bool is_above = (Vec2(state.x[point], state.y[point]) - from).dot(normal) > 0.0;
        const Mandel stress = expected[is_above ? 0 : 1].last().stress();
        EXPECT_LT((Mandel(state.stress.data() + 4 * point) - stress).norm(), 1e-12 * stress.norm());
        EXPECT_GT(state.accumulated[point], 1e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Angles, TwoSidedPatch,
                         testing::Values(std::pair{Vec2{0.0, 2.4}, Vec2{5.0, 2.4}},
                                         std::pair{Vec2{0.0, 1.2}, Vec2{5.0, 3.9}},
                                         std::pair{Vec2{1.3, 0.0}, Vec2{3.1, 5.0}},
                                         std::pair{Vec2{0.0, 0.7}, Vec2{4.6, 5.0}},
                                         std::pair{Vec2{0.0, 2.001}, Vec2{5.0, 2.002}},  // slivers
                                         std::pair{Vec2{0.0, 3.3}, Vec2{5.0, 1.05}}));

}  // namespace
}  // namespace stria::test
