// What integrates an element: weights, the integrals of gradients, and mean dilatation (docs/method.md, section 3).
#include "common/integration/element_operator.hpp"

#include <gtest/gtest.h>

#include <set>

#include "common/fem/shape_q4.hpp"
#include "tests/support/cracked_mesh.hpp"

namespace stria::test {
namespace {

/// Plain, cut, kinked, touching and tip elements; tips in the middle of an element, on an edge, on a node.
std::vector<EnrichedMesh> meshes(double exponent = 0.5) {
    std::vector<EnrichedMesh> result;
    const Mesh mesh = distorted(square_mesh(7), 0.01), regular = square_mesh(8);
    result.push_back(cracked(mesh, {{0.0, 0.47}, {0.643, 0.5}}, 6, exponent));
    result.push_back(cracked(mesh, {{0.071, 0.214}, {0.31, 0.33}, {0.52, 0.41}, {0.78, 0.78}}, 6, exponent));
    result.push_back(cracked(regular, {{0.0, 0.0}, {0.5625, 0.5625}}, 6, exponent));
    result.push_back(cracked(regular, {{0.0, 0.5}, {0.5625, 0.5}}, 6, exponent));
    result.push_back(cracked(regular, {{0.0, 0.5}, {0.5, 0.5}}, 6, exponent));
    result.push_back(cracked(regular, {{0.0, 0.4375}, {0.5, 0.4375}}, 6, exponent));
    return result;
}

constexpr IntegrationRule dense{.subcells = 2, .singular_gauss = 6, .tip_points = 10};

template <class Visit> void for_each_operator(const IntegrationRule& rule, Visit visit, double exponent = 0.5) {
    for (const EnrichedMesh& mesh : meshes(exponent)) {
        for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
            visit(mesh, make_operator(mesh, e, piece_in(mesh, e), rule));
        }
    }
}

double left_weight(const ElementOperator& op) {
    double sum = 0.0;
    for (const IntegrationPoint& point : op.points) sum += point.side > 0 ? point.weight : 0.0;
    return sum;
}

double left_area(const EnrichedMesh& mesh, int element) {
    const CrackPiece* piece = piece_in(mesh, element);
    return piece != nullptr ? polygon_area(cut_element(corners_of_element(mesh, element), *piece).left) : 0.0;
}

TEST(ElementOperator, WeightsAddUpToTheArea) {
    for (const int subcells : {1, 2, 3, 5}) {
        for_each_operator({.subcells = subcells}, [](const EnrichedMesh& mesh, const ElementOperator& op) {
            double sum = 0.0;
            for (const IntegrationPoint& point : op.points) {
                EXPECT_GT(point.weight, 0.0);
                sum += point.weight;
            }
            EXPECT_NEAR(sum, polygon_area(corners_of_element(mesh, op.element)), 1e-15);
            EXPECT_NEAR(op.area, sum, 1e-17);
        });
    }
}

TEST(ElementOperator, WeightsAddUpOnEachSideOfTheCrack) {
    for (const int subcells : {1, 2, 3, 5}) {
        for_each_operator({.subcells = subcells}, [](const EnrichedMesh& mesh, const ElementOperator& op) {
            EXPECT_NEAR(left_weight(op), left_area(mesh, op.element), 1e-15);
        });
    }
}

// Crossings of sub-quadrangles are rounded: wherever the crack lies, no triangle may straddle it.
TEST(ElementOperator, NoTriangleStraddlesTheCrack) {
    for (int k = 0; k < 300; ++k) {
        const Mesh square = k % 2 == 0 ? square_mesh(3) : distorted(square_mesh(3), 0.04);
        const double y = 0.5 + 0.15 * std::sin(5.0 * k), slope = 0.3 * std::cos(3.0 * k),
                     x = 0.5 + 0.14 * std::sin(11.0 * k);
        const EnrichedMesh mesh = cracked(square, {{-0.1, y - 0.1 * slope}, {x, y + slope * x}}, 1);
        for (const CrackPiece& piece : mesh.pieces) {
            if (piece.neighbour >= 0) continue;
            const ElementOperator op = make_operator(mesh, piece.element, &piece, {.subcells = 2 + k % 3});
            EXPECT_NEAR(left_weight(op), left_area(mesh, op.element), 1e-13) << k;
        }
    }
}

// Of a crack from a free edge, whose first point lies beside the edge by rounding: a triangle of 3e-16 mm2 there flowed
// alone, and made a plastic zone.
TEST(ElementOperator, HasNoPointsThatWeighNothing) {
    Mesh mesh;
    mesh.nodes = {{9.48066063525751, 8.782977994485238},
                  {10.704215835749459, 8.85642949436735},
                  {10.641371239919353, 10.0},
                  {9.423881373407449, 10.0},
                  {11.8974863161962, 8.998014949729079},
                  {11.810400309329511, 10.0}};
    mesh.elements = {{0, 1, 2, 3}, {1, 4, 5, 2}};
    const Vec2 mouth(11.154893404542053, 10.0), beyond(9.003252308498121, 8.540397110918565);
    const EnrichedMesh plate = cracked(mesh, {mouth, mouth + 0.45 * (beyond - mouth)}, 1);
    for (const CrackPiece& piece : plate.pieces)
        for (const IntegrationPoint& point : make_operator(plate, piece.element, &piece, {.subcells = 2}).points)
            EXPECT_GT(point.weight, 1e-14) << piece.element;
}

TEST(ElementOperator, PointsKnowTheirParentCoordinates) {
    for_each_operator({.subcells = 2}, [](const EnrichedMesh& mesh, const ElementOperator& op) {
        for (const IntegrationPoint& point : op.points) {
            EXPECT_LT((map_to_physical(corners_of_element(mesh, op.element), point.xi) - point.x).norm(), 1e-14);
        }
    });
}

/// Integral of phi n over a closed polygon, halving towards both ends of every part: independent of any stretching.
Gradients boundary_integral(const EnrichedMesh& mesh, const ElementBasis& basis, std::span<const Vec2> polygon,
                            int side) {
    Gradients sum = Gradients::Zero(basis.functions(), 2);
    BasisValues values;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        std::vector<Vec2> stops{polygon[k], polygon[(k + 1) % polygon.size()]};
        for (const Tip& tip : mesh.tips) {
            const double through = (tip.position - stops[0]).norm() + (tip.position - stops.back()).norm();
            if (through < (stops.back() - stops[0]).norm() + 1e-14) stops.insert(stops.begin() + 1, tip.position);
        }
        for (std::size_t part = 0; part + 1 < stops.size(); ++part) {
            const Vec2 half = (stops[part + 1] - stops[part]) / 2.0, normal(half.y(), -half.x());
            for (int level = 0; level < 50; ++level) {
                const double outer = std::pow(0.5, level), inner = level < 49 ? outer / 2.0 : 0.0;
                for (const LinePoint& gauss : gauss_line(16)) {
                    const double t = inner + 0.5 * (1.0 + gauss.xi) * (outer - inner),
                                 w = 0.5 * gauss.weight * (outer - inner);
                    for (const Vec2& x : {Vec2(stops[part] + t * half), Vec2(stops[part + 1] - t * half)}) {
                        basis.evaluate(map_to_parent(basis.corners(), x), x, side, values);
                        sum += w * values.value * normal.transpose();
                    }
                }
            }
        }
    }
    return sum;
}

