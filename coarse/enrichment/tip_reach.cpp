#include "coarse/enrichment/tip_reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/crack/crack_end.hpp"
#include "common/fem/chord.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// To an edge of an element of a mesh, mm.
template <class AnyMesh> double distance_to_edge(const AnyMesh& mesh, int element, int edge, const Vec2& x) {
    const std::array<int, 4>& nodes = mesh.elements[at(element)];
    return distance_to_segment(x, mesh.nodes[at(nodes[at(edge)])], mesh.nodes[at(nodes[at((edge + 1) % 4)])]);
}

/// What a crack is beyond the place where its polyline, walked from the tip, leaves the band; empty where it does not.
std::vector<Vec2> beyond_straight(const CrackSection& crack, const Tip& tip, double band) {
    std::vector<Vec2> points = points_to(crack, tip);
    std::ranges::reverse(points);
    const auto across = [&](const Vec2& x) {  // with its sign: a stretch may come from the other side
        return cross(tip.direction, x - tip.position);
    };
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const double here = across(points[k]), next = across(points[k + 1]);
        if (std::abs(next) <= band) continue;
        const double t = std::clamp((std::copysign(band, next) - here) / (next - here), 0.0, 1.0);
        points[k] += t * (points[k + 1] - points[k]);
        points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(k));
        return points;
    }
    return {};
}

/// What a crack is from its first sharp bend on, walked from the tip; empty where it has none. Parts that follow each
/// other and are turned as much are one; it must go `band` across the line behind the tip.
std::vector<Vec2> from_sharp_bend_on(const CrackSection& crack, const Tip& tip, double band) {
    std::vector<Vec2> points = points_to(crack, tip);
    std::ranges::reverse(points);
    std::size_t first = 0;
    for (std::size_t k = 0; k + 1 < points.size(); ++k) {
        const Vec2 way = points[k] - points[k + 1];
        if (std::abs(std::atan2(cross(tip.direction, way), tip.direction.dot(way))) <= sharp_turn) {
            first = k + 1;
        } else if (std::abs(cross(tip.direction, points[k + 1] - points[first])) > band) {
            points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(first));
            return points;
        }
    }
    return {};
}

/// Edge of the element that holds the place of a crack that is nearest to a point, mm.
double element_edge_at(const EnrichedMesh& mesh, int crack, const Vec2& x) {
    double nearest = std::numeric_limits<double>::infinity();
    int element = -1;
    for (const CrackPiece& piece : mesh.pieces) {
        if (piece.crack != crack) continue;
        for (std::size_t k = 0; k + 1 < piece.points.size(); ++k) {
            const double distance = distance_to_segment(x, piece.points[k], piece.points[k + 1]);
            if (distance >= nearest) continue;
            nearest = distance;
            element = piece.element;
        }
    }
    return element < 0 ? 0.0 : edge_of_square(mesh, element);
}

double distance_to(const std::vector<Vec2>& polyline, const Vec2& x) {
    double distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k + 1 < polyline.size(); ++k)
        distance = std::min(distance, distance_to_segment(x, polyline[k], polyline[k + 1]));
    return distance;
}

}  // namespace

double distance_to_boundary(const Mesh& mesh, const Vec2& x) {
    double distance = 1e300;
    for (const auto& [name, edges] : mesh.boundary)
        for (const BoundaryEdge& edge : edges)
            distance = std::min(distance, distance_to_edge(mesh, edge.element, edge.edge, x));
    return distance;
}

double way_to_boundary(const Mesh& mesh, const Tip& tip) {
    double way = std::numeric_limits<double>::infinity();
    for (const auto& [name, edges] : mesh.boundary) {
        for (const BoundaryEdge& edge : edges) {
            const std::array<int, 4>& nodes = mesh.elements[at(edge.element)];
            const Vec2 from = mesh.nodes[at(nodes[at(edge.edge)])] - tip.position,
                       to = mesh.nodes[at(nodes[at((edge.edge + 1) % 4)])] - tip.position;
            const double below = cross(tip.direction, from), above = cross(tip.direction, to);
            if (below >= 0.0 || above < 0.0) continue;  // boundaries run counter-clockwise: the body ends there
            const double ahead = tip.direction.dot(from + below / (below - above) * (to - from));
            if (ahead > 0.0) way = std::min(way, ahead);
        }
    }
    return way;
}

