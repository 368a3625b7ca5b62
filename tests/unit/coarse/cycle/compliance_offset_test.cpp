#include "coarse/cycle/compliance_offset.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace stria::coarse {
namespace {

/// Of a load made of forces: its factor is one.
MouthPath path_of(const std::vector<double>& load, const std::vector<double>& opening) { return {load, load, opening}; }

std::optional<double> opened(const std::vector<double>& down, const std::vector<double>& v_down,
                             const std::vector<double>& up, const std::vector<double>& v_up) {
    return compliance_offset_opening(path_of(down, v_down), path_of(up, v_up));
}

// Compliance 1 above the load 40, .8 below: two straight lines that meet there.
TEST(ComplianceOffset, FindsWhereTheCrackIsOpen) {
    std::vector<double> down, up, v_down, v_up;
    const auto opening = [](double load) { return load > 40.0 ? load : 40.0 - 0.8 * (40.0 - load); };
    for (int k = 0; k <= 50; ++k) {
        up.push_back(2.0 * k);
        down.push_back(100.0 - 2.0 * k);
        v_up.push_back(opening(up.back()));
        v_down.push_back(opening(down.back()));
    }
    EXPECT_NEAR(*opened(down, v_down, up, v_up), 40.0, 2.0);
    for (std::size_t k = 0; k < up.size(); ++k) {
        v_up[k] = up[k];
        v_down[k] = down[k];
    }
    EXPECT_EQ(opened(down, v_down, up, v_up), 0.0) << "never closed: the minimum";
    std::vector<double> stiff = v_up;
    for (double& v : stiff) v *= 0.9;
    EXPECT_TRUE(std::isnan(*opened(down, v_down, up, stiff))) << "never open";
    std::ranges::fill(v_up, 0.0);
    std::ranges::fill(v_down, 0.0);
    EXPECT_TRUE(std::isnan(*opened(down, v_down, up, v_up))) << "closed";
    for (std::size_t k = 0; k < up.size(); ++k) {  // rounding of closed faces tells no compliance
        v_up[k] = 1e-16 * up[k] * up[k];
        v_down[k] = 1e-16 * down[k];
    }
    EXPECT_TRUE(std::isnan(*opened(down, v_down, up, v_up)));
    std::ranges::fill(v_up, NAN);
    std::ranges::fill(v_down, NAN);
    EXPECT_FALSE(opened(down, v_down, up, v_up)) << "no mouth";
}

// Half open on the way down already below 75: what is above that is the open crack, and 2 % less of it is closed.
TEST(ComplianceOffset, IsTwoPercentOfTheUpperQuarterOfTheWayDown) {
    const auto opened_by = [](double compliance_below) {
        std::vector<double> down, up, v_down, v_up;
        for (int k = 0; k <= 50; ++k) {
            up.push_back(2.0 * k);
            down.push_back(100.0 - 2.0 * k);
            v_up.push_back(up.back() > 40.0 ? up.back() : 40.0 - compliance_below * (40.0 - up.back()));
            v_down.push_back(down.back() > 75.0 ? down.back() : 75.0 - 0.7 * (75.0 - down.back()));
        }
        return *opened(down, v_down, up, v_up);
    };
    EXPECT_NEAR(opened_by(0.9), 40.0, 2.0);
    EXPECT_NEAR(opened_by(0.97), 40.0, 2.0);
    EXPECT_EQ(opened_by(0.985), 0.0) << "open all the way";
}

// What the secant of a long increment tells depends on where it ends.
TEST(ComplianceOffset, IsNotReadFromLongIncrements) {
    const auto opening = [](double load) { return load > 40.0 ? load : 40.0 - 0.8 * (40.0 - load); };
    const auto with_increments_of = [&](double length) {
        std::vector<double> down, up, v_down, v_up;
        for (double load = 0.0; load < 100.5; load += length) {
            up.push_back(load);
            down.push_back(100.0 - load);
            v_up.push_back(opening(up.back()));
            v_down.push_back(opening(down.back()));
        }
        return opened(down, v_down, up, v_up);
    };
    EXPECT_NEAR(*with_increments_of(10.0), 40.0, 10.0);
    EXPECT_FALSE(with_increments_of(12.5));
}

// Under a K that is controlled the load rises again to another one than it has fallen from. Ten equal increments of a
// way that was longer by a hair than the one down told nothing.
TEST(ComplianceOffset, IsReadFromTenthsOfTheWayUp) {
    const auto opening = [](double load) { return load > 40.0 ? load : 40.0 - 0.8 * (40.0 - load); };
    const auto up_to = [&](double maximum, int increments) {
        std::vector<double> down, up, v_down, v_up;
        for (int k = 0; k <= 10; ++k) down.push_back(100.0 - 10.0 * k);
        for (int k = 0; k <= increments; ++k) up.push_back(maximum * k / increments);
        for (const double load : down) v_down.push_back(opening(load));
        for (const double load : up) v_up.push_back(opening(load));
        return opened(down, v_down, up, v_up);
    };
    for (const double maximum : {100.01, 120.0}) EXPECT_NEAR(up_to(maximum, 10).value_or(NAN), 40.0, 12.0) << maximum;
    EXPECT_FALSE(up_to(90.0, 9)) << "they are longer than tenths of that way";
}

// Where boundaries are moved the load factor is how far. The crack closes below 40 and the body is stiffer then: over
// the displacement its mouth goes on as before, over the force it does not.
TEST(ComplianceOffset, IsOverTheForceAndToldByTheLoadFactor) {
    MouthPath down, up;
    for (int k = 0; k <= 50; ++k)
        for (const auto& [path, moved] : {std::pair{&up, 2.0 * k}, {&down, 100.0 - 2.0 * k}})
            path->add(moved, 3.0 * (moved > 40.0 ? moved : 40.0 - 1.2 * (40.0 - moved)), moved);
    EXPECT_NEAR(*compliance_offset_opening(down, up), 40.0, 2.0);
    up.force[45] = up.force[46] + 1.0;
    EXPECT_FALSE(compliance_offset_opening(down, up)) << "past a limit load";
}

}  // namespace
}  // namespace stria::coarse
