#include "coarse/model/crack_room.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "coarse/enrichment/crack_length.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/specimen/specimen.hpp"
#include "common/crack/crack_path.hpp"
#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

constexpr const char* advice = "smaller elements there (mesh.size, mesh.grading or the mesh file) give it room";

/// Largest size of a coordinate, mm.
double extent_of(const Mesh& mesh) {
    double extent = 0.0;
    for (const Vec2& node : mesh.nodes) extent = std::max(extent, node.lpNorm<Eigen::Infinity>());
    return extent;
}

}  // namespace

void require_near(const Mesh& mesh, const std::vector<CrackSection>& cracks) {
    constexpr double far = 1e6;  // of the body
    const double farthest = far * extent_of(mesh);
    for (std::size_t c = 0; c < cracks.size(); ++c) {
        for (const Vec2& point : cracks[c].points) {
            if (point.lpNorm<Eigen::Infinity>() > farthest)
                throw CaseError(fmt::format("crack.{}.points: ({}, {}) is too far from the body; a mouth may lie just "
                                            "outside of it",
                                            c, point.x(), point.y()));
        }
    }
}

void require_room(const Mesh& mesh, const EnrichedMesh& enriched, int refined) {
    const double least = smallest_edge * extent_of(mesh);
    for (const Tip& tip : enriched.tips) {
        const double edge = tip_element_edge(enriched, tip) / refined;
        const double length = length_in_body(enriched, tip.crack);
        const double distance = distance_to_boundary(mesh, tip.position);
        if (edge < least)
            throw CaseError(fmt::format("fine.refine = {}: elements of {:.3g} mm at a tip are too small beside the "
                                        "body, at least {:.3g} mm",
                                        refined, edge, least));
        if (length < edge)
            throw CaseError(fmt::format("crack.{}.points: the crack is {:.4g} mm long in the body, less than an "
                                        "element at its tip, {:.4g} mm; {}",
                                        tip.crack, length, edge, advice));
        if (distance < edge)
            throw TipAtBoundary(
                fmt::format("crack.{}.points: the tip at ({:.6g}, {:.6g}) is {:.4g} mm from the boundary, less than an "
                            "element, {:.4g} mm; a mouth lies on or outside of it; {}",
                            tip.crack, tip.position.x(), tip.position.y(), distance, edge, advice),
                fmt::format("crack {} meets the boundary: the next advance takes a tip to ({:.6g}, {:.6g}), {:.4g} mm "
                            "from it and less than an element, {:.4g} mm",
                            tip.crack, tip.position.x(), tip.position.y(), distance, edge));
    }
}

void require_room_beside_loads(const Mesh& mesh, const EnrichedMesh& enriched, const LoadsOfCase& loads, int refined) {
    for (const Tip& tip : enriched.tips) {
        const double edge = tip_element_edge(enriched, tip) / refined;
        const double distance = distance_to_loads(mesh, loads, tip.position);
        if (distance < edge)
            throw CrackOffMesh(fmt::format("crack.{}.points: the tip at ({:.6g}, {:.6g}) is {:.4g} mm from a node "
                                           "that is loaded or held, less than an element, {:.4g} mm; {}",
                                           tip.crack, tip.position.x(), tip.position.y(), distance, edge, advice));
    }
}

void require_tips(const EnrichedMesh& enriched, int cracks) {
    for (int crack = 0; crack < cracks; ++crack) {
        if (std::ranges::count(enriched.tips, crack, &Tip::crack) > 0) continue;
        throw CaseError(fmt::format("crack.{}.points: the crack cuts through from boundary to boundary; one of "
                                    "its ends must lie strictly inside",
                                    crack));
    }
}

}  // namespace stria::coarse