TEST(ElementOperator, GradientsIntegrateToTheBoundaryIntegral) {
    for_each_operator(dense, [](const EnrichedMesh& mesh, const ElementOperator& op) {
        const CrackPiece* piece = piece_in(mesh, op.element);
        const ElementBasis basis(mesh, op.element, piece != nullptr);
        const auto corners = corners_of_element(mesh, op.element);
        Gradients exact;
        if (piece != nullptr) {
            const CutElement cut = cut_element(corners, *piece);
            exact = boundary_integral(mesh, basis, cut.left, 1) + boundary_integral(mesh, basis, cut.right, -1);
        } else {
            exact = boundary_integral(mesh, basis, corners, 0);
        }
        Gradients sum = Gradients::Zero(basis.functions(), 2);
        for (std::size_t q = 0; q < op.points.size(); ++q) sum += op.points[q].weight * op.gradients[q];
        EXPECT_LT((sum - exact).cwiseAbs().maxCoeff(), 1e-12) << "element " << op.element;
    });
}

TEST(ElementOperator, StrainMatrixIsStrain) {
    for_each_operator(dense, [](const EnrichedMesh&, const ElementOperator& op) {
        const Eigen::VectorXd u = Eigen::VectorXd::Random(static_cast<Eigen::Index>(op.unknowns.size()));
        for (std::size_t q = 0; q < op.points.size(); q += 7) {
            const Mandel strain = op.strain(u, q);
            EXPECT_LT((op.strain_matrix(q) * u - strain).norm(), 1e-13 * (1.0 + op.gradients[q].norm() * u.norm()));
        }
    });
}

TEST(ElementOperator, ForceIsTheTransposeOfStrain) {
    for_each_operator(dense, [](const EnrichedMesh&, const ElementOperator& op) {
        const Mandel stress{1.3, -0.4, 2.2, 0.9};
        for (std::size_t q = 0; q < op.points.size(); q += 7) {
            Eigen::VectorXd force = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(op.unknowns.size()));
            op.add_force(stress, q, force);
            const Eigen::VectorXd expected = op.points[q].weight * op.strain_matrix(q).transpose() * stress;
            EXPECT_LT((force - expected).norm(), 1e-14 * (1.0 + expected.norm()));
        }
    });
}

TEST(ElementOperator, StandardFunctionsReproduceLinearFields) {
    const Eigen::Matrix2d gradient{{0.3, -1.1}, {0.7, 0.2}};
    for_each_operator(dense, [&](const EnrichedMesh& mesh, const ElementOperator& op) {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(mesh.unknowns);
        for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n) {
            u.segment<2>(mesh.unknown(n, 0, 0)) = gradient * mesh.nodes[at(n)];
        }
        const Eigen::VectorXd local = gather(u, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            EXPECT_LT((op.displacement_gradient(local, q) - gradient).norm(), 1e-12);
            EXPECT_LT((op.strain(local, q) - strain_of(gradient)).norm(), 1e-12);
        }
    });
}

