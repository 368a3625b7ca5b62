#include "coarse/model/rings.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "coarse/enrichment/tip_reach.hpp"
#include "common/case/case_questions.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// Over the outer radius of the largest ring. The second is there for plastic zones that reach into the first.
constexpr std::array family{Annulus{0.5, 1.0}, Annulus{0.75, 1.0}, Annulus{0.35, 0.7}, Annulus{0.25, 0.5},
                            Annulus{0.175, 0.35}};
constexpr double elements_across = 2.0;

/// In elements across the radius. In a smaller ring of one metal T is off by several percent: K and T are told across
/// metals instead.
constexpr double least_for_T = 4.0;

/// Across the radius of the largest ring, in the longest edges of the body: more of them change K by 1e-6 to 1e-5, and
/// what is near a tip is paid for in each increment and in each growth.
constexpr double most_across = 40.0;

/// Of the distance to what the largest ring stays off: boundaries, bends, loads. A point that bears a force by itself
/// is farther off. Stress beside it goes with 1/r: K, of first order in it, was right to 0.002 in rings that came as
/// near as others, and J, of second order, was 2.2 times what it is (ten elements between tip and point; 1.02 now).
constexpr double off_others = 0.95, off_points = 0.6;

/// Likewise of the distance to another tip: half of the way tells of its plastic zone apart from that of the other tip.
constexpr double off_tips = 0.475;

/// To the other end of a crack with elastic fields, as long as that is not so many elements: of two to four elements it
/// had K 30 to 1 % low in rings of half of the way, and it is within 2 % in these. With 0.7 or 0.9 it is as good from
/// three elements on. Beside other cracks, and with more elements, they are no better than half of the way.
constexpr double off_the_other_end = 0.8, elements_to_the_other_end = 4.0;

/// Metal may flow over any number of elements as large as the body's: J is then wanted from as far away as there is.
bool flows_far(const Scene& scene) { return scene.materials.may_yield() && scene.input.fine.refine == 1; }

/// An elastic body whose cracks neither grow nor touch pays once, and its K converges with the mesh.
bool is_solved_once(const Scene& scene) { return !scene.input.growth && !needs_fine(scene.input); }

/// Longest element edge with an end inside each ring, mm; zero where there is none.
std::vector<double> longest_edges(const BodyMesh& mesh, const Tip& tip, std::span<const Annulus> rings) {
    const Vec2 farthest = Vec2::Constant(std::ranges::max(rings, {}, &Annulus::outer).outer);
    std::vector<double> longest(rings.size(), 0.0);
    mesh.visit_near({tip.position - farthest, tip.position + farthest}, [&](int element) {
        const std::array<Vec2, 4> corners = corners_of_element(*mesh, element);
        std::array<double, 4> distance{};
        for (std::size_t k = 0; k < 4; ++k) distance[k] = (corners[k] - tip.position).norm();
        for (std::size_t ring = 0; ring < rings.size(); ++ring) {
            const auto inside = [&](double r) { return r > rings[ring].inner && r < rings[ring].outer; };
            for (std::size_t k = 0; k < 4; ++k)
                if (inside(distance[k]) || inside(distance[(k + 1) % 4]))
                    longest[ring] = std::max(longest[ring], (corners[(k + 1) % 4] - corners[k]).norm());
        }
    });
    return longest;
}

/// Of the edges in each ring; where the body's longest one is small enough for all of them it serves.
std::vector<double> sizes_for(const Scene& scene, int tip, std::span<const Annulus> rings) {
    const double longest = scene.mesh.longest_edge();
    const auto is_thick = [&](const Annulus& ring) { return ring.outer - ring.inner >= elements_across * longest; };
    if (std::ranges::all_of(rings, is_thick)) return std::vector<double>(rings.size(), longest);
    return longest_edges(scene.mesh, scene.enriched.tips[at(tip)], rings);
}

double before_sharp_bend(const Scene& scene, int tip) {
    const auto bend = sharp_bend(scene.enriched, scene.input.cracks, scene.enriched.tips[at(tip)]);
    return bend ? bend->distance - elements_before_bend * bend->element : std::numeric_limits<double>::infinity();
}

bool leaves_J(const Scene& scene, int tip, double radius) {
    return radius >= least_for_J * tip_element_edge(scene.enriched, scene.enriched.tips[at(tip)]);
}

double one_metal_about(const Scene& scene, const EnrichedMesh& mesh, int tip) {
    return 0.95 * distance_to_interface(mesh, scene.materials, mesh.tips[at(tip)]);
}

bool spans_elastic_fields(const EnrichedMesh& mesh) {
    constexpr int functions = 4;  // of eq. (2)
    return mesh.tip_functions >= functions;
}

