// Contact pressure on cracks at arbitrary positions in the mesh. A flat patch proves nothing here (docs/method.md,
// section 4): the pressure is a smooth, non-uniform, exact elastic field.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "coarse/zone/refined_scene.hpp"
#include "common/case/case_questions.hpp"
#include "common/enrichment/element_basis.hpp"
#include "common/fem/quadrature.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/integration/crack_faces.hpp"
#include "common/integration/cut_element.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/one_equilibrium.hpp"

namespace stria {
namespace {

/// With axes (x, y) along and across a crack through the middle of the field: sigma_yy = -p(x), sigma_xy = 0,
/// sigma_xx = p2 y^2, p = p0 + p1 x + p2 x^2. In equilibrium and compatible (Airy: -p0 x^2/2 - p1 x^3/6 - p2 (x^4 -
/// y^4)/12); no shear on the crack and no jump, so it is exact for frictionless contact. CutFaces that transmit a shear
/// have `shear` times another field beside it, sigma_xy = p(x), sigma_yy = -p'(x) y, sigma_xx = 0 (Airy: -p0 x y - p1
/// x^2 y/2 - p2 x^3 y/3), and what is above the crack has moved along by `slip`.
struct QuadraticPressure {
    Vec2 origin, tangent;
    double shear = 0.0, slip = 0.0;  // MPa per MPa of pressure, mm
    double p0 = 1.0, p1 = 0.5, p2 = -1.2;
    Elasticity elastic{1000.0, 0.3};

