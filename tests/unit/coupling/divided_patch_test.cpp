// The zone's patch divided among ranks: where their parts end, and what each has of it.
#include "coupling/ranks/divided_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "common/index.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {
namespace {

/// 4 x 2 elements without a crack; the left half is rank 0's and the right half rank 2's. They meet within the zone at
/// the node (2, 1) alone.
class HalvedPatch : public testing::Test {
protected:
    HalvedPatch() : patch(plate_patch(plate_mesh(4, 2, Case()))) {
        const int unknowns = patch.mesh.unknowns;
        patch.unit_load = Eigen::VectorXd::LinSpaced(unknowns, 1.0, unknowns);
        patch.case_loads = 10.0 * patch.unit_load;
        patch.displacement = Eigen::VectorXd::Constant(unknowns, -1.0);  // not the committed one
        for (int e = 0; e < 8; ++e) patch.part_of.push_back(10 * e);
        for (int e = 0; e < 8; ++e) owner[e] = e % 4 < 2 ? 0 : 2;
        divided = divide(patch, owner, committed(), {{.rank = 0, .elements = {}, .unknowns = {}, .shared = {}}});
    }
    [[nodiscard]] Eigen::VectorXd committed() const { return 0.1 * patch.unit_load; }
    [[nodiscard]] int unknown_at(const Vec2& place, int component) const {
        const auto& nodes = patch.mesh.nodes;
        const auto found = std::ranges::find(nodes, place);
        return patch.mesh.unknown(static_cast<int>(found - nodes.begin()), 0, component);
    }

    coupling::Patch patch;
    std::map<int, int> owner;
    coupling::DividedPatch divided;
};

TEST_F(HalvedPatch, HasASeamWherePartsMeetWithoutTheStructure) {
    std::vector<int> between, gamma;
    for (const int place : divided.seams.between) between.push_back(divided.seams.kept[at(place)]);
    for (const int place : divided.seams.gamma) gamma.push_back(divided.seams.kept[at(place)]);
    EXPECT_EQ(between, (std::vector{unknown_at({2.0, 1.0}, 0), unknown_at({2.0, 1.0}, 1)}));
    EXPECT_EQ(gamma, patch.boundary);
    EXPECT_TRUE(std::ranges::is_sorted(divided.seams.kept));
}

TEST_F(HalvedPatch, HasPartsThatEndAtTheSeamsThenAtGamma) {
    ASSERT_EQ(divided.parts.size(), 2U);
    EXPECT_EQ(divided.parts[0].rank, 0);
    EXPECT_EQ(divided.parts[1].rank, 2);
    EXPECT_EQ(divided.parts[1].elements, (std::vector{2, 3, 6, 7}));
    for (std::size_t p = 0; p < 2; ++p) {
        const coupling::RankPart& part = divided.parts[p];
        const std::vector<int>& boundary = divided.patches[p].boundary;
        ASSERT_EQ(boundary.size(), 2U + 14U) << "the seam's node, and seven of Gamma";
        ASSERT_EQ(part.shared.size(), boundary.size());
        for (std::size_t i = 0; i < boundary.size(); ++i)
            EXPECT_EQ(part.unknowns[at(boundary[i])], divided.seams.kept[at(part.shared[i])]);
        EXPECT_EQ(std::vector(part.shared.begin(), part.shared.begin() + 2), divided.seams.between);
        EXPECT_TRUE(std::is_sorted(part.shared.begin() + 2, part.shared.end()));
    }
}

// Those of (1, 1) and (3, 1) are inside of a part. All others are the merge's, once.
TEST_F(HalvedPatch, LeavesLoadsToPartsInsideOfThemAlone) {
    for (std::size_t p = 0; p < 2; ++p) {
        const coupling::Patch& part = divided.patches[p];
        const std::array inside{unknown_at({p == 0 ? 1.0 : 3.0, 1.0}, 0), unknown_at({p == 0 ? 1.0 : 3.0, 1.0}, 1)};
        for (int i = 0; i < part.mesh.unknowns; ++i) {
            const int whole = divided.parts[p].unknowns[at(i)];
            const double load = std::ranges::count(inside, whole) > 0 ? patch.unit_load[whole] : 0.0;
            EXPECT_EQ(part.unit_load[i], load);
            EXPECT_EQ(part.case_loads(i, 0), 10.0 * load);
        }
    }
    patch.case_loads.resize(0, 0);
    EXPECT_EQ(divide(patch, owner, committed(), {}).patches[0].case_loads.cols(), 0);
}

TEST_F(HalvedPatch, GivesPartsWhatIsCommittedThere) {
    for (std::size_t p = 0; p < 2; ++p)
        for (int i = 0; i < divided.patches[p].mesh.unknowns; ++i)
            EXPECT_EQ(divided.patches[p].displacement[i], committed()[divided.parts[p].unknowns[at(i)]]);
}

TEST_F(HalvedPatch, TellsRanksWhatIsNewToThem) {
    EXPECT_FALSE(divided.patches[0].anew);
    EXPECT_TRUE(divided.patches[1].anew) << "it had none until now";
    EXPECT_EQ(divided.patches[0].part_of, (std::vector{0, 10, 40, 50}));
    EXPECT_EQ(divided.patches[1].part_of, (std::vector{20, 30, 60, 70}));
    EXPECT_TRUE(divided.patches[0].shared);
}

}  // namespace
}  // namespace stria::test
