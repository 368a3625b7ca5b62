// Small meshes with cracks, for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "coarse/enrichment/enrichment.hpp"
#include "coarse/specimen/structured.hpp"
#include "common/crack/crack_path.hpp"
#include "common/fem/body_mesh.hpp"
#include "common/fem/centre.hpp"
#include "common/fem/quadrature.hpp"
#include "common/index.hpp"
#include "common/integration/cut_element.hpp"
#include "common/integration/element_operator.hpp"

namespace stria::test {

/// n equal cells over [0, length].
inline std::vector<double> equal_cells(int n, double length = 1.0) {
    std::vector<double> xs;
    for (int k = 0; k <= n; ++k) xs.push_back(length * k / n);
    return xs;
}

inline Mesh square_mesh(int n, double length = 1.0) {
    return coarse::grid_mesh(equal_cells(n, length), equal_cells(n, length));
}

/// Moves the inner nodes of a rectangle by up to `amount` mm along each axis: no two elements stay alike.
inline Mesh distorted(Mesh mesh, double amount) {
    Vec2 low = mesh.nodes.front(), high = low;
    for (const Vec2& x : mesh.nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
        Vec2& x = mesh.nodes[n];
        if ((x.array() == low.array()).any() || (x.array() == high.array()).any()) continue;
        const auto k = static_cast<double>(n);
        x += amount * Vec2(std::sin(7.3 * k), std::cos(4.1 * k));
    }
    return mesh;
}

inline EnrichedMesh cracked(const Mesh& mesh, const std::vector<Vec2>& points, const coarse::TipEnrichment& tips) {
    return coarse::enrich(BodyMesh(mesh), {{.points = points, .contact = {}}}, tips);
}

inline EnrichedMesh cracked(const Mesh& mesh, const std::vector<Vec2>& points, int tip_functions = 6,
                            double exponent = 0.5) {
    return cracked(mesh, points, {tip_functions, exponent});
}

/// Crack 0 along `points`.
inline CrackPath path_on(Mesh mesh, const std::vector<Vec2>& points) {
    return resolve_crack(BodyMesh(std::move(mesh)), 0, points);
}

/// The crack inside an element, or null.
inline const CrackPiece* piece_in(const EnrichedMesh& mesh, int element) {
    const auto inside = [&](const CrackPiece& piece) { return piece.element == element && piece.neighbour < 0; };
    const auto found = std::ranges::find_if(mesh.pieces, inside);
    return found != mesh.pieces.end() ? &*found : nullptr;
}

inline bool has_tip_terms(const EnrichedMesh& mesh, int node) {
    return std::ranges::any_of(mesh.terms[at(node)], [](const Term& term) { return term.kind == Term::Kind::Tip; });
}

/// The shift of a node's Heaviside term, or 0.
inline double heaviside_side(const EnrichedMesh& mesh, int node) {
    for (const Term& term : mesh.terms[at(node)])
        if (term.kind == Term::Kind::Heaviside) return term.shift;
    return 0.0;
}

}  // namespace stria::test
