// Kinked and curved edge cracks cutting through a plain mesh, against the same cracks along the edges of a finer mesh
// that is made to follow them.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <iostream>
#include <numbers>

#include "coarse/enrichment/enrichment.hpp"
#include "coarse/enrichment/tip_enrichment.hpp"
#include "coarse/model/rings.hpp"
#include "coarse/specimen/structured.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

constexpr double plate_height = 2.0, crack_level = plate_height / 2.0;

struct Bent {
    std::string name;
    std::vector<Vec2> points;  // from the left side, x ascending
};

/// Equal chords of a circle that leaves the left side at a right angle.
Bent arc(double radius, double degrees, int chords) {
    Bent bent{fmt::format("arc, {} chords", chords), {}};
    for (int k = 0; k <= chords; ++k) {
        const double angle = degrees * k / chords * std::numbers::pi / 180.0;
        bent.points.emplace_back(radius * std::sin(angle), crack_level + radius * (1.0 - std::cos(angle)));
    }
    return bent;
}

Case pulled(const Bent& crack) {
    Case input = specimen("sent", plate_height, crack.points);
    input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
    return input;
}

/// Columns of width about 1 / n that meet every bend.
std::vector<double> columns(const std::vector<Vec2>& points, int n) {
    std::vector<double> xs{0.0};
    const auto fill_to = [&](double end) {
        const double start = xs.back();
        const int cells = std::max(1, static_cast<int>(std::lround((end - start) * n)));
        for (int k = 1; k <= cells; ++k) xs.push_back(start + (end - start) * k / cells);
    };
    for (std::size_t k = 1; k < points.size(); ++k) fill_to(points[k].x());
    fill_to(1.0);
    return xs;
}

/// How far above `crack_level` the crack stands, beyond its tip its height.
double rise(const std::vector<Vec2>& points, double x) {
    for (std::size_t k = 1; k < points.size(); ++k) {
        if (x > points[k].x()) continue;
        const double share = (x - points[k - 1].x()) / (points[k].x() - points[k - 1].x());
        return points[k - 1].y() + share * (points[k].y() - points[k - 1].y()) - crack_level;
    }
    return points.back().y() - crack_level;
}

/// A row of element edges runs along the crack; the rows above and below make way, the ends stay straight.
Mesh conforming_mesh(const std::vector<Vec2>& points, int n) {
    Mesh mesh = coarse::grid_mesh(columns(points, n), equal_cells(2 * n, plate_height));
    for (Vec2& x : mesh.nodes) x.y() += rise(points, x.x()) * (1.0 - std::abs(x.y() - crack_level) / crack_level);
    return mesh;
}

coarse::TipResult along_edges(const Case& input, int n) {
    coarse::Scene scene;
    scene.input = input;
    scene.materials = Materials(input);
    scene.mesh = BodyMesh(conforming_mesh(input.cracks[0].points, n));
    scene.loads.main = coarse::resolve_boundaries(scene.mesh, input.boundaries);
    scene.free_motions = coarse::analyse_rigid_motions(scene.mesh, scene.loads.main);
    scene.enriched = coarse::enrich(scene.mesh, input.cracks, coarse::choose_enrichment(input));
    coarse::put_loads_on_unknowns(scene);
    const coarse::Structure structure(scene);
    return coarse::fracture_parameters(structure, structure.expand({}, 1.0), {}).front();
}

class BentCrack : public ::testing::TestWithParam<Bent> {};

TEST_P(BentCrack, MatchesAMeshThatFollowsItLong) {
    const Case input = pulled(GetParam());
    coarse::TipResult fine;
    for (const int n : {80, 160, 320}) {
        fine = along_edges(input, n);
        std::cout << fmt::format("{:18s} along edges, n {:3d}: K_I {:.5f}, K_II {:+.5f}, J E' / K^2 {:.5f}\n",
                                 GetParam().name, n, fine.K_I, fine.K_II,
                                 fine.J * plane_modulus / (fine.K_I * fine.K_I + fine.K_II * fine.K_II));
    }
    const double K = std::hypot(fine.K_I, fine.K_II);
    double error = 0.0;
    int last = 0;
    for (const int n : {11, 21, 41, 81}) {
        Case coarse_input = input;
        coarse_input.mesh.size = 1.0 / n;
        const ElasticSolution solution(coarse_input);
        const coarse::TipResult& tip = solution.tips.front();
        const double off_I = (tip.K_I - fine.K_I) / K, off_II = (tip.K_II - fine.K_II) / K,
                     off_J = std::sqrt(tip.J * plane_modulus) / K - 1.0, now = std::hypot(off_I, off_II);
        const double rate = last > 0 ? std::log(error / now) / std::log(double(n) / last) : 0.0;
        std::cout << fmt::format("{:18s} {:2d} across: K_I {:+.3f} %, K_II {:+.3f} %, by J {:+.3f} %, rate {:.2f}; "
                                 "largest ring {:.3f}, {:.1f} h\n",
                                 GetParam().name, n, 100.0 * off_I, 100.0 * off_II, 100.0 * off_J, rate,
                                 coarse::largest_ring(solution.scene, 0), n * coarse::largest_ring(solution.scene, 0));
        error = now;
        last = n;
        if (n < 41) continue;
        EXPECT_LT(std::abs(off_I), 0.003);
        EXPECT_LT(std::abs(off_II), 0.003);
        EXPECT_LT(std::abs(off_J), 0.003);
    }
}

const Bent kinked{"kinked", {{0.0, crack_level - 0.02}, {0.3, crack_level + 0.02}, {0.45, crack_level + 0.12}}};
const Bent zigzag{
    "zigzag", {{0.0, crack_level}, {0.15, crack_level + 0.06}, {0.3, crack_level - 0.02}, {0.45, crack_level + 0.06}}};

