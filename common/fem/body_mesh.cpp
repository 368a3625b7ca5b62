#include "common/fem/body_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/index.hpp"

namespace stria {
namespace {

/// A little larger than an element.
Eigen::AlignedBox2d box_about(const Mesh& mesh, const std::array<int, 4>& element) {
    Eigen::AlignedBox2d box;
    for (const int node : element) box.extend(mesh.nodes[at(node)]);
    const Vec2 margin = Vec2::Constant(0.01 * box.diagonal().norm());
    return {box.min() - margin, box.max() + margin};
}

double longest_edge_of(const Mesh& mesh) {
    double squared = 0.0;
    for (const std::array<int, 4>& element : mesh.elements)
        for (std::size_t k = 0; k < 4; ++k)
            squared =
                std::max(squared, (mesh.nodes[at(element[k])] - mesh.nodes[at(element[(k + 1) % 4])]).squaredNorm());
    return std::sqrt(squared);
}

std::vector<int> first_numbers(std::size_t count) {
    std::vector<int> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

std::vector<int> ascending(std::vector<int> elements) {
    std::ranges::sort(elements);
    elements.erase(std::ranges::unique(elements).begin(), elements.end());
    return elements;
}

}  // namespace

// About as many cells as there are elements per four: one of the body's size lies in about four.
BodyMesh::Cells::Cells(const Mesh& mesh) {
    if (mesh.elements.empty()) return;
    Eigen::AlignedBox2d body;
    for (const Vec2& node : mesh.nodes) body.extend(node);
    const Vec2 extent = body.sizes();
    const double count = static_cast<double>(mesh.elements.size());
    origin = body.min();
    size = 2.0 * std::max(std::sqrt(extent.x() * extent.y() / count), extent.maxCoeff() / count);
    columns = static_cast<int>(extent.x() / size) + 1;
    rows = static_cast<int>(extent.y() / size) + 1;
    std::vector<std::size_t> first(at(columns) * at(rows) + 1, 0);
    std::vector<std::pair<int, std::size_t>> entered;  // an element and a cell
    entered.reserve(3 * mesh.elements.size());
    for (int e = 0; e < std::ssize(mesh.elements); ++e)
        for_each(box_about(mesh, mesh.elements[at(e)]), [&](std::size_t cell) {
            entered.emplace_back(e, cell);
            ++first[cell + 1];
        });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<std::size_t> next(first.begin(), first.end() - 1);
    std::vector<int> entries(first.back());
    for (const auto& [element, cell] : entered) entries[next[cell]++] = element;
    elements = {std::move(first), std::move(entries)};
}

int BodyMesh::Cells::along(double coordinate, double from, int count) const {
    return static_cast<int>(std::clamp(std::floor((coordinate - from) / size), 0.0, count - 1.0));
}

BodyMesh::Found::Found(Mesh whole)
    : mesh(std::move(whole)), around(elements_around_nodes(mesh)), cells(mesh),
      node_ids(first_numbers(mesh.nodes.size())), element_ids(first_numbers(mesh.elements.size())),
      longest_edge(longest_edge_of(mesh)) {}

BodyMesh::BodyMesh(Mesh mesh) : found_(std::make_shared<const Found>(std::move(mesh))) {}

std::vector<int> BodyMesh::elements_about(std::span<const int> nodes) const {
    std::vector<int> elements;
    for (const int node : nodes) {
        const std::span<const int> own = found_->around[at(node)];
        elements.insert(elements.end(), own.begin(), own.end());
    }
    return ascending(std::move(elements));
}

std::vector<int> BodyMesh::elements_near(std::span<const Eigen::AlignedBox2d> boxes) const {
    std::vector<int> elements;
    for (const Eigen::AlignedBox2d& box : boxes)
        found_->cells.for_each(box, [&](std::size_t cell) {
            const std::span<const int> own = found_->cells.elements[cell];
            elements.insert(elements.end(), own.begin(), own.end());
        });
    return ascending(std::move(elements));
}

std::vector<int> BodyMesh::elements_near(const Vec2& place, double radius) const {
    const Vec2 reach = Vec2::Constant(radius);
    const std::array box{Eigen::AlignedBox2d(place - reach, place + reach)};
    return elements_near(box);
}

}  // namespace stria
