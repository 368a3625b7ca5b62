// A plate that a crack cuts in two: each side has its own uniform stress.
#include "fine/bulk/bulk_report.hpp"

#include <gtest/gtest.h>

#include "tests/support/material_point.hpp"
#include "tests/support/plate_bulk.hpp"

namespace stria::test {
namespace {

using coupling::ZoneState;
using fine::Bulk;

/// A crack through the whole plate; each side is strained uniformly beyond yield, in two steps along different paths.
class TwoSidedPatch : public testing::TestWithParam<std::pair<Vec2, Vec2>> {};

TEST_P(TwoSidedPatch, EachSideHasItsOwnUniformStress) {
    const auto& [from, to] = GetParam();
    const Case input = plate_case({from, to});
    const EnrichedMesh mesh = plate_mesh(5, 5, input);
    Bulk bulk = make_bulk(mesh, input);
    std::array<MaterialPoint, 2> expected{MaterialPoint(input.material), MaterialPoint(input.material)};
    using Gradient = Eigen::Matrix2d;
    const std::array above{Gradient{{4e-3, 1e-3}, {-2e-3, 1e-3}}, Gradient{{-2e-3, 3e-3}, {1e-3, 6e-3}}};
    const std::array below{Gradient{{-3e-3, 2e-3}, {2e-3, 4e-3}}, Gradient{{5e-3, 0.0}, {-1e-3, -4e-3}}};
    Gradient last_above = Gradient::Zero(), last_below = last_above;
    for (std::size_t step = 0; step < 2; ++step) {
        bulk.evaluate(two_sided(
            mesh, from, to, [&](const Vec2& x) -> Vec2 { return above[step] * x; },
            [&](const Vec2& x) -> Vec2 { return below[step] * x; }));
        bulk.commit(false);
        expected[0].strain_by(strain_of(above[step] - last_above));
        expected[1].strain_by(strain_of(below[step] - last_below));
        last_above = above[step];
        last_below = below[step];
    }
    const ZoneState state = state_of(bulk);
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
