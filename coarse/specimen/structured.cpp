#include "coarse/specimen/structured.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coarse/specimen/graded_axis.hpp"
#include "common/error.hpp"
#include "common/index.hpp"
#include "common/memory.hpp"

namespace stria::coarse {
namespace {

constexpr std::size_t max_elements = 4'000'000;

/// What the keys alone do not tell (common/case/checks/case_checks.cpp): how a grading lies in the body.
void check_in_body(const Grading& grading, const std::string& key, const Body& body) {
    const double least = smallest_edge * (body.high - body.low).maxCoeff();
    if (grading.size < least)
        throw CaseError(
            fmt::format("{}.size: {} mm is too small beside the body, at least {:.3g} mm", key, grading.size, least));
    for (const Vec2& point : grading.at)
        if (!body.holds(point))
            throw CaseError(fmt::format("{}.at: ({}, {}) is outside the body [{}, {}] x [{}, {}] mm", key, point.x(),
                                        point.y(), body.low.x(), body.high.x(), body.low.y(), body.high.y()));
}

/// What the gradings ask of the axis with this index, counted from the body's lower end. A line keeps its size along
/// itself, and anchors only across.
std::vector<AxisGrading> axis_gradings(const MeshSection& section, const Body& body, int axis) {
    std::vector<AxisGrading> result;
    for (const Grading& grading : section.grading) {
        const double from = grading.at.front()[axis] - body.low[axis];
        const double to = grading.at.back()[axis] - body.low[axis];
        const double outer_size = grading.radius > 0.0 ? grading.outer_size.value_or(grading.size) : grading.size;
        result.push_back({std::min(from, to), std::max(from, to), grading.size, outer_size, grading.radius,
                          grading.growth, from == to});
    }
    return result;
}

std::vector<double> axis_positions(const MeshSection& section, const Body& body, const MeshLines& lines, int axis) {
    std::vector<double> from_low = lines[at(axis)];
    for (double& line : from_low) line -= body.low[axis];
    std::vector<double> positions =
        graded_axis(body.high[axis] - body.low[axis], section.size, axis_gradings(section, body, axis), from_low);
    for (double& position : positions) position += body.low[axis];
    positions.back() = body.high[axis];
    return positions;
}

}  // namespace

Mesh grid_mesh(std::span<const double> xs, std::span<const double> ys) {
    const int columns = static_cast<int>(xs.size()) - 1, rows = static_cast<int>(ys.size()) - 1;
    Mesh mesh;
    mesh.nodes.reserve(xs.size() * ys.size());
    for (const double y : ys) {
        for (const double x : xs) mesh.nodes.emplace_back(x, y);
    }
    const auto node = [columns](int column, int row) { return row * (columns + 1) + column; };
    const auto element = [columns](int column, int row) { return row * columns + column; };
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            mesh.elements.push_back(
                {node(column, row), node(column + 1, row), node(column + 1, row + 1), node(column, row + 1)});
        }
    }
    for (int column = 0; column < columns; ++column) {
        mesh.boundary["bottom"].push_back({element(column, 0), 0});
        mesh.boundary["top"].push_back({element(column, rows - 1), 2});
    }
    for (int row = 0; row < rows; ++row) {
        mesh.boundary["right"].push_back({element(columns - 1, row), 1});
        mesh.boundary["left"].push_back({element(0, row), 3});
    }
    return mesh;
}

Mesh structured_mesh(const MeshSection& section, const Body& body, const MeshLines& lines) {
    for (std::size_t k = 0; k < section.grading.size(); ++k)
        check_in_body(section.grading[k], fmt::format("mesh.grading.{}", k), body);
    const std::vector<double> xs = axis_positions(section, body, lines, 0),
                              ys = axis_positions(section, body, lines, 1);
    if (xs.size() * ys.size() > max_elements) {
        throw CaseError(fmt::format("mesh.size: the mesh would have {} elements, at most {} are allowed",
                                    (xs.size() - 1) * (ys.size() - 1), max_elements));
    }
    const auto elements = static_cast<double>((xs.size() - 1) * (ys.size() - 1));
    require_memory(fmt::format("mesh.size: a mesh of {} elements", elements), elements * bytes_of_element);
    return grid_mesh(xs, ys);
}

Body rectangle(const MeshSection& section) { return {Vec2::Zero(), Vec2(section.width, section.height)}; }

Mesh rectangle_mesh(const MeshSection& section, const MeshLines& lines) {
    return structured_mesh(section, rectangle(section), lines);
}

}  // namespace stria::coarse
