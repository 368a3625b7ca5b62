// The exact singular fields on the boundary of a square with a crack to its middle: energy-norm and K errors.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>

#include "coarse/fracture_parameters.hpp"
#include "tests/support/elastic_scene.hpp"

namespace stria::test {
namespace {

const Elasticity unit{1.0, 0.3};

TEST(WilliamsField, MatchesReferenceValues) {  // REFERENCES 2.6: K = 1, r = 1
    const Tip tip{.crack = 0, .position = {0.0, 0.0}, .direction = {1.0, 0.0}, .s = 0.0, .upper = 1};
    const Vec2 at_60(0.5, std::sqrt(0.75));
    EXPECT_LT((williams_field(1, tip, at_60, 0, unit).displacement - Vec2(0.583885, 0.337106)).norm(), 1e-6);
    EXPECT_LT((williams_field(2, tip, at_60, 0, unit).displacement - Vec2(1.115044, -0.134743)).norm(), 1e-6);
    EXPECT_NEAR(williams_field(1, tip, {-1.0, 0.0}, 1, unit).displacement.y(), 1.452150, 1e-6);
}

TEST(WilliamsField, FacesAreFreeOfTraction) {
    const Tip tip{.crack = 0, .position = {0.2, 0.1}, .direction = {0.6, 0.8}, .s = 0.0, .upper = 1};
    for (const int mode : {1, 2}) {
        for (const int side : {1, -1}) {
            const WilliamsField field = williams_field(mode, tip, tip.position - 0.7 * tip.direction, side, unit);
            EXPECT_LT((in_plane(field.stress) * Vec2(-0.8, 0.6)).norm(), 1e-14);
        }
    }
}

/// Holds every boundary unknown at the exact field: standard ones at the nodes, jumps on the edge that the crack
/// crosses.
void impose(coarse::Scene& scene, int mode) {
    const EnrichedMesh& mesh = scene.enriched;
    const Tip& tip = mesh.tips.front();
    std::vector<coarse::PrescribedUnknown> held;
    for (const int node : boundary_nodes(scene.mesh)) {
        const Vec2& x = mesh.nodes[at(node)];
        const Vec2 u = williams_field(mode, tip, x, 0, scene.elastic).displacement;
        for (int c = 0; c < 2; ++c) held.push_back({mesh.unknown(node, 0, c), u[c]});
        if (heaviside_side(mesh, node) == 0.0) continue;
        const CrackPiece& mouth = mesh.pieces.front();  // the jump is nearly the same on both nodes of its edge
        const Vec2& m = mouth.points.front();
        const Vec2 jump = williams_field(mode, tip, m, 1, scene.elastic).displacement -
                          williams_field(mode, tip, m, -1, scene.elastic).displacement;
        for (int c = 0; c < 2; ++c) held.push_back({mesh.unknown(node, 1, c), jump[c] / 2.0});
    }
    std::ranges::sort(held, {}, &coarse::PrescribedUnknown::unknown);
    scene.prescribed = held;
}

struct Errors {
    double energy, K;
};

struct Setting {
    int tip_functions, mode;
    bool along_edges;  // or through the middle of the elements
};

Errors errors(int n, const Setting& setting) {
    const int mode = setting.mode;
    const Mesh mesh = coarse::grid_mesh(equal_cells(n), equal_cells(setting.along_edges ? n + 1 : n));
    const std::vector<Vec2> crack{{0.0, 0.5}, {0.5, 0.5}};
    coarse::Scene scene = make_scene(mesh, cracked(mesh, crack, setting.tip_functions), unit);
    scene.input.cracks = {{.points = crack, .contact = {}}};
    impose(scene, mode);
    const coarse::Structure structure(scene, no_zone(scene));
    const Eigen::VectorXd u = structure.expand({}, 1.0);
    double wrong = 0.0, whole = 0.0;
    for (const ElementOperator& op : structure.operators()) {
        const Eigen::VectorXd local = gather(u, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const IntegrationPoint& point = op.points[q];
            const Mandel strain =
                strain_of(williams_field(mode, scene.enriched.tips[0], point.x, point.side, unit).gradient);
            const Mandel difference = op.strain(local, q) - strain;
            wrong += point.weight * difference.dot(unit.stiffness() * difference);
            whole += point.weight * strain.dot(unit.stiffness() * strain);
        }
    }
    const coarse::TipResult tip = coarse::fracture_parameters(structure, u, {}).front();
    return {std::sqrt(wrong / whole), std::hypot(tip.K_I - (mode == 1), tip.K_II - (mode == 2))};
}

class ExactBoundary : public ::testing::TestWithParam<Setting> {};

TEST_P(ExactBoundary, ConvergesLikeTopologicalEnrichment) {  // h^(1/2) in the energy norm, h in K
    const auto& [functions, mode, along_edges] = GetParam();
    const std::vector<int> sizes{11, 21, 41, 81};
    std::vector<Errors> found;
    for (const int n : sizes) found.push_back(errors(n, GetParam()));
    double energy_rate = 0.0, K_rate = 0.0;
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        if (k > 0) {
            const double refinement = std::log(double(sizes[k]) / sizes[k - 1]);
            energy_rate = std::log(found[k - 1].energy / found[k].energy) / refinement;
            K_rate = std::log(found[k - 1].K / found[k].K) / refinement;
        }
        std::cout << fmt::format("mode {} functions {} {} n {:2d}: energy {:.4f} rate {:.2f}, K {:.3f} % rate {:.2f}\n",
                                 mode, functions, along_edges ? "along" : "across", sizes[k], found[k].energy,
                                 energy_rate, 100.0 * found[k].K, K_rate);
    }
    EXPECT_GT(energy_rate, 0.45);
    EXPECT_GT(K_rate, 0.9);
    EXPECT_LT(found.back().K, 0.005);
}

INSTANTIATE_TEST_SUITE_P(Settings, ExactBoundary,
                         ::testing::Values(Setting{6, 1, false}, Setting{6, 2, false}, Setting{1, 1, false},
                                           Setting{1, 2, false}, Setting{6, 1, true}, Setting{6, 2, true},
                                           Setting{1, 1, true}, Setting{1, 2, true}),
                         [](const auto& setting) {
                             return fmt::format("{}functions_mode{}_{}", setting.param.tip_functions,
                                                setting.param.mode, setting.param.along_edges ? "along" : "across");
                         });

}  // namespace
}  // namespace stria::test
