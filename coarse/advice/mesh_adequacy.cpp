#include "coarse/advice/mesh_adequacy.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

#include "coarse/enrichment/crack_length.hpp"
#include "coarse/enrichment/tip_enrichment.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/fracture/plastic_zone.hpp"
#include "coarse/load/load_history.hpp"
#include "coarse/model/rings.hpp"
#include "coarse/specimen/regions.hpp"
#include "coarse/zone/tip_refinement.hpp"
#include "common/case/case_questions.hpp"
#include "common/case/schema/method_schema.hpp"

namespace stria::coarse {
namespace {

constexpr double across_zone = 5.0;       // elements, the forward zone
constexpr double ahead_in_stress = 10.0;  // elements, ahead of a tip that grows
constexpr double ahead_in_strain = 5.0;
constexpr double to_distance = 1.2;       // elements, from the tip to where closure is looked at
constexpr double rounding = 1e-9;         // of an element's edge, which is a difference of places
constexpr double most_at_a_time = 2.0;    // elements
constexpr double part_of_element = 0.05;  // by which growth may miss a whole number of them
constexpr double most_of_zone = 0.1;      // at a time, in plane stress
constexpr double elements_in_ring = 3.0;  // across the radius of the largest one
constexpr double least_for_K = 0.3;       // elements to another metal

bool asks_for_opening_loads(const Case& input) { return input.growth || some_touch(input.cracks); }

bool leaves_functions_in_contact(const Scene& scene, std::size_t t) {
    const Tip& tip = scene.enriched.tips[t];
    return scene.input.growth && scene.enriched.tip_functions > 0 && may_touch(scene.input.cracks[at(tip.crack)]);
}

/// A tip whose life its opening loads decide.
bool lives_by_closure(const Scene& scene, std::size_t t) {
    const std::optional<GrowthSection>& growth = scene.input.growth;
    const CrackSection& crack = scene.input.cracks[at(scene.enriched.tips[t].crack)];
    return growth && may_touch(crack) && grows_by_openings(*growth);
}

/// What too few elements do to a life (docs/verification/closure.md, lives on elements half as large).
const char* of_its_life(const Scene& scene, std::size_t t) {
    const bool known = scene.input.model.plane == PlaneState::Stress && lives_by_closure(scene, t);
    return known ? "; with half as many as are wanted, lives by opening loads were 7 to 75 % longer" : "";
}

/// How far metal flows that closes the faces, and how many elements opening loads want there.
struct WantedZone {
    double K_I;     // MPa sqrt(mm)
    double length;  // mm
    double elements;
    const char* place;
};

WantedZone wanted_zone(const Case& input, double K_I, double yield_stress) {
    const PlaneState plane = input.model.plane;
    if (!input.growth) return {K_I, forward_zone(K_I, yield_stress, plane), across_zone, ""};
    return {K_I, forward_zone_ahead(K_I, yield_stress, plane),
            plane == PlaneState::Stress ? ahead_in_stress : ahead_in_strain, " ahead of it"};
}

/// With which a length spans at least so many elements. `element`: as large as they are now, mm.
double refine_for(double elements, double length, double element, int refine) {
    return refine * std::exp2(std::ceil(std::log2(elements * element / length)));
}

std::optional<std::string> zone_warning(std::size_t tip, const WantedZone& zone, double element, int refine) {
    if (zone.length <= 0.0 || zone.length >= zone.elements * element) return std::nullopt;
    const double finer = refine_for(zone.elements, zone.length, element, refine);
    const std::string advice = finer <= most_refined ? fmt::format(": fine.refine = {:g}", finer)
                                                     : ", which no fine.refine gives: hardly anything yields";
    return fmt::format("tip {}: its forward plastic zone at K_I = {:.4g} MPa sqrt(mm), about {:.3g} mm{}, spans {:.2g} "
                       "elements of {:.3g} mm; opening loads want {:g} or more{}",
                       tip, zone.K_I, zone.length, zone.place, zone.length / element, element, zone.elements, advice);
}

/// Openings nearer to the tip are those of its own element (docs/verification/closure.md, what opening loads are good
/// to). `missing`: how often the element ought to have been split and cannot be (levels_missing).
std::optional<std::string> warning_of_distance(std::size_t tip, double distance, double element, int refine,
                                               int missing = 0) {
    constexpr double with_room = 1.3;  // elements, for an advice of two digits
    if (distance <= 0.0 || distance >= (1.0 - rounding) * to_distance * element) return std::nullopt;
    const double finer = refine_for(to_distance, distance, std::ldexp(element, -missing), refine);
    const bool helps = finer > refine && finer <= most_refined;
    const std::string advice = helps ? fmt::format("fine.refine = {:g}, or ", finer) : "";
    return fmt::format("tip {}: closure is looked at {:.3g} mm behind it, {:.2g} elements of {:.3g} mm; nearer than "
                       "{:g} the opening range is a tenth or more too small and K_op some hundredths of K_max off: "
                       "{}closure.distance = {:.2g}",
                       tip, distance, distance / element, element, to_distance, advice, with_room * element);
}

/// `small`: elements that would bear no function, mm; 0: its own bear them whatever their size.
std::string linear_warning(std::size_t tip, double small) {
    const std::string elements = small > 0.0 ? fmt::format(", and so do elements below {:.3g} mm", small) : "";
    return fmt::format("tip {}: nothing yields there, but what its functions leave behind as it grows holds the faces "
                       "open and closes them too soon; opening loads are some hundredths of K_max too high: "
                       "fine.enrichment = \"none\" leaves nothing behind{}",
                       tip, elements);
}

std::string retained_warning(std::size_t tip) {
    return fmt::format("tip {}: nothing yields there, and with growth.retain = \"all\" the functions of old tips hold "
                       "faces together that would part; after some steps opening loads are wrong, or there are none: "
                       "\"all\" is for comparison",
                       tip);
}

double rounded_down_to_two_digits(double length) {
    const double digit = std::pow(10.0, std::floor(std::log10(length)) - 1.0);
    return digit * std::floor(length / digit * (1.0 + 1e-12));
}

/// Faces end on edges of elements: with 1.2 of them at a time now one opens, and now two; with 1.04 two in one of 25
/// `growths`, which leaves a crest like that of two at a time. `element`: along the crack, mm.
std::optional<std::string> growth_warning(std::size_t tip, double increment, double element, int growths) {
    const double elements = increment / element, misses = std::abs(elements - std::round(elements));
    const bool is_whole = misses < part_of_element && growths * misses < 0.5;
    if (elements < most_at_a_time && (elements < 1.0 || is_whole)) return std::nullopt;
    return fmt::format(
        "tip {}: growth.increment = {:g} mm crosses {:.3g} elements of {:.3g} mm at a time; opening loads swing from "
        "step to step beyond one: growth.increment = {:.2g} or less, or elements of {:.3g} mm or more",
        tip, increment, elements, element, rounded_down_to_two_digits(element), increment);
}

/// In plane stress faces part last at the end of the last step, or at the distance that is looked at.
std::optional<std::string> step_warning(std::size_t tip, double increment, double distance, double zone) {
    if (zone <= 0.0 || increment <= std::max(most_of_zone * zone, distance)) return std::nullopt;
    return fmt::format(
        "tip {}: growth.increment = {:g} mm is {:.2g} of its forward plastic zone, about {:.3g} mm; nearer to the tip "
        "than such a step opening loads fall with it: growth.increment = {:.2g}, or a closure.distance no smaller",
        tip, increment, increment / zone, zone, most_of_zone * zone);
}

/// The crests that steps leave hold the faces (docs/verification/closure.md, how many elements).
std::optional<std::string> life_in_strain_warning(const Scene& scene, std::size_t t) {
    if (scene.input.model.plane != PlaneState::Strain || !lives_by_closure(scene, t)) return std::nullopt;
    return fmt::format(
        "tip {}: in plane strain closure is that of the growth at a time: where faces close, half of it lowers K_op by "
        "some hundredths of K_max and raises the opening range by some percent, and no limit has been seen. So the "
        "life is too long, the more so the larger growth.increment is",
        t);
}

/// Rings about a tip pass over a bend that is nearer to it than they are.
std::optional<std::string> bend_warning(const Scene& scene, std::size_t t) {
    const Tip& tip = scene.enriched.tips[t];
    const double straight = straight_length(scene.input.cracks[at(tip.crack)], tip,
                                            bend_to_element * tip_element_size(scene.enriched, tip));
    const double element = tip_element_edge(scene.enriched, tip);
    if (straight >= elements_behind_bend * element) return std::nullopt;
    return fmt::format("tip {}: its crack bends {:.3g} mm behind it, {:.2g} elements of {:.3g} mm; K is "
                       "not resolved nearer than {:g}: smaller elements there",
                       t, straight, straight / element, element, elements_behind_bend);
}

/// Tip functions stand at all tips or at none, and what they leave on the faces is seen where elements are small.
std::optional<std::string> functions_warning(const Scene& scene) {
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
    return fmt::format("tip {}: its elements of {:.3g} mm are larger than 1/{:g} of its crack, so functions stand "
                       "at all tips, at tip {}, too, whose elements are small enough for none; what they leave behind "
                       "makes opening loads there too high, by a tenth of K_max in a trial: fine.enrichment = "
                       "\"none\", or elements below {:.3g} mm at tip {}",
                       some - mesh.tips.begin(), tip_element_edge(mesh, *some), 1.0 / none_below,
                       none - mesh.tips.begin(), small(*some), some - mesh.tips.begin());
}

}  // namespace

std::optional<std::string> room_warning(const Scene& scene, std::size_t tip, double radius) {
    const double element = tip_element_edge(scene.enriched, scene.enriched.tips[tip]);
    if (radius >= elements_in_ring * element || bend_warning(scene, tip)) return std::nullopt;
    return fmt::format(
        "tip {}: the largest ring off edges, loads, bends and other tips has a radius of {:.3g} mm, {:.2g} "
        "elements of {:.3g} mm; K and J want {:g} or more: smaller elements there",
        tip, radius, radius / element, element, elements_in_ring);
}

// K and T are taken across metals, J is not.
int doubts_of_metal(const Scene& scene, std::size_t tip) {
    if (tells_J(scene, static_cast<int>(tip))) return 0;
    const double element = tip_element_edge(scene.enriched, scene.enriched.tips[tip]);
    return largest_ring_of_one_metal(scene, static_cast<int>(tip)) < least_for_K * element ? 2 : 1;
}

std::optional<std::string> metal_warning(const Scene& scene, std::size_t tip) {
    const int doubts = doubts_of_metal(scene, tip);
    if (doubts == 0) return std::nullopt;
    const double radius = largest_ring_of_one_metal(scene, static_cast<int>(tip));
    const double element = tip_element_edge(scene.enriched, scene.enriched.tips[tip]);
    return fmt::format("tip {}: the largest ring in its own metal has a radius of {:.3g} mm, {:.2g} elements of {:.3g} "
                       "mm; J wants {:g} or more and is not told{}: smaller elements there",
                       tip, radius, radius / element, element, least_for_J,
                       doubts > 1 ? ", and K is off by more than one percent" : "");
}

std::optional<std::string> distance_warning(const Scene& scene, std::size_t tip, double distance) {
    if (!asks_for_opening_loads(scene.input) || !std::isfinite(scene.yield_stress_at_tips()[tip])) return std::nullopt;
    const Tip& here = scene.enriched.tips[tip];
    return warning_of_distance(tip, distance, tip_element_edge(scene.enriched, here), scene.input.fine.refine,
                               levels_missing(scene, here));
}

std::vector<std::string> mesh_warnings(const Scene& scene, const std::vector<double>& K_I,
                                       const std::vector<double>& distance) {
    const Case& input = scene.input;
    std::vector<std::string> warnings = region_warnings(scene.mesh, input.regions);
    const auto add = [&](std::optional<std::string> warning) {
        if (warning) warnings.push_back(std::move(*warning));
    };
    for (std::size_t t = 0; t < scene.enriched.tips.size(); ++t) {
        std::optional<std::string> warning = bend_warning(scene, t);
        if (!warning) warning = room_warning(scene, t, largest_ring(scene, static_cast<int>(t)));
        if (!warning) warning = metal_warning(scene, t);
        add(std::move(warning));
    }
    add(functions_warning(scene));
    if (!asks_for_opening_loads(input)) return warnings;
    const std::vector<double> yield_stress = scene.yield_stress_at_tips();
    for (std::size_t t = 0; t < K_I.size(); ++t) {
        if (!std::isfinite(yield_stress[t])) {
            if (!leaves_functions_in_contact(scene, t)) continue;
            const Tip& tip = scene.enriched.tips[t];
            const double small = choose_enrichment(input).none_below * length_in_body(scene.enriched, tip.crack);
            const bool are_small = tip_element_edge(scene.enriched, tip) < small;  // another tip's are not
            warnings.push_back(input.growth->retain == Retain::All ? retained_warning(t)
                                                                   : linear_warning(t, are_small ? 0.0 : small));
            continue;
        }
        const double element = tip_element_edge(scene.enriched, scene.enriched.tips[t]);
        const WantedZone zone = wanted_zone(input, K_I[t], yield_stress[t]);
        const auto add_with_life = [&](std::optional<std::string> warning) {
            if (warning) warnings.push_back(std::move(*warning) + of_its_life(scene, t));
        };
        add_with_life(zone_warning(t, zone, element, input.fine.refine));
        if (zone.length > 0.0) add_with_life(warning_of_distance(t, distance[t], element, input.fine.refine));
        if (!input.growth) continue;
        add(life_in_strain_warning(scene, t));
        if (input.growth->increment.is_auto()) continue;
        const double at_a_time = input.growth->increment.value();
        const double along = tip_element_along(scene.enriched, scene.enriched.tips[t]);
        add(growth_warning(t, at_a_time, along, cycle_count(input.load) / input.growth->every));
        if (input.model.plane == PlaneState::Stress) add(step_warning(t, at_a_time, distance[t], zone.length));
    }
    return warnings;
}

}  // namespace stria::coarse