// A tip comes into an element beside its lower edge and moves on in it: few points lie below the crack then.
TEST(ElementOperator, PointsThatStayWhileATipMovesOnReproduceLinearFields) {
    const Mesh mesh = square_mesh(3);
    constexpr int element = 4;
    const IntegrationRule of_zone{.subcells = 2, .singular_gauss = 2, .tip_points = 4};
    const Vec2 mouth(0.0, 0.34), first(0.3352, 0.3341), second(0.53, 0.3433);
    const EnrichedMesh before = cracked(mesh, {mouth, first}), now = cracked(mesh, {mouth, first, second});
    std::vector<IntegrationPoint> points = make_operator(before, element, piece_in(before, element), of_zone).points;
    const CutElement cut = cut_element(corners_of_element(now, element), *piece_in(now, element));
    for (IntegrationPoint& point : points) point.side = cut.side_of(point.x);
    const ElementOperator op = make_operator(now, element, piece_in(now, element), of_zone, points);
    const double below = op.area - left_weight(op), area_below = op.area - polygon_area(cut.left);
    EXPECT_LT(below, 0.5 * area_below);

    const Eigen::Matrix2d gradient{{0.3, -1.1}, {0.7, 0.2}};
    Eigen::VectorXd u = Eigen::VectorXd::Zero(now.unknowns);
    for (int n = 0; n < std::ssize(now.nodes); ++n) u.segment<2>(now.unknown(n, 0, 0)) = gradient * now.nodes[at(n)];
    const Eigen::VectorXd local = gather(u, op.unknowns);
    for (std::size_t q = 0; q < op.points.size(); ++q)
        EXPECT_LT((op.displacement_gradient(local, q) - gradient).norm(), 1e-12) << q;
}

TEST(ElementOperator, DilatationIsConstantOnEachSide) {
    for_each_operator(dense, [](const EnrichedMesh& mesh, const ElementOperator& op) {
        const CrackPiece* piece = piece_in(mesh, op.element);
        const bool two_regions = piece != nullptr && piece->entry >= 0.0 && piece->exit >= 0.0;
        ASSERT_EQ(op.mean.size(), two_regions ? 2U : 1U);
        const Eigen::VectorXd u = Eigen::VectorXd::Random(static_cast<Eigen::Index>(op.unknowns.size()));
        std::vector<double> dilatation(op.mean.size(), 0.0), mean(op.mean.size(), 0.0), area(op.mean.size(), 0.0);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const auto region = at(op.points[q].region);
            EXPECT_EQ(region, two_regions && op.points[q].side < 0 ? 1U : 0U);
            dilatation[region] = trace(op.strain(u, q));
            mean[region] += op.points[q].weight * op.displacement_gradient(u, q).trace();
            area[region] += op.points[q].weight;
        }
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const auto region = at(op.points[q].region);
            const double scale = op.gradients[q].norm() * u.norm();
            EXPECT_NEAR(trace(op.strain(u, q)), dilatation[region], 1e-13 * scale);
            EXPECT_NEAR(dilatation[region], mean[region] / area[region], 1e-12 * scale);
        }
    });
}

// Fewer points serve farther from it.
TEST(ElasticRule, IntegratesTipFunctionsAtAnyDistance) {
    constexpr IntegrationRule denser{.subcells = 4, .singular_gauss = 8, .tip_points = 20};
    const MandelMatrix steel = Elasticity(200e3, 0.3, PlaneState::Strain).stiffness();
    const Mesh square = square_mesh(16), distorted_square = distorted(square, 0.01);
    const double size = diagonal(square, 0);
    for (const coarse::TipSupport support : {coarse::TipSupport::Nodal, coarse::TipSupport::Gathered}) {
        for (const Mesh& mesh : {square, distorted_square}) {
            const EnrichedMesh body =
                cracked(mesh, {{0.0, 0.47}, {0.513, 0.49}}, {.functions = 4, .support = support, .radius = 0.4});
            for (int e = 0; e < std::ssize(body.elements); ++e) {
                const CrackPiece* piece = piece_in(body, e);
                if (piece != nullptr || !ElementBasis(body, e, false).singular()) continue;
                const auto stiffness = [&](const IntegrationRule& rule) {
                    return make_operator(body, e, piece, rule).stiffness(steel);
                };
                const Eigen::MatrixXd exact = stiffness(denser);
                const double error = (stiffness(elastic_rule(body, e, false)) - exact).norm() / exact.norm();
                const double far = (body.tips[0].position - centre(corners_of_element(body, e))).norm() / size;
                EXPECT_LT(error, far > 1.0 && far < 3.0 ? 1e-7 : 1e-5) << far << " diagonals from the tip";
            }
        }
    }
}

}  // namespace
}  // namespace stria::test
