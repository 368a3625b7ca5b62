#include "coarse/specimen/regions.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

std::vector<Vec2> polygon_of(const RegionSection& region) {
    const std::vector<Vec2>& outline = region.outline;
    if (outline.size() != 2) return outline;
    const Vec2 low = outline[0].cwiseMin(outline[1]), high = outline[0].cwiseMax(outline[1]);
    return {low, {high.x(), low.y()}, high, {low.x(), high.y()}};
}

/// A point on an edge that two polygons share is in one of them: an edge is the same from either end.
bool holds(const std::vector<Vec2>& polygon, const Vec2& x) {
    bool inside = false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const Vec2 &from = polygon[k], &to = polygon[(k + 1) % polygon.size()];
        const Vec2 &low = from.y() < to.y() ? from : to, &high = from.y() < to.y() ? to : from;
        if (x.y() < low.y() || x.y() >= high.y()) continue;
        if (low.x() + (high.x() - low.x()) * (x.y() - low.y()) / (high.y() - low.y()) > x.x()) inside = !inside;
    }
    return inside;
}

/// The elements of the k-th region, counted from 0, ascending.
std::vector<int> elements_of(const Mesh& mesh, const RegionSection& region, int k) {
    if (!region.group) {
        const std::vector<Vec2> polygon = polygon_of(region);
        std::vector<int> elements;
        for (int e = 0; e < std::ssize(mesh.elements); ++e)
            if (holds(polygon, centre(mesh, e))) elements.push_back(e);
        return elements;
    }
    if (const auto found = mesh.groups.find(*region.group); found != mesh.groups.end()) return found->second;
    std::string names;
    for (const auto& [name, elements] : mesh.groups) names += (names.empty() ? "" : ", ") + name;
    throw CaseError(fmt::format("region.{}.group: \"{}\" is no group of elements of the mesh, available: {}", k,
                                *region.group, names.empty() ? "none" : names));
}

/// Whether an outline runs between the centre of an element and one of its corners.
bool cuts(const std::vector<Vec2>& polygon, const Mesh& mesh, int element) {
    constexpr double almost = 1.0 - 1e-6;
    const Vec2 middle = centre(mesh, element);
    const bool inside = holds(polygon, middle);
    return std::ranges::any_of(mesh.elements[at(element)], [&](int node) {
        return holds(polygon, middle + almost * (mesh.nodes[at(node)] - middle)) != inside;
    });
}

}  // namespace

MeshLines lines_of(const std::vector<RegionSection>& regions) {
    MeshLines lines;
    for (const RegionSection& region : regions) {
        const std::vector<Vec2> polygon = polygon_of(region);
        for (std::size_t k = 0; k < polygon.size(); ++k)
            for (const int axis : {0, 1})
                if (const double here = polygon[k][axis]; here == polygon[(k + 1) % polygon.size()][axis])
                    lines[at(axis)].push_back(here);
    }
    keep_each_once(lines);
    return lines;
}

void keep_each_once(MeshLines& lines) {
    for (std::vector<double>& along : lines) {
        std::ranges::sort(along);
        along.erase(std::ranges::unique(along).begin(), along.end());
    }
}

std::vector<int> materials_of_elements(const Mesh& mesh, const std::vector<RegionSection>& regions) {
    std::vector<int> material(regions.empty() ? 0 : mesh.elements.size(), 0);
    for (int k = 0; k < std::ssize(regions); ++k) {
        const RegionSection& region = regions[at(k)];
        const std::vector<int> elements = elements_of(mesh, region, k);
        for (const int e : elements) {
            const Vec2 middle = centre(mesh, e);
            if (material[at(e)] > 0)
                throw CaseError(fmt::format("region.{}.{}: overlaps region {} near ({:.6g}, {:.6g})", k,
                                            region.group ? "group" : "outline", material[at(e)] - 1, middle.x(),
                                            middle.y()));
            material[at(e)] = k + 1;
        }
        if (elements.empty())
            throw CaseError(fmt::format("region.{}.outline: holds no element of the mesh: it lies outside the body, "
                                        "or is smaller than the elements there",
                                        k));
    }
    return material;
}

std::vector<std::string> region_warnings(const Mesh& mesh, const std::vector<RegionSection>& regions) {
    std::vector<std::string> warnings;
    for (std::size_t k = 0; k < regions.size(); ++k) {
        const std::vector<Vec2> polygon = polygon_of(regions[k]);
        int count = 0;
        for (int e = 0; e < std::ssize(mesh.elements); ++e) count += cuts(polygon, mesh, e) ? 1 : 0;
        if (count > 0)
            warnings.push_back(fmt::format("region {}: its outline runs through {} elements; each is of the material "
                                           "at its centre, so the interface has steps",
                                           k, count));
    }
    return warnings;
}

}  // namespace stria::coarse
