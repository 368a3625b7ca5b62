// Bent cracks whose faces touch, cut through plain meshes, against a conforming mesh with pairs of nodes that shares
// nothing with the program (tests/support/conforming/).
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <numbers>
#include <numeric>

#include "coarse/zone/refined_scene.hpp"
#include "common/case/case_questions.hpp"
#include "common/integration/crack_faces.hpp"
#include "fine/contact/face_operators.hpp"
#include "tests/support/comparison.hpp"
#include "tests/support/conforming/pressed_plate.hpp"
#include "tests/support/one_equilibrium.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

constexpr double plate_side = 40.0, ring = 2.0;  // mm

struct BentShape {
    std::string name;
    std::vector<Vec2> crack;
    double bending;  // MPa/mm, in the last load

    [[nodiscard]] conforming::Plate plate() const { return {plate_side, plate_side, {crack}, young, poisson}; }
};

BentShape branch_at(double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Vec2 bend(10.0, 20.0), tip = bend + 4.0 * Vec2(std::cos(angle), std::sin(angle));
    return {fmt::format("branch at {} degrees", degrees), {{0.0, 20.0}, bend, tip}, 8.0};
}

const BentShape z_shaped{"Z", {{13.0, 18.0}, {18.0, 18.0}, {22.0, 22.0}, {27.0, 22.0}}, -8.0};

struct Loading {
    std::string name;
    double sigma_x, sigma_y;  // MPa
    bool bends = false;

    [[nodiscard]] conforming::Load on(const BentShape& shape) const {
        return {Vec2(sigma_x, sigma_y).asDiagonal(), bends ? shape.bending : 0.0};
    }
};

const std::array loadings{Loading{"all opens", 0.0, 100.0}, Loading{"the slanted part closes", -300.0, 20.0},
                          Loading{"the level part closes", 300.0, -100.0},
                          Loading{"compression and bending", 0.0, -50.0, true}};

/// Elements of the size h about the crack, cut by it anywhere.
Case plate_with(const BentShape& shape, const conforming::Load& load, double h) {
    Case input = specimen("plate", plate_side, shape.crack);
    input.mesh.width = plate_side;
    input.mesh.size = 4.0 * h;
    const Vec2 &first = shape.crack.front(), &last = shape.crack.back();
    const double rise = last.y() - first.y(), middle = first.y() + rise / 2.0;
    input.mesh.grading = {{.at = {{first.x(), middle}, {last.x(), middle}},
                           .size = h,
                           .outer_size = h,
                           .radius = 2.0 + rise / 2.0,
                           .growth = 0.25}};
    input.cracks[0].contact = ContactSection{};
    for (const auto& [on, outward] : {std::pair("top", Vec2(0.0, 1.0)), std::pair("bottom", Vec2(0.0, -1.0)),
                                      std::pair("left", Vec2(-1.0, 0.0)), std::pair("right", Vec2(1.0, 0.0))}) {
        BoundarySection edge;
        edge.on = on;
        edge.traction = load.stress * outward;
        edge.traction_gradient(1, 0) = load.bending * outward.y();
        edge.origin = Vec2(plate_side / 2.0, 0.0);
        input.boundaries.push_back(edge);
    }
    return input;
}

struct Part {
    double force = 0.0;    // N/mm
    double touches = 0.0;  // mm
};

struct Compared {
    std::vector<Part> parts;
    std::vector<coarse::TipResult> tips;
    double jump_error = 0.0;  // mean square along the crack, of the jump
};

/// What the multipliers of each segment push with: the drawn pressure, straight between their nodes, is not what acts
/// where it is singular, at a bend.
void add_forces(const coarse::Scene& scene, const std::vector<coupling::FaceSample>& faces,
                const conforming::Polyline& crack, std::vector<Part>& parts) {
    const fine::FaceOperators operators(scene.enriched, {}, scene.input.cracks, subcells_at_crack(scene.input.fine),
                                        {});
    for (int k = 0; k < operators.multipliers(); ++k) {
        const auto& [number, s, x] = operators.keys()[at(k)];
        const auto after = std::clamp(std::ranges::lower_bound(faces, s, {}, &coupling::FaceSample::s),
                                      faces.begin() + 1, faces.end() - 1);
        const auto before = after - 1;
        const double t = (s - before->s) / (after->s - before->s);
        parts[crack.segment_at(x.x())].force +=
            operators.weight(k) * ((1.0 - t) * before->pressure + t * after->pressure);
    }
}

