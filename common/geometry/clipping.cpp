#include "common/geometry/clipping.hpp"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_2_algorithms.h>

#include <Eigen/Geometry>
#include <boost/variant/get.hpp>

namespace stria {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalPoint = Kernel::Point_2;
using CgalSegment = Kernel::Segment_2;
// Constraints may meet where rounded ends touch an edge: intersections are then constructed, not refused.
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Kernel, CGAL::Default, CGAL::Exact_predicates_tag>;

CgalPoint to_cgal(const Vec2& p) { return {p.x(), p.y()}; }
Vec2 from_cgal(const CgalPoint& p) { return {p.x(), p.y()}; }

Eigen::AlignedBox2d box_of(const Vec2& a, const Vec2& b) { return Eigen::AlignedBox2d(a.cwiseMin(b), a.cwiseMax(b)); }

}  // namespace

int orientation(const Vec2& a, const Vec2& b, const Vec2& c) {
    return static_cast<int>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c)));
}

std::optional<std::pair<Vec2, Vec2>> intersect(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const auto common = CGAL::intersection(CgalSegment(to_cgal(a), to_cgal(b)), CgalSegment(to_cgal(c), to_cgal(d)));
    if (!common) return std::nullopt;
    if (const auto* point = boost::get<CgalPoint>(&*common)) {
        // Whether they meet is exact, where they do is not: on nearly the same line it may come out anywhere along it.
        const Eigen::AlignedBox2d box = box_of(a, b).intersection(box_of(c, d));
        const Vec2 x = from_cgal(*point).cwiseMax(box.min()).cwiseMin(box.max());
        return std::pair{x, x};
    }
    const auto& overlap = boost::get<CgalSegment>(*common);
    return std::pair{from_cgal(overlap.source()), from_cgal(overlap.target())};
}

int side_of_polygon(std::span<const Vec2> polygon, const Vec2& point) {
    std::vector<CgalPoint> vertices;
    vertices.reserve(polygon.size());
    for (const Vec2& vertex : polygon) vertices.push_back(to_cgal(vertex));
    switch (CGAL::bounded_side_2(vertices.begin(), vertices.end(), to_cgal(point), Kernel())) {
    case CGAL::ON_BOUNDED_SIDE:
        return 1;
    case CGAL::ON_UNBOUNDED_SIDE:
        return -1;
    default:
        return 0;
    }
}

std::vector<std::array<Vec2, 3>> triangulate(std::span<const Vec2> polygon,
                                             std::span<const std::pair<Vec2, Vec2>> segments) {
    Triangulation triangulation;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        triangulation.insert_constraint(to_cgal(polygon[i]), to_cgal(polygon[(i + 1) % polygon.size()]));
    }
    for (const auto& [from, to] : segments) triangulation.insert_constraint(to_cgal(from), to_cgal(to));

    std::vector<std::array<Vec2, 3>> triangles;
    for (const auto& face : triangulation.finite_face_handles()) {
        const std::array<Vec2, 3> triangle{from_cgal(face->vertex(0)->point()), from_cgal(face->vertex(1)->point()),
                                           from_cgal(face->vertex(2)->point())};
        const Vec2 centre = (triangle[0] + triangle[1] + triangle[2]) / 3.0;
        if (side_of_polygon(polygon, centre) > 0) triangles.push_back(triangle);
    }
    return triangles;
}

}  // namespace stria