    [[nodiscard]] Vec2 normal() const { return {-tangent.y(), tangent.x()}; }
    [[nodiscard]] double pressure(const Vec2& at) const {
        const double x = (at - origin).dot(tangent);
        return p0 + p1 * x + p2 * x * x;
    }
    [[nodiscard]] Vec2 displacement(const Vec2& at) const {
        const double x = (at - origin).dot(tangent), y = (at - origin).dot(normal());
        const double nu = elastic.poisson / (1.0 - elastic.poisson);  // plane strain
        const double u = p2 * y * y * x + nu * (p0 * x + p1 * x * x / 2.0 + p2 * x * x * x / 3.0) + p1 * y * y / 2.0;
        const double v = -(p0 + p1 * x + p2 * x * x) * y - nu * p2 * y * y * y / 3.0;
        const double by_shear_u = nu * (p1 * x + p2 * x * x) * y + p2 * y * y * y / 3.0;
        const double by_shear_v =
            2.0 * (1.0 + nu) * p0 * x + (2.0 + nu) * (p1 / 2.0 + p2 * x / 3.0) * x * x - (p1 / 2.0 + p2 * x) * y * y;
        return ((u + shear * by_shear_u) * tangent + (v + shear * by_shear_v) * normal()) / elastic.plane_modulus() +
               (y >= 0.0 ? 0.5 : -0.5) * slip * tangent;
    }
    [[nodiscard]] Vec2 traction(const Vec2& at, const Vec2& outward) const {
        const double x = (at - origin).dot(tangent), y = (at - origin).dot(normal());
        const double along = tangent.dot(outward), across = normal().dot(outward), p = pressure(at);
        return (p2 * y * y * along + shear * p * across) * tangent +
               (shear * p * along - (p + shear * (p1 + 2.0 * p2 * x) * y) * across) * normal();
    }
};

struct Multipliers {
    MultiplierKind kind = MultiplierKind::Stable;
    double tolerance = 1e-10;  // of the residual
};

/// Unit square, crack from the left to the right edge: exact displacements at top and bottom, exact tractions at the
/// sides.
coarse::Scene cut_square(int elements, double left, double right, const Multipliers& multipliers, double friction,
                         QuadraticPressure& field) {
    Case input;
    input.mesh = {.specimen = "plate", .width = 1.0, .height = 1.0, .size = 1.0 / elements, .grading = {}};
    input.material.young = field.elastic.young;
    input.material.poisson = field.elastic.poisson;
    input.cracks.resize(1);
    input.cracks[0].points = {{0.0, left}, {1.0, right}};
    input.cracks[0].contact = ContactSection{.friction = friction, .multipliers = multipliers.kind};
    input.fine.enrichment = Enrichment::None;
    input.solver.tolerance = multipliers.tolerance;
    input.solver.max_iterations = 60;
    for (const char* edge : {"top", "bottom"}) {
        BoundarySection held;
        held.on = edge;
        held.displacement = {0.0, 0.0};
        input.boundaries.push_back(held);
    }
    for (const char* edge : {"left", "right"}) {
        BoundarySection pulled;
        pulled.on = edge;
        pulled.traction = Vec2(1.0, 0.0);  // marks the edge as loaded; the exact traction replaces it
        input.boundaries.push_back(pulled);
    }
    coarse::Scene scene = coarse::refined_scene(input);
    field.origin = {0.5, 0.5 * (left + right)};
    field.tangent = Vec2(1.0, right - left).normalized();

    for (coarse::PrescribedUnknown& p : scene.prescribed) {
        for (const char* edge : {"top", "bottom"}) {
            for (const BoundaryEdge& e : scene.mesh->boundary.at(edge)) {
                for (const int node : coarse::edge_nodes(scene.mesh, e)) {
                    for (int c = 0; c < 2; ++c) {
                        if (p.unknown == scene.enriched.unknown(node, 0, c))
                            p.value = field.displacement(scene.mesh->nodes[size_t(node)])[c];
                    }
                }
            }
        }
    }
    scene.unit_force.setZero();
    const std::vector<int> piece = piece_of_elements(scene.enriched);
    for (const char* name : {"left", "right"}) {
        for (const BoundaryEdge& e : scene.mesh->boundary.at(name)) {
            const coarse::EdgeGeometry edge = coarse::edge_geometry(scene.mesh, e);
            const int index = piece[size_t(e.element)];
            const CrackPiece* cut = index >= 0 ? &scene.enriched.pieces[size_t(index)] : nullptr;
            const ElementBasis basis(scene.enriched, e.element, cut != nullptr);
            std::vector<double> breaks{0.0, 1.0};
            if (cut != nullptr)
                for (const double place : {cut->entry, cut->exit})
                    if (place > e.edge && place < e.edge + 1) breaks.push_back(place - e.edge);
            std::ranges::sort(breaks);
            BasisValues values;
            for (size_t part = 0; part + 1 < breaks.size(); ++part) {
                const Vec2 middle = edge.at((breaks[part] + breaks[part + 1]) / 2.0);
                const int side = cut != nullptr
                                     ? cut_element(basis.corners(), *cut).side_of(middle + 1e-7 * edge.inward_normal())
                                     : 0;
                for (const LinePoint& g : gauss_line(4)) {
                    const double length = breaks[part + 1] - breaks[part];
                    const Vec2 x = edge.at(breaks[part] + 0.5 * (1.0 + g.xi) * length);
                    const Vec2 t = field.traction(x, -edge.inward_normal());
                    basis.evaluate(map_to_parent(basis.corners(), x), x, side, values);
                    for (int f = 0; f < basis.functions(); ++f) {
                        scene.unit_force.segment<2>(basis.unknowns()[size_t(2 * f)]) +=
                            0.5 * g.weight * length * edge.length() * values.value[f] * t;
                    }
                }
            }
        }
    }
    return scene;
}

/// Relative L2 errors over many cuts, and what else went wrong.
struct TractionErrors {
    double mean = 0.0, worst = 0.0, worst_shear = 0.0;
    int iterations = 0;
    double penetration = 0.0;  // worst, in units of h p_max / E'
    bool statuses_as_said = true;
};

/// How faces are said to slide, or not.
struct CutFaces {
    double friction = 0.0, shear = 0.0, slip = 0.0;
    [[nodiscard]] int status() const { return slip != 0.0 ? 2 : 1; }
};

/// Where a crack enters on the left and leaves on the right.
struct Ends {
    double left, right;
};

std::vector<Ends> random_cuts(int count) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> offset(0.35, 0.65), slope(-0.5, 0.5);
    std::vector<Ends> cuts;
    for (int k = 0; k < count; ++k) {
        const double middle = offset(random), rise = 0.5 * slope(random);
        cuts.push_back({middle - rise, middle + rise});
    }
    return cuts;
}

TractionErrors traction_errors(int elements, const std::vector<Ends>& cuts, const CutFaces& faces = {},
                               const Multipliers& multipliers = {}) {
    TractionErrors error;
    for (const Ends& cut : cuts) {
        QuadraticPressure field;
        field.shear = faces.shear;
        field.slip = faces.slip;
        const coarse::Scene scene = cut_square(elements, cut.left, cut.right, multipliers, faces.friction, field);
        const test::Equilibrated result = test::equilibrate(scene, 1.0);
        EXPECT_TRUE(result.newton.converged) << result.newton.failure << "\n" << result.newton.table();
        const std::vector<FaceStation> stations =
            face_stations(scene.enriched, 0, subcells_at_crack(scene.input.fine), 4);
        double wrong = 0.0, wrong_shear = 0.0, whole = 0.0, deepest = 0.0;
        for (size_t i = 0; i < stations.size(); ++i) {
            const coupling::FaceSample& face = result.zone.faces[i];
            const double exact = field.pressure(stations[i].x);
            wrong += stations[i].weight * std::pow(face.pressure - exact, 2);
            wrong_shear += stations[i].weight * std::pow(face.shear - faces.shear * exact, 2);
            whole += stations[i].weight * exact * exact;
            deepest = std::max(deepest, -face.opening);
            if (face.status != faces.status()) error.statuses_as_said = false;
        }
        const double relative = std::sqrt(wrong / whole);
        error.mean += relative / static_cast<double>(cuts.size());
        error.worst = std::max(error.worst, relative);
        if (faces.shear != 0.0)
            error.worst_shear = std::max(error.worst_shear, std::sqrt(wrong_shear / whole) / faces.shear);
        error.iterations = std::max(error.iterations, result.newton.count());
        error.penetration = std::max(error.penetration, deepest * elements * field.elastic.plane_modulus() / 1.05);
    }
    std::printf("%d x %d, %zu cuts, friction %g, slip %g: pressure error mean %.3f %%, worst %.3f %%, shear worst "
                "%.3f %%, iterations at most %d, penetration %.4f h p/E'\n",
                elements, elements, cuts.size(), faces.friction, faces.slip, 100.0 * error.mean, 100.0 * error.worst,
                100.0 * error.worst_shear, error.iterations, error.penetration);
    return error;
}

void expect_within(const TractionErrors& error, int elements, double within) {
    test::verify({.scene = "pressure over 100 random cuts, mean square, the worst",
                  .source = "exact field",
                  .quantity = "error, of the pressure",
                  .reference = 0.0,
                  .ours = error.worst,
                  .within = within,
                  .mesh = fmt::format("{0} x {0}", elements),
                  .scale = 1.0});
}

TEST(ContactPressure, QuadraticFieldOver100CutsAt21) {
    const TractionErrors error = traction_errors(21, random_cuts(100));
    EXPECT_LT(error.mean, 0.003);
    expect_within(error, 21, 0.005);
    EXPECT_LT(error.penetration, 0.01);  // half that in units that shrink by half: of second order
}

TEST(ContactPressure, QuadraticFieldOver100CutsAt41Long) {
    const TractionErrors error = traction_errors(41, random_cuts(100));
    EXPECT_LT(error.mean, 0.0015);
    expect_within(error, 41, 0.0025);
    EXPECT_LT(error.penetration, 0.005);
}

/// CutFaces that slide have the shear of their pressure; those that stick have one of their own.
constexpr CutFaces sliding{.friction = 0.3, .shear = 0.3, .slip = 5e-4}, sticking{.friction = 0.6, .shear = 0.3};

void expect_tractions(int elements, int cuts, double worst) {
    for (const CutFaces& faces : {sliding, sticking}) {
        const TractionErrors error = traction_errors(elements, random_cuts(cuts), faces);
        EXPECT_TRUE(error.statuses_as_said);
        EXPECT_LT(error.worst, worst);
        EXPECT_LT(error.worst_shear, worst);
    }
}

// So near to a mesh node at the edge that the crack enters or leaves through it: the jump there is the structure's too,
// and the first multiplier is one element away, as far as the next one from it. It goes straight on over that way.
TEST(SlidingTractions, CracksThatEnterThroughANodeAreAsGoodAsOthers) {
    const std::vector<Ends> cuts{
        {14.0005 / 41.0, 0.4405}, {14.0 / 41.0, 0.4405}, {0.4405, 14.0 / 41.0}, {0.6, 27.0 / 41.0}};
    for (const Ends& cut : cuts) EXPECT_LT(traction_errors(41, {cut}, sliding).worst, 0.001) << cut.left;
}

TEST(SlidingTractions, SmoothFieldOver30CutsAt21) { expect_tractions(21, 30, 0.005); }
TEST(SlidingTractions, SmoothFieldOver1000CutsAt41Long) { expect_tractions(41, 1000, 0.0025); }

// The paper's plain space, for comparison: worse than the stable one, and the worse the longer it is iterated.
TEST(ContactPressure, OscillatesWithOneMultiplierAtEachGaussPoint) {
    const std::vector<Ends> cuts = random_cuts(10);
    const TractionErrors stable = traction_errors(21, cuts);
    const TractionErrors loose = traction_errors(21, cuts, {}, {MultiplierKind::Gauss, 1e-4}),
                         tight = traction_errors(21, cuts, {}, {MultiplierKind::Gauss, 1e-5});
    EXPECT_GT(loose.mean, 5.0 * stable.mean);
    EXPECT_GT(tight.mean, 2.0 * loose.mean);
    EXPECT_GT(tight.worst, 0.1);
}

}  // namespace
}  // namespace stria
