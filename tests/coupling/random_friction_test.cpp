// Random legal scenes whose faces may slide, condensed and in one matrix: the same answer, inside the cone of friction,
// and never energy from it.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

#include "app/run/monolithic/monolithic.hpp"
#include "common/error.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

/// A plate of 10 x 10 mm under a uniform state of stress that grows and reverses; the crack is inside or at an edge,
/// straight or bent. The body may flow, and then the crack may grow.
class RandomScene {
public:
    explicit RandomScene(unsigned seed) : random_(seed) {}

    [[nodiscard]] Case input() {
        const bool inside = one_in(2);
        Case input = specimen("plate", 10.0, inside ? inner_crack() : edge_crack());
        input.mesh.width = 10.0;
        input.mesh.size = 10.0 / std::uniform_int_distribution(9, 14)(random_);
        input.cracks[0].contact = ContactSection{uniform(0.05, 1.2)};
        input.boundaries = one_in(4) ? held_ends() : all_sides();
        input.load.steps = 2 * std::uniform_int_distribution(2, 5)(random_);
        const double closing = uniform(40.0, 120.0);
        input.load.blocks = {{.cycles = 2, .max = one_in(3) ? 0.0 : uniform(-0.3, 0.6) * closing, .min = -closing}};
        if (one_in(2)) let_flow(input, inside);
        input.solver.tolerance = 1e-12;
        return input;
    }

private:
    [[nodiscard]] double uniform(double from, double to) {
        return std::uniform_real_distribution<double>(from, to)(random_);
    }
    [[nodiscard]] bool one_in(int n) { return std::uniform_int_distribution(1, n)(random_) == 1; }
    [[nodiscard]] Vec2 direction(double largest_angle) {
        const double angle = uniform(-largest_angle, largest_angle);
        return {std::cos(angle), std::sin(angle)};
    }

    [[nodiscard]] std::vector<Vec2> inner_crack() {
        const Vec2 middle(uniform(4.5, 5.5), uniform(4.5, 5.5)), half = uniform(1.5, 2.5) * direction(std::numbers::pi);
        return {middle - half, middle + half};
    }
    [[nodiscard]] std::vector<Vec2> edge_crack() {
        const Vec2 mouth(0.0, uniform(4.0, 6.0)), bend = mouth + uniform(1.8, 2.5) * direction(0.6);
        if (one_in(2)) return {mouth, bend};
        return {mouth, bend, bend + uniform(1.8, 2.5) * direction(0.6)};
    }

    [[nodiscard]] std::vector<BoundarySection> all_sides() {
        const double across = uniform(-0.5, 0.8), shear = uniform(-0.8, 0.8);
        std::vector<BoundarySection> sides(4);
        const std::array<const char*, 4> names{"top", "bottom", "right", "left"};
        for (std::size_t k = 0; k < 4; ++k) {
            sides[k].on = names[k];
            const double sign = k % 2 == 0 ? 1.0 : -1.0;
            sides[k].traction = sign * (k < 2 ? Vec2(shear, 1.0) : Vec2(across, shear));
        }
        return sides;
    }
    [[nodiscard]] std::vector<BoundarySection> held_ends() {
        const double strained = 10.0 / plane_modulus, shear = uniform(-1.0, 1.0);
        BoundarySection top, bottom;
        top.on = "top", bottom.on = "bottom";
        top.displacement = {shear * strained, strained};
        bottom.displacement = {0.0, 0.0};
        return {top, bottom};
    }
    void let_flow(Case& input, bool inside) {
        input.material.yield_stress = uniform(150.0, 300.0);
        input.material.kinematic = {{.C = 4000.0, .gamma = 0.0}};
        input.fine.radius = uniform(1.0, 2.0);
        if (inside || one_in(2)) return;
        input.growth.emplace();
        input.growth->increment = uniform(0.3, 0.8);
    }

    std::mt19937 random_;
};

/// What the faces and the balance of work say wherever a run has come.
void expect_lawful(const RunHistory& run, double friction) {
    double largest_pressure = 0.0, largest_work = 0.0;
    for (const Followed& now : run.increments) {
        for (const coupling::FaceSample& face : now.zone.faces)
            largest_pressure = std::max(largest_pressure, face.pressure);
        largest_work = std::max(largest_work, now.work.by_friction);
    }
    double before = 0.0;
    for (const Followed& now : run.increments) {
        for (const coupling::FaceSample& face : now.zone.faces)
            EXPECT_LE(std::abs(face.shear), friction * std::max(0.0, face.pressure) + 1e-9 * largest_pressure);
        EXPECT_GE(now.work.by_friction, before - 1e-12 * largest_work);
        before = now.work.by_friction;
    }
}

