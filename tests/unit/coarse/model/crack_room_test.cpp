// Cracks that a mesh, its boundary or its loads leave no room for.
#include "coarse/model/crack_room.hpp"

#include <gtest/gtest.h>

#include <string>

#include "common/crack/crack_path.hpp"
#include "tests/support/cracked_mesh.hpp"
#include "tests/support/refusal.hpp"

namespace stria::coarse {
namespace {

/// A square of 8 mm, elements of 1 mm.
const Mesh& square_of_8() {
    static const Mesh square = test::square_mesh(8, 8.0);
    return square;
}
EnrichedMesh cracked_from(const Vec2& from, const Vec2& to) { return test::cracked(square_of_8(), {from, to}, 1); }

TEST(CrackRoom, PointsLieWithinAMillionBodies) {
    CrackSection crack;
    crack.points = {{-7.9e6, 4.4}, {3.5, 4.4}};
    EXPECT_NO_THROW(require_near(square_of_8(), {crack}));
    crack.points[0].x() = -8.1e6;
    EXPECT_THROW(require_near(square_of_8(), {crack}), CaseError);
    crack.points[0] = {0.0, 8.1e6};
    EXPECT_THROW(require_near(square_of_8(), {crack}), CaseError);
}

/// What is said of a crack from the edge, 4.4 mm above the corner.
std::string complaint(double length, int refined) {
    return test::refusal_of([&] { require_room(square_of_8(), cracked_from({0.0, 4.4}, {length, 4.4}), refined); });
}

// Its tip is as near to the boundary, but that is not what helps.
TEST(CrackRoom, ACrackIsAsLongAsAnElementAtItsTip) {
    EXPECT_EQ(complaint(1.05, 1), "accepted");
    EXPECT_NE(complaint(0.95, 1).find("is 0.95 mm long in the body, less than an element at its tip, 1 mm"),
              std::string::npos);
    EXPECT_EQ(complaint(0.95, 2), "accepted");
}

TEST(CrackRoom, ATipIsAnElementAwayFromTheBoundary) {
    EXPECT_EQ(complaint(6.95, 1), "accepted");
    EXPECT_NE(complaint(7.05, 1).find("is 0.95 mm from the boundary"), std::string::npos);
    EXPECT_EQ(complaint(7.05, 2), "accepted");
}

// Of 8e-6 mm: what rounding leaves of the body's coordinates must not tell one from another.
TEST(CrackRoom, ElementsAtATipAreNotLostInTheBody) {
    const EnrichedMesh cracked = cracked_from({0.0, 4.4}, {3.5, 4.4});
    EXPECT_NO_THROW(require_room(square_of_8(), cracked, 100'000));
    EXPECT_THROW(require_room(square_of_8(), cracked, 200'000), CaseError);
}

TEST(CrackRoom, ATipIsAnElementAwayFromWhereALoadActsOrASupportHolds) {
    const EnrichedMesh cracked = cracked_from({0.0, 4.4}, {3.5, 4.4});
    const int near = nearest_node(square_of_8(), {4.0, 4.0}), beyond = nearest_node(square_of_8(), {5.0, 4.0});
    LoadsOfCase loads;
    loads.main.forces = {{beyond, {1.0, 0.0}}};
    loads.main.displacements = {{beyond, 0, 0.0}};
    loads.cases.resize(2);
    EXPECT_NO_THROW(require_room_beside_loads(square_of_8(), cracked, loads, 1));
    const auto refused = [&](const LoadsOfCase& some) {
        EXPECT_NO_THROW(require_room_beside_loads(square_of_8(), cracked, some, 2));  // 0.64 mm, and half an element
        EXPECT_THROW(require_room_beside_loads(square_of_8(), cracked, some, 1), CrackOffMesh);
    };
    LoadsOfCase pushed = loads, held = loads, later = loads;
    pushed.main.forces.push_back({near, {1.0, 0.0}});
    held.main.displacements.push_back({near, 1, 0.0});
    later.cases[1].forces.push_back({near, {1.0, 0.0}});
    for (const LoadsOfCase& some : {pushed, held, later}) refused(some);
}

TEST(CrackRoom, EachCrackHasATip) {
    EXPECT_NO_THROW(require_tips(cracked_from({0.0, 4.4}, {3.5, 4.4}), 1));
    EXPECT_THROW(require_tips(cracked_from({0.0, 4.4}, {8.0, 4.4}), 1), CaseError);
    EXPECT_THROW(require_tips(cracked_from({0.0, 4.4}, {3.5, 4.4}), 2), CaseError);
}

}  // namespace
}  // namespace stria::coarse
