// Faces that meet within an increment: what they slide until then no friction brakes.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <numbers>

#include "tests/support/specimens.hpp"
#include "tests/support/staged_loads.hpp"

namespace stria::test {
namespace {

/// A horizontal crack of half length 1 mm in the middle of an elastic plate of 40 mm. Its faces stick where they touch.
Case rough_crack() {
    constexpr double width = 40.0, size = 0.1;
    const Vec2 centre(width / 2.0, width / 2.0 + 0.3 * size), half(1.0, 0.0);
    Case input = specimen("plate", width, {centre - half, centre + half});
    input.mesh.width = width;
    input.mesh.size = 1.25 * width * size;
    input.mesh.grading = {{.at = {centre}, .size = size, .outer_size = size, .radius = 1.6, .growth = 4.0 * size}};
    input.cracks[0].contact = ContactSection{1.0};
    input.solver.tolerance = 1e-10;
    return input;
}

/// Pulled by 40 MPa at l = 1 and pressed below l = 0, where the faces meet, under a shear of 20 + 10 l + cubic l^3.
class MeetingFaces {
public:
    explicit MeetingFaces(double cubic = 0.0) : cubic_(cubic), body_(rough_crack()) {}

    [[nodiscard]] double shear(double l) const { return 20.0 + 10.0 * l + cubic_ * l * l * l; }
    Equilibrated go_to(double l) { return load(40.0 * l, shear(l)); }
    Equilibrated load(double along, double shear, const coupling::Commit& what = {}) {
        const Equilibrated now = body_.load(UniformStress{.along = along, .shear = shear}.sections(), what);
        EXPECT_TRUE(now.newton.converged) << now.newton.table();
        return now;
    }

private:
    double cubic_;
    StagedBody body_;
};

// K_II is what it was where they met, whichever part of the increment was left then.
TEST(MeetingFaces, StickWhereTheyMeet) {
    for (const auto& [before, after] : {std::pair{0.3, -0.7}, {0.05, -1.0}, {0.45, -0.1}}) {
        MeetingFaces faces;
        const double far = faces.go_to(1.0).tips[0].K_II, near = faces.go_to(before).tips[0].K_II;
        const double met = near - (far - near) * before / (1.0 - before);
        const Equilibrated pressed = faces.go_to(after);
        EXPECT_NEAR(pressed.tips[0].K_II, met, 1e-6 * std::abs(met)) << before;
        EXPECT_LT(std::abs(pressed.zone.energy.friction), 1e-9);
        EXPECT_NEAR(faces.go_to(after - 0.2).tips[0].K_II, met, 1e-6 * std::abs(met)) << before;
    }
}

// The next increment is whole again, and the faces meet where it has gone three quarters of its way.
TEST(MeetingFaces, BehindAHalvedIncrementStickWhereTheyMeet) {
    MeetingFaces faces;
    const auto go_to = [&](double l, const coupling::Commit& what = {}) {
        return faces.load(40.0 * l, faces.shear(l), what).tips[0].K_II;
    };
    go_to(1.1);
    const double far = go_to(0.7);
    go_to(0.5);
    const double near = go_to(0.3, {.next_over_this = 2.0}), met = near - (far - near) * 0.3 / 0.4;
    EXPECT_NEAR(go_to(-0.1), met, 1e-6 * std::abs(met));
}

// Where the path of open faces is no parabola the one through three states of it is off by the third order.
TEST(MeetingFaces, OnACurveTheErrorIsOfThirdOrder) {
    const auto error = [](double h) {
        MeetingFaces faces(10.0);
        faces.go_to(2.5 * h);
        const double far = faces.go_to(1.5 * h).tips[0].K_II, near = faces.go_to(0.5 * h).tips[0].K_II;
        const double per_shear = (far - near) / (faces.shear(1.5 * h) - faces.shear(0.5 * h));
        const double met = near - per_shear * (faces.shear(0.5 * h) - faces.shear(0.0));
        return faces.go_to(-0.5 * h).tips[0].K_II / met - 1.0;
    };
    const double coarse = error(0.2), fine = error(0.1);
    std::cout << fmt::format("K_II off by {:+.4f} % and, with half of the increment, {:+.4f} %\n", 100.0 * coarse,
                             100.0 * fine);
    EXPECT_NEAR(coarse, 1.875 * 0.2 * 0.2 * 0.2 * 10.0 / 20.0, 1e-5);  // the parabola's own
    EXPECT_NEAR(coarse / fine, 8.0, 0.02);
}

// The pull turns while the shear goes on at its fastest, and the faces meet in the second increment of 15 degrees
// behind. Their last chord has made its angle too steep by then: it comes to 1.7 times the shear at which they meet.
TEST(MeetingFaces, SoonBehindATurnOfTheirOpeningStickWhereTheyMeet) {
    constexpr double degree = std::numbers::pi / 180.0, meet = 25.0;
    MeetingFaces faces;
    const auto go_to = [&](double angle) {
        const double along = 400.0 * (std::cos(angle * degree) - std::cos(meet * degree));
        return faces.load(along, 20.0 * std::sin(angle * degree)).tips[0].K_II;
    };
    go_to(-15.0);
    const double without = go_to(0.0), per_shear = (go_to(15.0) - without) / (20.0 * std::sin(15.0 * degree));
    const double met = without + per_shear * 20.0 * std::sin(meet * degree);
    EXPECT_NEAR(go_to(30.0), met, 0.02 * std::abs(met));
}

// The shear stands still from where the pull begins to fall fast.
TEST(MeetingFaces, BehindACornerOfTheLoadsStickWhereTheyMeet) {
    MeetingFaces faces;
    faces.load(12.0, 0.0);
    faces.load(11.0, 10.0);
    const double met = faces.load(10.0, 20.0, {.bends = true}).tips[0].K_II;
    const Equilibrated pressed = faces.load(-60.0, 20.0);
    EXPECT_NEAR(pressed.tips[0].K_II, met, 1e-6 * std::abs(met));
    EXPECT_LT(std::abs(pressed.zone.energy.friction), 1e-9);
}

}  // namespace
}  // namespace stria::test
