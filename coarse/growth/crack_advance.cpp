#include "coarse/growth/crack_advance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "coarse/enrichment/tip_reach.hpp"
#include "common/crack/crack_end.hpp"
#include "common/crack/straight_way.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"

namespace stria::coarse {

namespace {

/// From the edge over which a crack has come into the element of its tip to the tip, mm; that of faces that end there,
/// too. Infinite where it has come over none.
double behind_edge(const EnrichedMesh& mesh, const Tip& tip) {
    if (tip.beyond > 0.0) return tip.beyond;
    const double way = tip.upper, place = tip.s + way * tip.beyond;
    double nearest = std::numeric_limits<double>::infinity();
    for (const CrackPiece& piece : mesh.pieces) {
        const double s = tip.upper > 0 ? piece.s.front() : piece.s.back();
        const bool comes_in = (tip.upper > 0 ? piece.entry : piece.exit) >= 0.0;
        if (piece.crack == tip.crack && comes_in && way * (place - s) > 0.0)
            nearest = std::min(nearest, way * (place - s));
    }
    return nearest;
}

/// The end ahead of a tip of the element edge along which its crack runs, as far as the mesh has a node there within
/// two elements.
std::optional<Vec2> end_of_edge_ahead(const EnrichedMesh& mesh, const Tip& tip) {
    const CrackPiece* piece = piece_of(mesh.pieces, tip);
    if (piece == nullptr || piece->neighbour < 0) return {};
    constexpr double rounding = 1e-9;  // elements
    const double element = tip_element_edge(mesh, tip);
    std::optional<Vec2> nearest;
    double ahead = 2.0 * element;
    for (const Vec2& node : mesh.nodes) {
        const double along = (node - tip.position).dot(tip.direction);
        const bool lies_on_way = std::abs(cross(tip.direction, node - tip.position)) < rounding * element;
        if (!lies_on_way || along <= rounding * element || along >= ahead) continue;
        ahead = along;
        nearest = node;
    }
    return nearest;
}

/// From here on the crack runs along a `way` that leads to a tip. What lies at its other end stays where it is.
void lead_along(CrackSection& crack, const Tip& tip, std::vector<Vec2> way) {
    if (tip.upper < 0) {
        std::ranges::reverse(way);
        crack.grown_at_start += length_of(way) - length_of(crack.points);
    }
    crack.points = std::move(way);
}

}  // namespace

double turn(double angle, double stretch, double increment, double element) {
    constexpr double tolerance = 1e-4;
    const double over = 0.5 * (std::min(stretch, element) + increment);
    return std::abs(angle) * over < tolerance * element ? 0.0 : angle;
}

double turn_of(const Tip& tip, const std::vector<CrackSection>& longer) {
    const Vec2 now = direction_of_end(longer[at(tip.crack)], tip);
    return std::atan2(cross(tip.direction, now), tip.direction.dot(now));
}

double largest_turn(const std::vector<Tip>& tips, const std::vector<CrackSection>& longer) {
    double largest = 0.0;
    for (const Tip& tip : tips) largest = std::max(largest, std::abs(turn_of(tip, longer)));
    return largest;
}

double behind_sharp_turn(const CrackSection& crack, const Tip& tip) {
    const std::vector<Vec2> way = points_to(crack, tip);
    double behind = 0.0;
    for (std::size_t corner = way.size() - 2; corner > 0; --corner) {
        const Vec2 ahead = way[corner + 1] - way[corner], before = way[corner] - way[corner - 1];
        behind += ahead.norm();
        if (std::abs(std::atan2(cross(before, ahead), before.dot(ahead))) > sharp_turn) return behind;
    }
    return std::numeric_limits<double>::infinity();
}

// By a node the mesh holds a tip on it (snapped_onto_mesh()). What it has been moved by along its way is owed to the
// next advance, or short steps would not add up. A corner is where the mesh has it, or the way from there would lead
// astray.
void advance(CrackSection& crack, const Tip& tip, const Vec2& direction, double increment) {
    std::vector<Vec2> way = points_to(crack, tip);
    const double owed = (way.back() - tip.position).dot(direction);
    const Vec2 next = tip.position + (increment + owed) * direction;
    const bool straight = std::abs(cross(tip.direction, direction)) < 1e-12;
    if (!straight && way.size() > 2 && way[way.size() - 2] == tip.position) way.pop_back();  // it has not left it yet
    if (!straight) {
        way.back() = tip.position;
        way.push_back(next);
    } else {
        way.back() = next;
    }
    way.back() = on_rounded_way(way.end()[-2], way.back());
    lead_along(crack, tip, std::move(way));
}

// Bends that lie beyond the edge, too, are left away.
bool bend_before_edge(CrackSection& longer, const EnrichedMesh& mesh, const Tip& tip) {
    constexpr double before_edge = 0.02, most_of_stretch = 0.9;  // elements; of the way since a bend
    const double element = tip_element_edge(mesh, tip);
    double back = behind_edge(mesh, tip) + before_edge * element;
    std::vector<Vec2> way = points_to(longer, tip);
    const Vec2 end = way.back();
    way.pop_back();
    if (way.back() != tip.position || back > element) return false;
    for (; way.size() > 1; way.pop_back()) {
        const Vec2 stretch = way.back() - way[way.size() - 2];
        if (back <= most_of_stretch * stretch.norm()) {
            way.back() -= back * stretch.normalized();
            way.push_back(end);
            lead_along(longer, tip, std::move(way));
            return true;
        }
        back = std::max(back - stretch.norm(), before_edge * element);
    }
    return false;
}

std::vector<std::vector<CrackSection>> bent_before_edges(const std::vector<CrackSection>& longer,
                                                         const EnrichedMesh& mesh) {
    std::vector<std::vector<CrackSection>> ways;
    std::vector<CrackSection> all = longer;
    for (const Tip& tip : mesh.tips) {
        if (!bend_before_edge(all[at(tip.crack)], mesh, tip)) continue;
        ways.push_back(longer);
        (void)bend_before_edge(ways.back()[at(tip.crack)], mesh, tip);
    }
    if (ways.size() > 1) ways.push_back(std::move(all));
    return ways;
}

bool turn_at_end_of_edge(CrackSection& longer, const EnrichedMesh& mesh, const Tip& tip) {
    std::vector<Vec2> way = points_to(longer, tip);
    const Vec2 advance = way.back() - tip.position;
    if (way[way.size() - 2] != tip.position) return false;
    const std::optional<Vec2> corner = end_of_edge_ahead(mesh, tip);
    if (!corner) return false;
    const double after = advance.norm() - (*corner - tip.position).norm();
    way.pop_back();
    if (after > 0.0) {
        way.back() = *corner;
        way.push_back(on_rounded_way(*corner, *corner + after * advance.normalized()));
    } else {
        way.back() = on_rounded_way(way[way.size() - 2], tip.position + advance.norm() * tip.direction);
    }
    lead_along(longer, tip, std::move(way));
    return true;
}

void turn_where_faces_end(std::vector<CrackSection>& longer, const EnrichedMesh& mesh) {
    for (const Tip& tip : mesh.tips)
        if (mesh.tip_functions == 0 && tip.beyond < 0.0) (void)turn_at_end_of_edge(longer[at(tip.crack)], mesh, tip);
}

std::vector<std::vector<CrackSection>> turned_at_ends_of_edges(std::vector<CrackSection> longer,
                                                               const EnrichedMesh& mesh) {
    bool any = false;
    for (const Tip& tip : mesh.tips) any = turn_at_end_of_edge(longer[at(tip.crack)], mesh, tip) || any;
    if (!any) return {};
    return {std::move(longer)};
}

TipResult loaded_by(TipResult reached) {
    reached.K_I -= reached.K_I_of_wake;
    reached.K_II -= reached.K_II_of_wake;
    return reached;
}

std::vector<TipResult> directing(std::vector<TipResult> nominal, const std::vector<TipResult>& reached,
                                 const std::vector<double>& largest) {
    constexpr double nothing = 0.005;  // of the largest K; less than nothing of K_I, too: that is a tip pressed shut
    if (std::ranges::none_of(reached, [](const TipResult& tip) { return tip.contact_length > 0.0; })) return nominal;
    for (std::size_t t = 0; t < nominal.size(); ++t) {
        const TipResult tip = loaded_by(reached[t]);
        if (tip.rings_flow || std::max(tip.K_I, std::abs(tip.K_II)) <= nothing * largest[t]) continue;
        nominal[t].K_I = tip.K_I;
        nominal[t].K_II = tip.K_II;
    }
    return nominal;
}

std::vector<CrackSection> longer_cracks(std::vector<CrackSection> cracks, GrowthDirection direction,
                                        const std::vector<TipAdvance>& advances) {
    constexpr double nothing = 1e-6;  // elements: no K is told of a bend so near to its tip
    for (const auto& [tip, K_I, K_II, by, element] : advances) {
        if (by == 0.0) continue;
        CrackSection& crack = cracks[at(tip.crack)];
        double angle = 0.0;
        if (direction == GrowthDirection::HoopStress)
            angle = turn(hoop_stress_angle(K_I, K_II), last_stretch(crack, tip).norm(), by, element);
        if (angle != 0.0 && by < nothing * element) continue;
        advance(crack, tip, Eigen::Rotation2Dd(angle) * tip.direction, by);
    }
    return cracks;
}

}  // namespace stria::coarse
