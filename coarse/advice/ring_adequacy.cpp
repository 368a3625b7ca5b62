#include "coarse/advice/ring_adequacy.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <set>

#include "coarse/enrichment/crack_length.hpp"
#include "coarse/enrichment/tip_enrichment.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/enrichment/tip_support.hpp"
#include "coarse/model/rings.hpp"
#include "common/case/case_questions.hpp"
#include "common/crack/crack_end.hpp"

namespace stria::coarse {
namespace {

/// Across the radius of the largest one.
constexpr double elements_in_ring = 3.0, elements_with_fields = 2.0;
constexpr double least_for_K = 0.3;  // elements to another metal

/// To another crack, with which K is within two percent (median; docs/verification/elastic.md, tips that are near):
/// what stands at the tip's element alone leaves the crack a part of an element too short, whatever the ring, and that
/// part counts against the distance.
constexpr double elements_to_crack = 16.0, elements_without_functions = 40.0;

/// What else a sharp bend takes, for the end of a sentence.
std::string without_J(const Scene& scene, std::size_t tip, const char* to_what) {
    if (bends_leave_J(scene, static_cast<int>(tip))) return {};
    return fmt::format(", and J is not told nearer than {:g}{}", elements_for_J, to_what);
}

bool share_functions(const EnrichedMesh& mesh, int tip) {
    return std::ranges::any_of(mesh.terms.nodes(), [&](int node) {
        return std::ranges::any_of(mesh.terms[at(node)], [&](const Term& term) {
            return term.kind == Term::Kind::Gathered && term.owner == tip;
        });
    });
}

/// Elements across the radius of the largest ring with which K is within two percent (docs/verification/elastic.md,
/// tips that are near). Three everywhere; of an elastic body two are enough to the other end of a crack, and to the
/// boundary where the fields of elasticity stand on all elements about the tip's.
double elements_wanted(const Scene& scene, int tip, double element) {
    const RoomForRings room = room_for_rings(scene, tip);
    const double three = elements_in_ring * element;
    const bool off_the_rest = std::min(room.bends_and_forces, room.other_cracks) >= three;
    const bool off_boundary = room.boundary >= three || share_functions(scene.enriched, tip);
    return has_elastic_fields(scene) && off_the_rest && off_boundary ? elements_with_fields : elements_in_ring;
}

/// Whether other elements than the tip's have its functions at all of their nodes.
bool stand_about(const Scene& scene, const EnrichedMesh& mesh, int tip) {
    const std::set<int> own = tip_nodes(scene.mesh, *piece_of(mesh.pieces, mesh.tips[at(tip)]));
    const auto has = [&](int node) {
        return std::ranges::any_of(mesh.terms[at(node)], [&](const Term& term) {
            return term.kind != Term::Kind::Heaviside && term.owner == tip;
        });
    };
    return std::ranges::any_of(mesh.elements, [&](const std::array<int, 4>& corners) {
        return std::ranges::all_of(corners, has) &&
               !std::ranges::all_of(corners, [&](int node) { return own.contains(node); });
    });
}

}  // namespace

std::optional<MeshDoubt> doubt_of_bend(const Scene& scene, std::size_t t) {
    const Tip& tip = scene.enriched.tips[t];
    const double straight = straight_length(scene.input.cracks[at(tip.crack)], tip,
                                            bend_to_element * tip_element_size(scene.enriched, tip));
    const double element = tip_element_edge(scene.enriched, tip);
    if (straight >= elements_behind_bend * element) return std::nullopt;
    return MeshDoubt{MeshDoubtKind::Bend,
                     fmt::format("tip {}: its crack bends {:.3g} mm behind it, {:.2g} elements of {:.3g} mm; K is "
                                 "not resolved nearer than {:g}{}: smaller elements there",
                                 t, straight, straight / element, element, elements_behind_bend,
                                 without_J(scene, t, ""))};
}

std::optional<MeshDoubt> doubt_of_sharp_bend(const Scene& scene, std::size_t t) {
    const Tip& tip = scene.enriched.tips[t];
    const auto bend = sharp_bend(scene.enriched, scene.input.cracks, tip);
    if (!bend || bends_leave_J(scene, static_cast<int>(t))) return std::nullopt;
    const double element = std::max(bend->element, tip_element_edge(scene.enriched, tip));
    return MeshDoubt{MeshDoubtKind::Bend,
                     fmt::format("tip {}: its crack bends sharply {:.3g} mm behind it, {:.2g} elements of {:.3g} mm; J "
                                 "wants {:g} or more and is not told: elements of {:.3g} mm or less there",
                                 t, bend->distance, bend->distance / element, element, elements_for_J,
                                 bend->distance / elements_for_J)};
}

std::optional<MeshDoubt> doubt_of_room(const Scene& scene, std::size_t tip, double radius) {
    const double element = tip_element_edge(scene.enriched, scene.enriched.tips[tip]);
    if (radius >= elements_in_ring * element || doubt_of_bend(scene, tip)) return std::nullopt;
    const double wanted = elements_wanted(scene, static_cast<int>(tip), element);
    if (radius >= wanted * element) return std::nullopt;
    return MeshDoubt{
        MeshDoubtKind::Room,
        fmt::format("tip {}: the largest ring off edges, loads, bends and other tips has a radius of {:.3g} mm, {:.2g} "
                    "elements of {:.3g} mm; K and J want {:g} or more{}: smaller elements there",
                    tip, radius, radius / element, element, wanted,
                    without_J(scene, tip, " elements to a sharp bend"))};
}

// K and T are taken across metals, J is not.
std::optional<MeshDoubt> doubt_of_metal(const Scene& scene, std::size_t tip) {
    if (metals_leave_J(scene, static_cast<int>(tip))) return std::nullopt;
    const double radius = largest_ring_of_one_metal(scene, static_cast<int>(tip));
    const double element = tip_element_edge(scene.enriched, scene.enriched.tips[tip]);
    const bool K_is_off = radius < least_for_K * element;
    return MeshDoubt{MeshDoubtKind::Metal,
                     fmt::format("tip {}: the largest ring in its own metal has a radius of {:.3g} mm, {:.2g} elements "
                                 "of {:.3g} mm; J wants {:g} or more and is not told{}: smaller elements there",
                                 tip, radius, radius / element, element, least_for_J,
                                 K_is_off ? ", and K is off by more than one percent" : ""),
                     K_is_off ? 2 : 1};
}

// The zone has functions of its own: its fields tell J, the nominal body tells by what K cracks grow.
std::optional<MeshDoubt> doubt_of_neighbour(const Scene& scene, std::size_t t) {
    const EnrichedMesh& mesh = scene.enriched;
    const auto tip = static_cast<int>(t);
    const double element = tip_element_edge(mesh, mesh.tips[t]);
    const double distance = 2.0 * half_way_to_other_cracks(scene.input.cracks, mesh.tips, tip);
    const double wanted = mesh.tip_functions == 0 ? elements_without_functions : elements_to_crack;
    if (distance >= wanted * element || stand_about(scene, mesh, tip)) return std::nullopt;
    const bool of_zone = scene.nominal && stand_about(scene, *scene.nominal, tip);
    return MeshDoubt{
        MeshDoubtKind::Neighbour,
        fmt::format("tip {}: another crack is {:.3g} mm away, {:.2g} elements of {:.3g} mm; with {} {} may "
                    "be off by more than {} percent below {:g}: smaller elements there",
                    t, distance, distance / element, element,
                    mesh.tip_functions == 0 ? "no tip functions" : "tip functions on one element alone",
                    of_zone ? "J of the zone" : "K", of_zone ? "four" : "two", wanted)};
}

std::optional<TipOfFunctions> doubt_of_functions(const Scene& scene) {
    const EnrichedMesh& mesh = scene.enriched;
    const double none_below = choose_enrichment(scene.input).none_below;
    if (mesh.tip_functions == 0 || none_below == 0.0) return std::nullopt;
    const auto small = [&](const Tip& tip) { return none_below * length_in_body(mesh, tip.crack); };
    const auto wants_none = [&](const Tip& tip) {
        return may_touch(scene.input.cracks[at(tip.crack)]) && tip_element_edge(mesh, tip) < small(tip);
    };
    const auto wants_some = [&](const Tip& tip) { return tip_element_edge(mesh, tip) >= small(tip); };
    const auto none = std::ranges::find_if(mesh.tips, wants_none), some = std::ranges::find_if(mesh.tips, wants_some);
    if (none == mesh.tips.end() || some == mesh.tips.end()) return std::nullopt;
    const auto tip = static_cast<std::size_t>(some - mesh.tips.begin());
    return TipOfFunctions{
        tip,
        {MeshDoubtKind::Functions,
         fmt::format("tip {}: its elements of {:.3g} mm are larger than 1/{:g} of its crack, so functions stand "
                     "at all tips, at tip {}, too, whose elements are small enough for none; what they leave behind "
                     "makes opening loads there too high, by a tenth of K_max in a trial: fine.enrichment = "
                     "\"none\", or elements below {:.3g} mm at tip {}",
                     tip, tip_element_edge(mesh, *some), 1.0 / none_below, none - mesh.tips.begin(), small(*some),
                     tip)}};
}

}  // namespace stria::coarse
