#include "tests/stress/random_crack.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "tests/support/cracked_mesh.hpp"

namespace stria::test {
namespace {

Mesh mapped(Mesh mesh, const auto& map) {
    for (Vec2& x : mesh.nodes) x = map(x);
    return mesh;
}

/// Lines that lie closer and closer to the middle.
std::vector<double> graded_lines(int n) {
    std::vector<double> lines;
    for (int k = 0; k <= n; ++k) {
        const double t = 2.0 * k / n - 1.0;
        lines.push_back(0.5 + 0.5 * t * (0.4 + 0.6 * std::abs(t)));
    }
    return lines;
}

void mesh_plate(CrackedPlate& plate, Dice& dice) {
    const int n = 7 + dice.below(9);
    plate.h = 1.0 / n;
    const int kind = dice.below(6);
    static constexpr std::array names{"plain", "plain", "distorted", "graded", "slanted", "curved"};
    plate.mesh_name = fmt::format("{} {}", names[at(kind)], n);
    if (kind <= 1) plate.mesh = square_mesh(n);
    if (kind == 2) plate.mesh = distorted(square_mesh(n), dice.between(0.05, 0.2) / n);
    if (kind == 3) plate.mesh = coarse::grid_mesh(graded_lines(n), graded_lines(n));
    const double by = dice.between(-0.3, 0.3);
    if (kind == 4) plate.mesh = mapped(square_mesh(n), [&](const Vec2& x) { return Vec2(x.x() + by * x.y(), x.y()); });
    if (kind == 5)
        plate.mesh = mapped(square_mesh(n), [&](const Vec2& x) {
            return Vec2(x.x() + by * (1.0 - x.x()) * std::sin(std::numbers::pi * x.y()), x.y());
        });
}

/// A place on the left side: anywhere, on a node, or a hair off one.
Vec2 mouth(const CrackedPlate& plate, Dice& dice) {
    const auto& side = plate.mesh.boundary.at("left");
    const BoundaryEdge& edge = side[at(dice.below(static_cast<int>(side.size())))];
    const auto& nodes = plate.mesh.elements[at(edge.element)];
    const Vec2 &a = plate.mesh.nodes[at(nodes[at(edge.edge)])],
               &b = plate.mesh.nodes[at(nodes[at((edge.edge + 1) % 4)])];
    switch (dice.below(4)) {
    case 0:
        return a;
    case 1:
        return a + dice.decade(-13.0, -1.0) * (b - a);
    default:
        return a + dice.between(0.0, 1.0) * (b - a);
    }
}

const Vec2& place_of_nearest_node(const Mesh& mesh, const Vec2& x) { return mesh.nodes[at(nearest_node(mesh, x))]; }

/// A place on the edge of some element beside the nearest node.
Vec2 on_an_edge(const Mesh& mesh, const Vec2& x, Dice& dice) {
    const Vec2& node = place_of_nearest_node(mesh, x);
    std::vector<Vec2> neighbours;
    for (const auto& element : mesh.elements)
        for (std::size_t k = 0; k < 4; ++k)
            if (mesh.nodes[at(element[k])] == node) neighbours.push_back(mesh.nodes[at(element[(k + 1) % 4])]);
    const Vec2& other = neighbours[at(dice.below(static_cast<int>(neighbours.size())))];
    return node + dice.between(0.0, 1.0) * (other - node);
}

/// As it is, or moved onto a node or an edge, or a hair beside one.
Vec2 attracted(const CrackedPlate& plate, const Vec2& x, Dice& dice) {
    const double angle = dice.between(0.0, 2.0 * std::numbers::pi);
    const Vec2 hair = plate.h * dice.decade(-13.0, -1.0) * Vec2(std::cos(angle), std::sin(angle));
    switch (dice.below(8)) {
    case 0:
        return place_of_nearest_node(plate.mesh, x);
    case 1:
        return place_of_nearest_node(plate.mesh, x) + hair;
    case 2:
        return on_an_edge(plate.mesh, x, dice);
    case 3:
        return on_an_edge(plate.mesh, x, dice) + hair;
    default:
        return x;
    }
}

bool well_inside(const Vec2& x) { return (x - Vec2(0.5, 0.5)).lpNorm<Eigen::Infinity>() < 0.34; }

}  // namespace

double Dice::decade(double low, double high) { return std::pow(10.0, between(low, high)); }

CrackedPlate random_crack(unsigned seed) {
    Dice dice(seed);
    CrackedPlate plate;
    mesh_plate(plate, dice);
    const bool at_edge = dice.one_in(2);
    double heading = dice.between(-0.9, 0.9);
    if (at_edge) {
        const Vec2 start = mouth(plate, dice);
        if (dice.one_in(2))
            plate.points.push_back(start - 0.3 * Vec2(std::cos(heading), std::sin(heading)));  // outside
        if (plate.points.empty() || dice.one_in(2)) plate.points.push_back(start);
    } else {
        plate.points.push_back(attracted(plate, Vec2(dice.between(0.25, 0.4), dice.between(0.3, 0.7)), dice));
    }
    const int segments = 1 + (dice.one_in(2) ? 0 : dice.below(5));
    const double turn = dice.one_in(3) ? 0.0 : 0.8;
    for (int k = 0; k < segments; ++k) {
        const double length = k == 0 ? dice.between(0.25, 0.5) : plate.h * dice.decade(-3.0, 0.7);
        const Vec2 next = plate.points.back() + length * Vec2(std::cos(heading), std::sin(heading));
        heading += turn * dice.between(-1.0, 1.0);
        if (!well_inside(next) && k > 0) break;
        plate.points.push_back(turn > 0.0 || k == 0 ? attracted(plate, next, dice) : next);
    }
    const Vec2 first = plate.points.front(), last = plate.points.back();
    for (const Vec2& x : plate.points)
        if (std::abs(cross(last - first, x - first)) > 1e-12 * (last - first).squaredNorm()) plate.straight = false;
    return plate;
}

}  // namespace stria::test