double distance_to_interface(const EnrichedMesh& mesh, const Materials& materials, const Tip& tip) {
    double distance = std::numeric_limits<double>::infinity();
    for (int e = 0; e < std::ssize(mesh.material); ++e) {
        if (materials.are_alike(tip.material, mesh.material_of(e))) continue;
        for (int k = 0; k < 4; ++k) distance = std::min(distance, distance_to_edge(mesh, e, k, tip.position));
    }
    return distance;
}

double straight_length(const CrackSection& crack, const Tip& tip, double band) {
    const std::vector<Vec2> rest = beyond_straight(crack, tip, band);
    return rest.empty() ? std::numeric_limits<double>::infinity() : (rest.front() - tip.position).norm();
}

double half_way_to_other_end(std::span<const Tip> tips, int tip) {
    const Tip& own = tips[at(tip)];
    double nearest = std::numeric_limits<double>::infinity();
    for (int other = 0; other < std::ssize(tips); ++other)
        if (other != tip && tips[at(other)].crack == own.crack)
            nearest = std::min(nearest, (tips[at(other)].position - own.position).norm());
    return nearest / 2.0;
}

double half_way_to_other_cracks(const std::vector<CrackSection>& cracks, std::span<const Tip> tips, int tip) {
    const Tip& own = tips[at(tip)];
    double nearest = std::numeric_limits<double>::infinity();
    for (const Tip& other : tips)
        if (other.crack != own.crack) nearest = std::min(nearest, (other.position - own.position).norm());
    for (int crack = 0; crack < std::ssize(cracks); ++crack)
        if (crack != own.crack) nearest = std::min(nearest, distance_to(cracks[at(crack)].points, own.position));
    return nearest / 2.0;
}

double distance_to_bend(const std::vector<CrackSection>& cracks, const Tip& tip, double band) {
    if (tip.crack >= std::ssize(cracks)) return std::numeric_limits<double>::infinity();  // a field's, without a crack
    return distance_to(beyond_straight(cracks[at(tip.crack)], tip, band), tip.position);
}

std::optional<SharpBend> sharp_bend(const EnrichedMesh& mesh, const std::vector<CrackSection>& cracks, const Tip& tip) {
    if (tip.crack >= std::ssize(cracks)) return std::nullopt;  // as above
    const std::vector<Vec2> rest =
        from_sharp_bend_on(cracks[at(tip.crack)], tip, bend_to_element * tip_element_size(mesh, tip));
    if (rest.empty()) return std::nullopt;
    return SharpBend{distance_to(rest, tip.position), element_edge_at(mesh, tip.crack, rest.front())};
}

double room_in_body(const Mesh& mesh, const std::vector<CrackSection>& cracks, const Tip& tip, double band) {
    return std::min(distance_to_boundary(mesh, tip.position), distance_to_bend(cracks, tip, band));
}

double tip_element_size(const EnrichedMesh& mesh, const Tip& tip) {
    const CrackPiece* const piece = piece_of(mesh.pieces, tip);
    return piece != nullptr ? diagonal(mesh, piece->element) : 0.0;
}

double tip_element_edge(const EnrichedMesh& mesh, const Tip& tip) {
    const CrackPiece* const piece = piece_of(mesh.pieces, tip);
    return piece != nullptr ? edge_of_square(mesh, piece->element) : 0.0;
}

double tip_element_along(const EnrichedMesh& mesh, const Tip& tip) {
    const CrackPiece* const piece = piece_of(mesh.pieces, tip);
    return piece != nullptr ? chord(corners_of_element(mesh, piece->element), tip.direction) : 0.0;
}

}  // namespace stria::coarse
