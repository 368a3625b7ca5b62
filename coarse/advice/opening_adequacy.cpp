#include "coarse/advice/opening_adequacy.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <string>
#include <utility>

#include "coarse/enrichment/crack_length.hpp"
#include "coarse/enrichment/tip_enrichment.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/fracture/plastic_zone.hpp"
#include "coarse/load/load_history.hpp"
#include "coarse/load/rate_law.hpp"
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
constexpr double known_life = 0.03;       // too long by less is not worth a word

bool asks_for_opening_loads(const Case& input) { return input.growth || some_touch(input.cracks); }

bool leaves_functions_in_contact(const Scene& scene, std::size_t t) {
    const Tip& tip = scene.enriched.tips[t];
    return scene.input.growth && scene.materials.may_yield() && scene.enriched.tip_functions > 0 &&
           may_touch(scene.input.cracks[at(tip.crack)]);
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

/// Edge of the square at a tip, mm, and how often it ought to have been split and is not (levels_missing).
struct TipElement {
    double edge;
    int missing;
    [[nodiscard]] double as_asked() const { return std::ldexp(edge, -missing); }
};

/// Nothing where it is the case's own: elements as small as it asks for would do.
std::optional<std::string> zone_warning(std::size_t tip, const WantedZone& zone, const TipElement& at_tip, int refine) {
    const double element = at_tip.edge;
    if (zone.length <= 0.0 || zone.length >= zone.elements * element) return std::nullopt;
    const double finer = refine_for(zone.elements, zone.length, at_tip.as_asked(), refine);
    const std::string advice = finer > most_refined ? ", which no fine.refine gives: hardly anything yields"
                               : finer > refine     ? fmt::format(": fine.refine = {:g}", finer)
                                                    : "";
    return fmt::format("tip {}: its forward plastic zone at K_I = {:.4g} MPa sqrt(mm), about {:.3g} mm{}, spans {:.2g} "
                       "elements of {:.3g} mm; opening loads want {:g} or more{}",
                       tip, zone.K_I, zone.length, zone.place, zone.length / element, element, zone.elements, advice);
}

/// Openings nearer to the tip are those of its own element (docs/verification/closure.md, what opening loads are good
/// to).
std::optional<std::string> distance_warning(std::size_t tip, double distance, const TipElement& at_tip, int refine) {
    const double element = at_tip.edge;
    constexpr double with_room = 1.3;  // elements, for an advice of two digits
    if (distance <= 0.0 || distance >= (1.0 - rounding) * to_distance * element) return std::nullopt;
    const double finer = refine_for(to_distance, distance, at_tip.as_asked(), refine);
    const bool helps = finer > refine && finer <= most_refined;
    const std::string advice = helps ? fmt::format("fine.refine = {:g}, or ", finer) : "";
    return fmt::format("tip {}: closure is looked at {:.3g} mm behind it, {:.2g} elements of {:.3g} mm; nearer than "
                       "{:g} the opening range is a tenth or more too small and K_op some hundredths of K_max off: "
                       "{}closure.distance = {:.2g}",
                       tip, distance, distance / element, element, to_distance, advice, with_room * element);
}

/// The distance that nobody gives goes by the largest K of the history and stays. Where K falls the zone shrinks below
/// it, and faces beyond it part sooner: K_op / K_max falls, and nothing about the closure has changed.
std::optional<MeshDoubt> doubt_of_reach(const Case& input, std::size_t tip, double K_I, double distance,
                                        double yield_stress) {
    constexpr double too_far = 1.5;  // K has fallen to 0.82
    if (input.closure.distance || input.closure.definition == OpeningDefinition::Offset || K_I <= 0.0) return {};
    const double own = closure_distances(input.closure, {K_I}, {yield_stress}).front();
    if (distance < too_far * own) return {};
    return MeshDoubt{
        MeshDoubtKind::Reach,
        fmt::format("tip {}: K_I has fallen to {:.4g} MPa sqrt(mm), and closure is still looked at {:.3g} mm "
                    "behind it, {:.2g} times as far as the default is for that K, {:.2g} mm. That alone lowers "
                    "K_op / K_max, though closure stays what it is: compare at distances that shrink with the "
                    "zone, by closure.profile, or at closure.distance = {:.2g} from the start",
                    tip, K_I, distance, distance / own, own, own),
        1 + static_cast<int>(std::floor(std::log2(distance / (too_far * own))))};
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

/// Elements do not resolve how far the metal at a tip is stretched, so the faces behind it open less: K_op / K_max is
/// too high by up to two elements over the zone, and converges with the first power of their size. The range of K that
/// is left goes in by the exponent (docs/verification/closure.md, lives on elements half as large). `too_coarse`: for
/// opening loads; from such elements nothing can be extrapolated.
std::optional<std::string> life_in_stress_warning(const Scene& scene, std::size_t t, double zone,
                                                  const TipElement& at_tip, bool too_coarse) {
    if (scene.input.model.plane != PlaneState::Stress || !lives_by_closure(scene, t)) return std::nullopt;
    const GrowthSection& growth = *scene.input.growth;
    const bool is_measured = scene.input.closure.definition == OpeningDefinition::Contact;
    if (!grows_by_opening_loads(growth) || !is_measured || zone <= 0.0 || too_coarse) return std::nullopt;
    constexpr double largest_seen = 2.0;  // share of a life, per exponent and element over the zone
    const double too_long = largest_seen * exponent_of_K(growth) * at_tip.edge / zone;
    if (too_long < known_life) return std::nullopt;
    const int finer = 2 * scene.input.fine.refine;
    const std::string by = finer <= most_refined ? fmt::format(" (fine.refine = {})", finer) : "";
    return fmt::format(
        "tip {}: in plane stress opening loads fall with the size of elements, to the last. Where faces close the life "
        "on elements of {:.3g} mm, {:.2g} of the forward plastic zone, is too long by up to about {:.2g} %: a second "
        "run on elements half as large{} has half of that error, and twice its N less this one's a few percent: "
        "stria study tells both",
        t, at_tip.edge, at_tip.edge / zone, 100.0 * too_long, by);
}

std::vector<MeshDoubt> doubts_where_nothing_flows(const Scene& scene, std::size_t t) {
    if (!leaves_functions_in_contact(scene, t)) return {};
    const Tip& tip = scene.enriched.tips[t];
    const double small = choose_enrichment(scene.input).none_below * length_in_body(scene.enriched, tip.crack);
    const bool are_small = tip_element_edge(scene.enriched, tip) < small;  // another tip's are not
    return {{MeshDoubtKind::LeftFunctions, scene.input.growth->retain == Retain::All
                                               ? retained_warning(t)
                                               : linear_warning(t, are_small ? 0.0 : small)}};
}

}  // namespace

std::vector<MeshDoubt> doubts_of_openings(const Scene& scene, std::size_t t, double K_I, double distance, int missing) {
    const Case& input = scene.input;
    if (!asks_for_opening_loads(input)) return {};
    const double yield_stress = scene.yield_stress_at_tips()[t];
    if (!std::isfinite(yield_stress)) return doubts_where_nothing_flows(scene, t);
    const Tip& tip = scene.enriched.tips[t];
    const TipElement element{tip_element_edge(scene.enriched, tip), missing};
    const WantedZone zone = wanted_zone(input, K_I, yield_stress);
    std::vector<MeshDoubt> doubts;
    const auto add = [&](MeshDoubtKind kind, std::optional<std::string> warning, const char* more = "") {
        if (warning) doubts.push_back({kind, std::move(*warning) + more});
    };
    add(MeshDoubtKind::Zone, zone_warning(t, zone, element, input.fine.refine), of_its_life(scene, t));
    if (zone.length > 0.0)
        add(MeshDoubtKind::Distance, distance_warning(t, distance, element, input.fine.refine), of_its_life(scene, t));
    add(MeshDoubtKind::LifeInStress, life_in_stress_warning(scene, t, zone.length, element, !doubts.empty()));
    if (!input.growth) return doubts;
    if (may_touch(input.cracks[at(tip.crack)]))
        if (auto doubt = doubt_of_reach(input, t, K_I, distance, yield_stress)) doubts.push_back(std::move(*doubt));
    add(MeshDoubtKind::LifeInStrain, life_in_strain_warning(scene, t));
    if (input.growth->increment.is_auto()) return doubts;
    const double at_a_time = input.growth->increment.value();
    add(MeshDoubtKind::Growth, growth_warning(t, at_a_time, tip_element_along(scene.enriched, tip),
                                              cycle_count(input.load) / input.growth->every));
    if (input.model.plane == PlaneState::Stress)
        add(MeshDoubtKind::Step, step_warning(t, at_a_time, distance, zone.length));
    return doubts;
}

}  // namespace stria::coarse