/// The largest of a value over a run: the scale of its errors.
template <class Value> double largest(const RunHistory& run, const Value& value) {
    double size = 0.0;
    for (const Followed& now : run.increments) size = std::max(size, std::abs(value(now)));
    return size;
}

/// J of the load on a crack that would bear all of it: the scale of a closed crack's, which drives nothing. So it is of
/// K, which is rounding where all of a crack sticks.
double J_of_load(const Case& input) {
    double length = 0.0;
    const std::vector<Vec2>& points = input.cracks[0].points;
    for (std::size_t k = 1; k < points.size(); ++k) length += (points[k] - points[k - 1]).norm();
    return std::pow(input.load.blocks[0].min, 2) * length / plane_modulus;
}

void expect_same(const Case& input, const RunHistory& condensed, const RunHistory& whole) {
    ASSERT_EQ(whole.increments.size(), condensed.increments.size());
    constexpr double tolerance = 1e-8;
    const auto compare = [&](const char* name, double scale, const auto& value) {
        for (std::size_t k = 0; k < whole.increments.size(); ++k)
            EXPECT_NEAR(value(condensed.increments[k]), value(whole.increments[k]), tolerance * scale)
                << name << " of increment " << k + 1;
    };
    const auto K = [](const Followed& now) { return std::hypot(now.tips[0].K_I, now.tips[0].K_II); };
    const double largest_K = std::max(largest(condensed, K), std::sqrt(J_of_load(input) * plane_modulus));
    compare("K_I", largest_K, [](const Followed& now) { return now.tips[0].K_I; });
    compare("K_II", largest_K, [](const Followed& now) { return now.tips[0].K_II; });
    // Told by both or by neither.
    const auto J = [](const Followed& now) { return std::isnan(now.tips[0].J) ? 0.0 : now.tips[0].J; };
    compare("J", std::max(largest(condensed, J), J_of_load(input)), J);
    const auto external = [](const Followed& now) { return now.work.external; };
    compare("dissipation", largest(condensed, external), [](const Followed& now) { return now.work.dissipated; });
    compare("friction", largest(condensed, external), [](const Followed& now) { return now.work.by_friction; });
    const double displacement =
        largest(condensed, [](const Followed& now) { return now.displacement.lpNorm<Eigen::Infinity>(); });
    for (std::size_t k = 0; k < whole.increments.size(); ++k) {
        const Followed &a = condensed.increments[k], &b = whole.increments[k];
        EXPECT_LT((a.displacement - b.displacement).lpNorm<Eigen::Infinity>(), tolerance * displacement);
        ASSERT_EQ(a.zone.faces.size(), b.zone.faces.size());
        double pressure = 1.0;
        for (const coupling::FaceSample& face : a.zone.faces) pressure = std::max(pressure, face.pressure);
        for (std::size_t i = 0; i < a.zone.faces.size(); ++i) {
            EXPECT_NEAR(a.zone.faces[i].pressure, b.zone.faces[i].pressure, tolerance * pressure);
            EXPECT_NEAR(a.zone.faces[i].shear, b.zone.faces[i].shear, tolerance * pressure);
        }
    }
}

bool is_legal(const Case& input) {
    try {
        (void)coarse::refined_scene(input);
        return true;
    } catch (const CaseError&) {
        return false;  // a short crack between large elements
    }
}

void try_scenes(unsigned first, unsigned count) {
    int slid = 0, stuck = 0, cuts = 0;
    for (unsigned seed = first, legal = 0; legal < count; ++seed) {
        SCOPED_TRACE(seed);
        const Case input = RandomScene(seed).input();
        if (!is_legal(input)) continue;
        ++legal;
        const RunHistory condensed = run_direct(input);
        MonolithicFactory factory(input);
        expect_lawful(condensed, input.cracks[0].contact->friction);
        expect_same(input, condensed, run_analysis(input, factory));
        cuts += condensed.cuts;
        int statuses[3] = {0, 0, 0};
        for (const Followed& now : condensed.increments)
            for (const coupling::FaceSample& face : now.zone.faces) ++statuses[face.status];
        slid += statuses[2] > 0 ? 1 : 0;
        stuck += statuses[1] > 0 ? 1 : 0;
    }
    std::cout << fmt::format("{} scenes: {} slid, {} stuck, {} increments halved\n", count, slid, stuck, cuts);
    EXPECT_GT(slid, static_cast<int>(count / 2));
    EXPECT_GT(stuck, static_cast<int>(count / 2));
}

TEST(RandomFriction, ScenesAreLawfulAndOneMatrixAgrees) { try_scenes(1, 10); }
TEST(RandomFriction, ScenesAreLawfulAndOneMatrixAgreesLong) { try_scenes(1000, 200); }

}  // namespace
}  // namespace stria::test
