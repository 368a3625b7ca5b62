// Slip on the way between two states in which nothing slides.
#include "coarse/cycle/hidden_slip.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace stria::coarse {
namespace {

constexpr double precision = 0.1;

ClosureStation at_target(double target, const coupling::NearestContact& nearest) {
    return {.target = target, .load_factor = target, .signal = {-1.0}, .nearest = {nearest}};
}

ClosureStation closed(double target, double excess, double pressure = 10.0, double behind = 0.2) {
    return at_target(target, {.behind = behind, .pressure = pressure, .excess = excess, .closed = 3});
}

ClosureStation others_changed(ClosureStation station) {
    station.nearest[0].closed -= 1;
    return station;
}

bool finds(const std::optional<Crossing>& found, bool known) { return found && found->known == known; }

TEST(HiddenSlip, NothingHidesWhereNothingChanges) {
    EXPECT_EQ(hidden_slip({closed(0.0, -5.0), closed(10.0, -0.1)}, 0, 0, precision), std::nullopt);
    const auto open = at_target(0.0, {});
    EXPECT_FALSE(may_hide_slip(open.nearest[0], open.nearest[0]));
    const coupling::NearestContact smooth{.behind = 0.2, .pressure = 10.0, .closed = 1};
    EXPECT_FALSE(may_hide_slip(smooth, {})) << "without friction";
}

TEST(HiddenSlip, LooksBetweenAContactAndTheOneBehindIt) {
    const std::vector<ClosureStation> parts{closed(0.0, -5.0), closed(10.0, -5.0, 10.0, 0.5)};
    EXPECT_TRUE(finds(hidden_slip(parts, 0, 0, precision), false));
    EXPECT_TRUE(finds(hidden_slip({parts[1], parts[0]}, 0, 0, precision), false));
    EXPECT_TRUE(finds(hidden_slip({parts[0], at_target(10.0, {})}, 0, 0, precision), false));
}

// Closer than the precision what it did before it parted tells, or what it does after it has been made.
TEST(HiddenSlip, ShearThatIsLeftWithoutPressureHasSlid) {
    const auto behind = at_target(10.05, {.behind = 0.5, .pressure = 9.0, .excess = -2.0, .closed = 2});
    const auto sheared = [](double target) {  // parts at 10.03; its shear is 0.02 there
        const double pressure = 10.03 - target;
        return closed(target, 0.02 + 0.1 * pressure - 0.5 * pressure, pressure);
    };
    EXPECT_TRUE(finds(hidden_slip({sheared(9.5), sheared(9.96), behind}, 1, 0, precision), true));
    const auto elastic = [](double target) {  // a shear in proportion to the pressure
        const double pressure = 10.03 - target;
        return closed(target, 0.1 * pressure - 0.5 * pressure, pressure);
    };
    EXPECT_EQ(hidden_slip({elastic(9.5), elastic(9.96), behind}, 1, 0, precision), std::nullopt);
    const auto back = [](ClosureStation station) {
        station.target *= -1.0;
        return station;
    };
    EXPECT_TRUE(finds(hidden_slip({back(behind), back(sheared(9.96)), back(sheared(9.5))}, 0, 0, precision), true));
    EXPECT_EQ(hidden_slip({back(behind), back(elastic(9.96)), back(elastic(9.5))}, 0, 0, precision), std::nullopt);
}

TEST(HiddenSlip, OneStationDoesNotTellHowAContactParts) {
    EXPECT_TRUE(finds(hidden_slip({closed(0.0, -5.0), at_target(0.05, {})}, 0, 0, precision), false));
    EXPECT_EQ(hidden_slip({closed(0.0, -5.0), at_target(0.01, {})}, 0, 0, precision), std::nullopt);
}

// Others part meanwhile, so its way has a bend. A third state tells how far that may lead.
TEST(HiddenSlip, OfOneContactABendHidesIt) {
    const ClosureStation begins = closed(0.0, -5.0), ends = others_changed(closed(10.0, -4.0));
    EXPECT_TRUE(finds(hidden_slip({begins, ends}, 0, 0, precision), false));
    for (const double middle : {-4.5, -4.8, -3.0}) {
        const std::vector<ClosureStation> way{begins, closed(5.0, middle), ends};
        EXPECT_EQ(hidden_slip(way, 0, 0, precision), std::nullopt) << middle;
        EXPECT_EQ(hidden_slip(way, 1, 0, precision), std::nullopt) << middle;
    }
    const std::vector<ClosureStation> near{begins, closed(5.0, -1.0), ends};  // leads from -5 to 3, and from -4 to 2
    EXPECT_EQ(hidden_slip(near, 0, 0, precision), std::nullopt) << "nothing has changed";
    EXPECT_TRUE(finds(hidden_slip(near, 1, 0, precision), false));
}

}  // namespace
}  // namespace stria::coarse
