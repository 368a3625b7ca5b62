// Parts of a zone speak as one.
#include "coupling/ranks/merged_reports.hpp"

#include <gtest/gtest.h>

namespace stria::coupling {
namespace {

// Contact that slides farther from the tip, in another part, does not speak for the one that sticks beside it.
TEST(MergedReports, OfAllPartsTheNearestContactTellsOfSlip) {
    PatchResponse near, far, none, whole;
    near.digest.nearest = {{{.behind = 0.5, .pressure = 20.0, .excess = -3.0, .closed = 4}}};
    far.digest.nearest = {{{.behind = 2.5, .pressure = 10.0, .excess = 1.0, .closed = 3, .sliding = 2}}};
    none.digest.nearest = {{{}}};
    for (const PatchResponse& part : {far, none, near}) add(whole, part, {});
    EXPECT_EQ(whole.digest.nearest.at(0).at(0),
              (NearestContact{.behind = 0.5, .pressure = 20.0, .excess = -3.0, .closed = 7, .sliding = 2}));
    EXPECT_FALSE(whole.digest.nearest[0][0].slides());
}

}  // namespace
}  // namespace stria::coupling
