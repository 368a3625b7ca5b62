// What is looked up on a mesh is what a look at each element finds.
#include "common/fem/body_mesh.hpp"

#include <gtest/gtest.h>

#include <set>
#include <type_traits>

#include "common/fem/centre.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria::test {
namespace {

// A Mesh that became one in passing was looked up anew in every growth step.
static_assert(!std::is_convertible_v<Mesh, BodyMesh> && std::is_convertible_v<BodyMesh, const Mesh&>);

TEST(BodyMesh, KnowsTheElementsAboutNodes) {
    const BodyMesh mesh(refined_square(6, {0.4, 0.6}, 2, 0.2, 0.0));
    for (int node = 0; node < std::ssize(mesh->nodes); ++node) {
        std::set<int> expected;
        for (int e = 0; e < std::ssize(mesh->elements); ++e)
            if (std::ranges::find(mesh->elements[at(e)], node) != mesh->elements[at(e)].end()) expected.insert(e);
        for (const HangingNode& hanging : mesh->hanging)
            if (hanging.node == node) expected.insert(hanging.larger);
        const std::vector nodes{node, node};
        EXPECT_EQ(mesh.elements_about(nodes), std::vector<int>(expected.begin(), expected.end())) << node;
    }
}

TEST(BodyMesh, MissesNoElementNearABox) {
    for (const bool slanted : {false, true}) {
        Mesh square = refined_square(6, {0.4, 0.6}, 3, 0.2, 0.0);
        if (slanted)
            for (Vec2& x : square.nodes) x = Vec2(20.0 * x.x() + 3.0 * x.y(), x.y() - 7.0);
        const BodyMesh mesh(square);
        std::size_t found = 0, asked = 0;
        for (int e = 0; e < std::ssize(mesh->elements); e += 3) {
            const Vec2 place = centre(*mesh, e);
            const double radius = e % 2 == 0 ? 0.0 : 0.1;
            const std::vector<int> near = mesh.elements_near(place, radius);
            EXPECT_TRUE(std::ranges::is_sorted(near));
            for (int other = 0; other < std::ssize(mesh->elements); ++other) {
                Eigen::AlignedBox2d box;
                for (const Vec2& corner : corners_of_element(*mesh, other)) box.extend(corner);
                const Vec2 reach = Vec2::Constant(radius);
                const bool reaches = box.intersects(Eigen::AlignedBox2d(place - reach, place + reach));
                EXPECT_TRUE(!reaches || std::ranges::binary_search(near, other)) << e << " " << other;
            }
            found += near.size();
            asked += mesh->elements.size();
        }
        EXPECT_LT(4 * found, asked);
    }
}

TEST(BodyMesh, AnswersFromOutside) {
    const BodyMesh mesh(square_mesh(4)), none;
    EXPECT_EQ(mesh.elements_near({-5.0, 7.0}, 100.0).size(), 16U);
    EXPECT_TRUE(none.elements_near({0.0, 0.0}, 1.0).empty());
}

}  // namespace
}  // namespace stria::test
