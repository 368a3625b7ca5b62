// Tractions on crack faces: between the stations that told them, and as a load of a body.
#include "coarse/fracture/face_tractions.hpp"

#include <gtest/gtest.h>

namespace stria::coarse {
namespace {

TEST(FaceTractions, AreStraightBetweenStationsInWhateverOrder) {
    const FaceTractions tractions = tractions_of({{.crack = 1, .s = 2.0, .pressure = 30.0, .shear = -3.0},
                                                  {.crack = 0, .s = 0.5, .pressure = 7.0},
                                                  {.crack = 1, .s = 1.0, .pressure = 10.0, .in_wake = true}});
    EXPECT_EQ(tractions.at(1, 1.25).pressure, 15.0);
    EXPECT_EQ(tractions.at(1, 1.25).shear, -0.75);
    EXPECT_EQ(tractions.at(1, 1.0).pressure, 10.0);
    EXPECT_EQ(tractions.at(1, 0.2).pressure, 10.0);
    EXPECT_EQ(tractions.at(1, 5.0).shear, -3.0);
    EXPECT_EQ(tractions.at(0, 5.0).pressure, 7.0) << "of one station";
    EXPECT_EQ(tractions.at(2, 1.0).pressure, 0.0) << "of none";
    EXPECT_EQ(tractions.in_wake, (std::vector<std::int8_t>{0, 1, 0}));
}

}  // namespace
}  // namespace stria::coarse