Compared compare(const BentShape& shape, const conforming::Load& load, const conforming::Equilibrium& exact, double h) {
    const coarse::Scene scene = coarse::refined_scene(plate_with(shape, load, h));
    const Equilibrated result = equilibrate(scene, 1.0);
    EXPECT_TRUE(result.newton.converged) << result.newton.failure;
    const conforming::Polyline crack{shape.crack};
    Compared found{std::vector<Part>(crack.segments()), result.tips, 0.0};
    add_forces(scene, result.zone.faces, crack, found.parts);
    const std::vector<FaceStation> stations = face_stations(scene.enriched, 0, subcells_at_crack(scene.input.fine), 4);
    double wrong = 0.0, whole = 0.0;
    for (std::size_t k = 0; k < stations.size(); ++k) {
        const FaceStation& station = stations[k];
        const coupling::FaceSample& face = result.zone.faces[k];
        if (face.status != 0) found.parts[crack.segment_at(station.x.x())].touches += station.weight;
        const Vec2 jump = exact.jump(station.s);
        wrong += station.weight * (face.opening * station.normal + face.slip * station.tangent - jump).squaredNorm();
        whole += station.weight * jump.squaredNorm();
    }
    found.jump_error = std::sqrt(wrong / whole);
    return found;
}

std::vector<conforming::TipValues> tips_of(const BentShape& shape, const conforming::Equilibrium& exact) {
    if (conforming::Polyline{shape.crack}.at_edge()) return {exact.tip(true, ring)};
    return {exact.tip(false, ring), exact.tip(true, ring)};
}

/// The largest distance of two tips, as a share of K. That of K_I is taken apart where the tip is closed.
struct TipErrors {
    double K_I = 0.0, K_I_closed = 0.0, K_II = 0.0, by_J = 0.0;
};

TipErrors errors_of(const std::vector<coarse::TipResult>& ours, const std::vector<conforming::TipValues>& exact) {
    TipErrors worst;
    for (std::size_t t = 0; t < exact.size(); ++t) {
        const double K = std::sqrt(exact[t].J * plane_modulus);
        double& worst_K_I = std::abs(exact[t].K_I) < 0.01 * K ? worst.K_I_closed : worst.K_I;
        worst_K_I = std::max(worst_K_I, std::abs(ours[t].K_I - exact[t].K_I) / K);
        worst.K_II = std::max(worst.K_II, std::abs(ours[t].K_II - exact[t].K_II) / K);
        worst.by_J = std::max(worst.by_J, std::abs(std::sqrt(ours[t].J * plane_modulus) / K - 1.0));
    }
    return worst;
}

void print(const BentShape& shape, const Loading& loading, double h, const Compared& ours, const TipErrors& errors) {
    std::cout << fmt::format("{}, {}, h {:.3f}:", shape.name, loading.name, h);
    for (const Part& part : ours.parts)
        std::cout << fmt::format(" {:.2f} N/mm on {:.3f} mm;", part.force, part.touches);
    std::cout << fmt::format(" K_I {:.2f}, closed {:.2f}, K_II {:.2f}, by J {:.2f} %, jump {:.2f} %\n",
                             100.0 * errors.K_I, 100.0 * errors.K_I_closed, 100.0 * errors.K_II, 100.0 * errors.by_J,
                             100.0 * ours.jump_error);
}

struct Limits {
    double K_I, K_II, by_J, force, jump;
};

/// Forces are shares of the largest. An edge of contact lies within a multiplier, and a part may have two.
void expect_within(const Limits& limits, const Compared& ours, const TipErrors& errors,
                   const conforming::Equilibrium& exact, double h) {
    constexpr double of_closed_tips = 0.03;  // docs/method.md, section 2: it does not fall with the mesh
    double largest = 0.0;
    for (std::size_t k = 0; k < ours.parts.size(); ++k) largest = std::max(largest, exact.force(k));
    for (std::size_t k = 0; k < ours.parts.size(); ++k) {
        EXPECT_LE(std::abs(ours.parts[k].force - exact.force(k)), limits.force * largest);
        EXPECT_LE(std::abs(ours.parts[k].touches - exact.contact_length(k)), 2.0 * (2.0 * h));
    }
    EXPECT_LT(errors.K_I, limits.K_I);
    EXPECT_LT(errors.K_I_closed, of_closed_tips);
    EXPECT_LT(errors.K_II, limits.K_II);
    EXPECT_LT(errors.by_J, limits.by_J);
    EXPECT_LT(ours.jump_error, limits.jump);
}

constexpr conforming::Sizes coarse_sizes{1e-3, 0.7, 3.0}, fine_sizes{1e-3, 0.35, 1.5};

