// Where a section of the boundary acts.
#pragma once

#include <string>
#include <vector>

#include "common/case/case.hpp"
#include "common/fem/mesh.hpp"

namespace stria::coarse {

/// What one section acts on: named edges, a single node, or a pin.
struct Place {
    std::vector<BoundaryEdge> edges;
    std::vector<int> nodes;  // ascending
    const SpreadPoint* pin;  // or null
};

/// `key`: of the section, for complaints. Throws CaseError as resolve_boundaries() does.
Place place_of(const Mesh& mesh, const BoundarySection& section, const std::string& key);

/// Of the section's number, from 0.
std::string key_of(std::size_t section);

/// The two nodes of an edge in the order of the element.
std::array<int, 2> edge_nodes(const Mesh& mesh, const BoundaryEdge& edge);

/// The prescribed displacement, mm, zero where it is free.
Vec2 displacement_of(const BoundarySection& section);

}  // namespace stria::coarse
