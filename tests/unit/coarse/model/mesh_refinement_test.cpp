
#include <gtest/gtest.h>

#include "tests/support/cracked_mesh.hpp"
#include "tests/support/refined_squares.hpp"

namespace stria::coarse {
namespace {

const std::vector<RefinedDisk> left = {{{0.2, 0.5}, {0.2, 0.5}, 0.12, 3, 0.0}};
const std::vector<RefinedDisk> further = {{{0.45, 0.52}, {0.6, 0.55}, 0.12, 3, 0.0}};

double area(const Mesh& body, int element) {
    const auto& n = body.elements[at(element)];
    const Vec2 a = body.nodes[at(n[2])] - body.nodes[at(n[0])], b = body.nodes[at(n[3])] - body.nodes[at(n[1])];
    return cross(a, b) / 2.0;
}

void expect_sound(const Mesh& body) {
    double sum = 0.0;
    for (int e = 0; e < std::ssize(body.elements); ++e) sum += area(body, e);
    EXPECT_NEAR(sum, 1.0, 1e-12);
    const IndexLists around = elements_around_nodes(body);
    for (std::size_t node = 0; node < around.size(); ++node) {
        const auto [least, most] = std::ranges::minmax(around[node], {}, [&](int e) { return body.level[at(e)]; });
        EXPECT_LE(body.level[at(most)] - body.level[at(least)], 1);
    }
    for (const auto& [node, ends, larger] : body.hanging)
        EXPECT_EQ(body.nodes[at(node)], (body.nodes[at(ends[0])] + body.nodes[at(ends[1])]) / 2.0);
    for (const auto& [name, edges] : body.boundary) {
        double length = 0.0;
        for (const auto& [element, edge] : edges) {
            const auto& n = body.elements[at(element)];
            length += (body.nodes[at(n[at((edge + 1) % 4)])] - body.nodes[at(n[at(edge)])]).norm();
        }
        EXPECT_NEAR(length, 1.0, 1e-12) << name;
    }
}

/// The same body upside down, each element from its last corner.
Mesh mirrored(Mesh image) {
    for (Vec2& x : image.nodes) x.y() = 1.0 - x.y();
    for (auto& nodes : image.elements) std::ranges::reverse(nodes);
    for (auto& [name, edges] : image.boundary)
        for (auto& [element, edge] : edges) edge = (6 - edge) % 4;
    return image;
}

TEST(MeshRefinement, OfAMirroredMeshIsTheMirrorImage) {
    for (int n = 5; n < 15; ++n) {
        Mesh start = test::distorted(test::square_mesh(n), 0.25 / n);
        const Mesh image = mirrored(start);
        for (const double y : {0.3, 0.45, 0.62}) {
            const Vec2 place(0.4, y), mirror(0.4, 1.0 - y);
            const auto split = test::refined(start, {{place, place, 0.15, 1, 0.0}}).splits;
            EXPECT_EQ(split, test::refined(image, {{mirror, mirror, 0.15, 1, 0.0}}).splits) << n << ", " << y;
        }
    }
}

TEST(MeshRefinement, GoesOnWhereAMeshIsSplitAlready) {
    const Mesh once = test::refined(test::distorted(test::square_mesh(5), 0.02), left).mesh;
    const RefinedMesh twice = test::refined(once, further);
    expect_sound(twice.mesh);
    EXPECT_GT(twice.mesh.elements.size(), once.elements.size());
    for (std::size_t e = 0; e < once.elements.size(); ++e)
        EXPECT_EQ(twice.part_of[e] < 0, twice.mesh.elements[e] == once.elements[e]) << e;
    std::vector<double> parts(once.elements.size(), 0.0);
    for (int e = 0; e < std::ssize(twice.mesh.elements); ++e)
        if (twice.part_of[at(e)] >= 0) parts.at(at(twice.part_of[at(e)])) += area(twice.mesh, e);
    for (int e = 0; e < std::ssize(once.elements); ++e) {
        if (parts[at(e)] == 0.0) continue;
        EXPECT_NEAR(parts[at(e)], area(once, e), 1e-14) << e;
    }
    EXPECT_FALSE(asks_for_more(BodyMesh(twice.mesh), further, {}));
}

TEST(MeshRefinement, PartsStayInTheGroupOfTheWhole) {
    Mesh start = test::square_mesh(5);
    for (int e = 0; e < 25; e += 2) start.groups["even"].push_back(e);
    const RefinedMesh fine = test::refined(start, left);
    const std::vector<int>& even = fine.mesh.groups.at("even");
    EXPECT_TRUE(std::ranges::is_sorted(even));
    int split = 0;
    for (int e = 0; e < std::ssize(fine.mesh.elements); ++e) {
        const int whole = fine.part_of[at(e)] < 0 ? e : fine.part_of[at(e)];
        EXPECT_EQ(std::ranges::binary_search(even, e), whole % 2 == 0) << e;
        split += whole != e ? 1 : 0;
    }
    EXPECT_GT(split, 20);
}

// A line of nodes inside the body that is held: so are the nodes that splitting puts on it.
TEST(MeshRefinement, SetsOfNodesKeepTheirLines) {
    const auto on_line = [](const Mesh& body) {
        std::vector<int> nodes;
        for (int node = 0; node < std::ssize(body.nodes); ++node)
            if (std::abs(body.nodes[at(node)].y() - 0.4) < 1e-12) nodes.push_back(node);
        return nodes;
    };
    Mesh start = test::square_mesh(5);
    start.node_sets["line"] = on_line(start);
    ASSERT_EQ(start.node_sets["line"].size(), 6U);
    const Mesh fine = test::refined(start, left).mesh;
    EXPECT_GT(on_line(fine).size(), 10U);
    EXPECT_EQ(fine.node_sets.at("line"), on_line(fine));
}

TEST(MeshRefinement, ComesOutTheSameAgain) {
    const Mesh start = test::square_mesh(5);
    const RefinedMesh first = test::refined(start, left), second = test::refined(first.mesh, further);
    MeshSplits all = first.splits;
    all.insert(all.end(), second.splits.begin(), second.splits.end());
    const Mesh again = split_again(start, all);
    EXPECT_EQ(again.elements, second.mesh.elements);
    EXPECT_EQ(again.nodes, second.mesh.nodes);
    EXPECT_EQ(again.level, second.mesh.level);
    EXPECT_EQ(again.hanging.size(), second.mesh.hanging.size());
}

// What stays whole holds its neighbours back as well, lest they are smaller than half.
TEST(MeshRefinement, LeavesElementsWhole) {
    const Mesh start = test::refined(test::square_mesh(5), left).mesh;
    ElementSet never(start.elements.size());
    for (int e = 0; e < std::ssize(start.elements); ++e) {
        const Vec2 middle =
            (start.nodes[at(start.elements[at(e)][0])] + start.nodes[at(start.elements[at(e)][2])]) / 2.0;
        if (start.level[at(e)] == 0 && std::abs(middle.x() - 0.5) < 0.11) never.insert(e);
    }
    ASSERT_FALSE(never.none());
    const RefinedMesh around = test::refined(start, further, never);
    expect_sound(around.mesh);
    for (const int e : never.members()) EXPECT_EQ(around.mesh.elements[at(e)], start.elements[at(e)]);
    EXPECT_FALSE(around.splits.empty());
    EXPECT_LT(around.mesh.elements.size(), test::refined(start, further).mesh.elements.size());
    EXPECT_FALSE(asks_for_more(BodyMesh(around.mesh), further, never));
}

}  // namespace
}  // namespace stria::coarse