// Rings pass over a bend that is nearer than two elements. Up to it they would lie within the tip's element, whose
// corners have little of the weight of one that the tip has: K was up to 99 % too low, and not a number where no corner
// lay in a ring (verification.BentCracks.HaveTheirKBehindABend*).
RoomForRings room_in(const Scene& scene, const EnrichedMesh& mesh, bool elastic_fields, int tip_index) {
    const Tip& tip = mesh.tips[at(tip_index)];
    const double bend = distance_to_bend(scene.input.cracks, tip, bend_to_element * tip_element_size(mesh, tip));
    const double not_passed = std::max(bend, elements_behind_bend * tip_element_edge(mesh, tip));
    const double loads = distance_to_loads(scene.mesh, scene.loads, tip.position);
    const double other_end = 2.0 * half_way_to_other_end(mesh.tips, tip_index);
    const double farther =
        std::min(off_the_other_end * other_end, elements_to_the_other_end * tip_element_edge(mesh, tip));
    return {.boundary = off_others * distance_to_boundary(scene.mesh, tip.position),
            .bends_and_forces = std::min(off_others * std::min(not_passed, loads),
                                         off_points * distance_to_points(scene.mesh, scene.loads, tip.position)),
            .other_end = std::max(off_tips * other_end, elastic_fields ? farther : 0.0),
            .other_cracks = 2.0 * off_tips * half_way_to_other_cracks(scene.input.cracks, mesh.tips, tip_index)};
}

double largest_ring_in(const Scene& scene, const EnrichedMesh& mesh, bool elastic_fields, int tip_index) {
    const Tip& tip = mesh.tips[at(tip_index)];
    const RoomForRings room = room_in(scene, mesh, elastic_fields, tip_index);
    const double free = std::min({room.boundary, room.bends_and_forces, room.other_end, room.other_cracks});
    const double radius =
        flows_far(scene) || is_solved_once(scene) ? free : std::min(free, most_across * scene.mesh.longest_edge());
    const double of_one_metal = one_metal_about(scene, mesh, tip_index);
    return of_one_metal < least_for_T * tip_element_edge(mesh, tip) ? radius : std::min(radius, of_one_metal);
}

}  // namespace

double largest_ring_of_one_metal(const Scene& scene, int tip) { return one_metal_about(scene, scene.enriched, tip); }

double largest_ring_for_J(const Scene& scene, int tip) {
    return std::min(largest_ring_of_one_metal(scene, tip), before_sharp_bend(scene, tip));
}

bool metals_leave_J(const Scene& scene, int tip) { return leaves_J(scene, tip, largest_ring_of_one_metal(scene, tip)); }

bool bends_leave_J(const Scene& scene, int tip) { return leaves_J(scene, tip, before_sharp_bend(scene, tip)); }

bool has_elastic_fields(const Scene& scene) {
    return (scene.is_nominal || !scene.materials.may_yield()) && spans_elastic_fields(scene.enriched);
}

RoomForRings room_for_rings(const Scene& scene, int tip) {
    return room_in(scene, scene.enriched, has_elastic_fields(scene), tip);
}

double largest_ring(const Scene& scene, int tip) {
    return largest_ring_in(scene, scene.enriched, has_elastic_fields(scene), tip);
}

double largest_ring_of_either_body(const Scene& scene, int tip) {
    const double own = largest_ring(scene, tip);
    if (!scene.nominal) return own;
    return std::max(own, largest_ring_in(scene, *scene.nominal, spans_elastic_fields(*scene.nominal), tip));
}

std::vector<Annulus> rings_about(const Scene& scene, int tip) {
    const double radius = largest_ring(scene, tip);
    auto all = family;
    const double of_one_metal = largest_ring_of_one_metal(scene, tip);
    const bool one_metal = radius <= of_one_metal;
    const double for_J = largest_ring_for_J(scene, tip);
    for (Annulus& ring : all)
        ring = {ring.inner * radius, ring.outer * radius, one_metal, one_metal && ring.outer * radius <= for_J};
    const std::vector<double> sizes = sizes_for(scene, tip, all);
    std::vector<Annulus> rings;
    if (radius > for_J && leaves_J(scene, tip, for_J))
        rings.push_back({.inner = family[0].inner * for_J, .outer = for_J, .tells_K = false});
    const std::size_t first = rings.size();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const bool is_thick = sizes[k] > 0.0 && all[k].outer - all[k].inner >= elements_across * sizes[k];
        if (rings.size() == first || is_thick) rings.push_back(all[k]);
    }
    return rings;
}

std::size_t first_for_K(std::span<const Annulus> rings) {
    return at(std::ranges::find(rings, true, &Annulus::tells_K) - rings.begin());
}

}  // namespace stria::coarse