// One element of 0.5 mm is an eighth of the branch.
TEST(BentContacts, OfABranchThatOpensOrClosesIsThatOfAConformingMesh) {
    const BentShape shape = branch_at(45.0);
    const conforming::PressedPlate reference(shape.plate(), coarse_sizes);
    for (const Loading& loading : loadings) {
        SCOPED_TRACE(loading.name);
        const conforming::Equilibrium exact = reference.under(loading.on(shape));
        const double h = 0.485;
        const Compared ours = compare(shape, loading.on(shape), exact, h);
        const TipErrors errors = errors_of(ours.tips, tips_of(shape, exact));
        print(shape, loading, h, ours, errors);
        expect_within({.K_I = 0.01, .K_II = 0.005, .by_J = 0.02, .force = 0.01, .jump = 0.06}, ours, errors, exact, h);
    }
}

/// How far the reference moves with its own mesh: that is no less than its error.
void expect_settled(const BentShape& shape, const conforming::Equilibrium& before,
                    const conforming::Equilibrium& exact) {
    const auto tips = tips_of(shape, exact), tips_before = tips_of(shape, before);
    double largest = 0.0;
    for (std::size_t t = 0; t < tips.size(); ++t) EXPECT_NEAR(std::sqrt(tips_before[t].J / tips[t].J), 1.0, 0.003);
    for (std::size_t k = 0; k + 1 < shape.crack.size(); ++k) largest = std::max(largest, exact.force(k));
    for (std::size_t k = 0; k + 1 < shape.crack.size(); ++k) {
        EXPECT_LE(std::abs(before.force(k) - exact.force(k)), 0.004 * largest);
        std::cout << fmt::format("reference: {:.2f}, before {:.2f} N/mm on {:.3f} mm; ", exact.force(k),
                                 before.force(k), exact.contact_length(k));
    }
    for (std::size_t t = 0; t < tips.size(); ++t)
        std::cout << fmt::format("K_I {:.2f}, K_II {:.2f}, J {:.6f}, before {:.6f}; ", tips[t].K_I, tips[t].K_II,
                                 tips[t].J, tips_before[t].J);
    std::cout << '\n';
}

void add_rows(const BentShape& shape, const Loading& loading, const Compared& ours,
              const conforming::Equilibrium& exact, const Limits& limits) {
    const auto tips = tips_of(shape, exact);
    const double K = std::sqrt(tips.back().J * plane_modulus);
    Comparison common{.scene = fmt::format("bent crack, {}, {}", shape.name, loading.name),
                      .source = "conforming mesh with pairs of nodes (5.8)",
                      .mesh = "h 0.12 mm"};
    const auto row = [&](const std::string& quantity, double reference, double value, double within, double scale) {
        common.within = within;
        common.scale = scale;
        rows_of(common)(quantity, reference, value);
    };
    row("K by J, MPa sqrt(mm)", K, std::sqrt(ours.tips.back().J * plane_modulus), limits.by_J, K);
    row("K_II, MPa sqrt(mm)", tips.back().K_II, ours.tips.back().K_II, limits.K_II, K);
    std::size_t most = 0;
    for (std::size_t k = 0; k < ours.parts.size(); ++k)
        if (exact.force(k) > exact.force(most)) most = k;
    const double force = exact.force(most);
    if (force > 0.0) row("force of the faces, N/mm", force, ours.parts[most].force, limits.force, force);
}

class BentContact : public ::testing::TestWithParam<BentShape> {};

// The jump is of first order, for the stress is singular at the bends, and J is of first order or better.
TEST_P(BentContact, ConvergesToThatOfAConformingMeshLong) {
    const BentShape& shape = GetParam();
    const conforming::PressedPlate before(shape.plate(), coarse_sizes), reference(shape.plate(), fine_sizes);
    for (const Loading& loading : loadings) {
        SCOPED_TRACE(loading.name);
        const conforming::Equilibrium exact = reference.under(loading.on(shape));
        expect_settled(shape, before.under(loading.on(shape)), exact);
        const Limits limits{.K_I = 0.01, .K_II = 0.005, .by_J = 0.01, .force = 0.025, .jump = 0.015};
        std::vector<double> jumps;
        for (const double h : {0.97, 0.485, 0.2425, 0.12125}) {
            const Compared ours = compare(shape, loading.on(shape), exact, h);
            const TipErrors errors = errors_of(ours.tips, tips_of(shape, exact));
            print(shape, loading, h, ours, errors);
            jumps.push_back(ours.jump_error);
            if (jumps.size() < 4) continue;
            expect_within(limits, ours, errors, exact, h);
            add_rows(shape, loading, ours, exact, limits);
        }
        EXPECT_LT(jumps.back(), jumps.front() / 6.0);  // an eighth, but for where the mesh is cut
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, BentContact, ::testing::Values(branch_at(30.0), branch_at(45.0), z_shaped),
                         [](const auto& test) { return test_name(test.param.name); });

}  // namespace
}  // namespace stria::test