// The auxiliary fields of the domain integrals follow the bent faces in either mesh.
TEST(BentCracks, CutAlikeThroughElementsAndAlongEdges) {
    Case input = pulled(arc(0.6, 50.0, 10));
    const coarse::TipResult along = along_edges(input, 80);
    input.mesh.size = 1.0 / 41.0;
    const coarse::TipResult through = ElasticSolution(input).tips.front();
    const double K = std::hypot(along.K_I, along.K_II);
    std::cout << fmt::format("through elements less along edges: K_I {:+.3f} %, K_II {:+.3f} %\n",
                             100.0 * (through.K_I - along.K_I) / K, 100.0 * (through.K_II - along.K_II) / K);
    EXPECT_NEAR(through.K_I, along.K_I, 0.003 * K);
    EXPECT_NEAR(through.K_II, along.K_II, 0.003 * K);
}

// The line behind the tip leaves the crack at the bend and passes through elements that it does not cut. With the
// points across that line on the wrong branch K_II depended on how many there are: by 8e-4 of K.
TEST(BentCracks, BesideThemAuxiliaryFieldsAreThoseOfTheirSide) {
    const auto at_tip = [](int subcells) {
        Case input = specimen("plate", 20.0, {{0.0, 9.99}, {3.0, 9.99}, {3.3, 9.945}});
        input.mesh.width = 10.0;
        input.mesh.size = 0.5;
        input.cracks[0].contact = ContactSection{};
        input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
        input.load.steps = 2;
        input.load.blocks = {{.cycles = 1, .max = 50.0, .min = 0.0}};
        input.fine.radius = 2.0;
        input.fine.refine = 2;
        input.fine.subcells = subcells;
        return run_direct(input).at_maximum().tips.front();
    };
    const coarse::TipResult few = at_tip(2), many = at_tip(4);
    EXPECT_NEAR(few.K_II, many.K_II, 1e-4 * many.K_I);
}

// K of a tip a part of an element behind a bend is not resolved, as a warning says, but it is a K: on elements of a
// tenth of the body it is within 15 % of K on elements a twentieth as large. In rings that ended at the bend it was 99
// % too low or not a number.
TEST(BentCracks, HaveTheirKBehindABendThatIsNear) {
    const auto at_tip = [](const Vec2& last, double size) {
        Case input = specimen("plate", 20.0, {{0.0, 10.4}, {4.45, 10.4}, Vec2(4.45, 10.4) + last});
        input.mesh.width = 10.0;
        input.mesh.size = 1.0;
        if (size < 1.0) input.mesh.grading = {{.at = {{4.45, 10.4}}, .size = size, .outer_size = 0.3, .radius = 2.0}};
        input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
        return ElasticSolution(input).tips.front();
    };
    for (const Vec2& way : {Vec2(0.0, 1.0), Vec2(std::numbers::sqrt2 / 2.0, std::numbers::sqrt2 / 2.0)}) {
        for (const double behind : {0.1, 0.2, 0.3, 0.5}) {
            const coarse::TipResult large = at_tip(behind * way, 1.0), small = at_tip(behind * way, behind / 8.0);
            const double K = std::hypot(small.K_I, small.K_II);
            std::cout << fmt::format("{} elements behind a bend: K_I {:+.1f} %, K_II {:+.1f} % of K off\n", behind,
                                     100.0 * (large.K_I - small.K_I) / K, 100.0 * (large.K_II - small.K_II) / K);
            EXPECT_NEAR(large.K_I, small.K_I, 0.15 * K);
            EXPECT_NEAR(large.K_II, small.K_II, 0.15 * K);
        }
    }
}

// In an elastic body J is K^2 / E' (Irwin). Over a bend, or up to it, the ring of J held the corner's field: J was 0.25
// of it one element behind a bend of 90 degrees, 0.75 at 2.2 elements and 0.91 at five, where K is within 3 %.
TEST(BentCracks, HaveTheJOfTheirKOrNone) {
    int told = 0;
    for (const double degrees : {15.0, 45.0, 70.0, 90.0}) {
        for (const double behind : {0.3, 1.0, 2.2, 3.2, 4.5, 6.0, 8.0}) {
            const double angle = degrees * std::numbers::pi / 180.0, element = 0.25;
            Case input = specimen("plate", 20.0, {{0.0, 10.1}, {4.12, 10.1}, Vec2(4.12, 10.1)});
            input.cracks[0].points.back() += behind * element * Vec2(std::cos(angle), std::sin(angle));
            input.mesh.width = 10.0;
            input.mesh.size = element;
            input.boundaries = {at_end("top", End::Pulled, 1.0), at_end("bottom", End::Pulled, -1.0)};
            const coarse::TipResult tip = ElasticSolution(input).tips.front();
            const double J = tip.J * plane_modulus / (tip.K_I * tip.K_I + tip.K_II * tip.K_II);
            std::cout << fmt::format("{} degrees, {} elements behind it: J E' / K^2 {:.4f}\n", degrees, behind, J);
            EXPECT_EQ(std::isnan(J), behind < 4.0) << degrees;
            if (std::isnan(J)) continue;
            ++told;
            EXPECT_NEAR(J, 1.0, 0.02) << degrees << " degrees, " << behind;
        }
    }
    EXPECT_EQ(told, 12);
}

INSTANTIATE_TEST_SUITE_P(Shapes, BentCrack, ::testing::Values(kinked, zigzag, arc(0.6, 50.0, 5), arc(0.6, 50.0, 10)),
                         [](const auto& test) { return test_name(test.param.name); });

}  // namespace
}  // namespace stria::test
