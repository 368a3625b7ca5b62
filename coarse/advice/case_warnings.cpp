#include "coarse/advice/case_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "coarse/advice/growth_adequacy.hpp"
#include "coarse/advice/material_adequacy.hpp"
#include "coarse/advice/mesh_adequacy.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/fracture/K_behind_turns.hpp"
#include "coarse/fracture/plastic_zone.hpp"
#include "coarse/load/case_histories.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "coarse/load/increment_schedule.hpp"
#include "common/case/case_questions.hpp"
#include "common/crack/notch.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

std::vector<std::string> thickness_warnings(const Case& input) {
    const double t = input.model.thickness;
    if (t == 1.0) return {};
    return {fmt::format("model.thickness = {:g}: loads and results are per mm of thickness all the same. A force of F "
                        "on the whole body is F / {:g} here",
                        t, t)};
}

/// How far off one increment and two between reversals are: docs/verification/increments.md.
std::vector<std::string> steps_warnings(const Case& input) {
    constexpr int enough = 8;
    if (!may_yield(input) || input.load.steps.is_auto() || input.load.steps.value() >= enough) return {};
    return {fmt::format("load.steps = {}: metal that flows is taken from one reversal to the next in {}; with one the "
                        "opening range was 2 to 5 % too large and K_op up to 0.02 of K_max too low, with two 1 % and "
                        "0.01: {} or more, or \"auto\"",
                        input.load.steps.value(),
                        input.load.steps.value() == 2 ? "one increment"
                                                      : fmt::format("{} increments", input.load.steps.value() / 2),
                        enough)};
}

/// Behind a tip, mm along its faces.
struct FacesBehind {
    double own;           // up to where the crack ends; to its middle where its other end is a tip
    double begins, ends;  // a notch does there, no farther than that
    [[nodiscard]] double that_touch() const { return ends < own ? own : begins; }
};

FacesBehind faces_behind(const Scene& scene, const Tip& tip) {
    const CrackSection& crack = scene.input.cracks[at(tip.crack)];
    const auto of_crack = [&](const Tip& other) { return other.crack == tip.crack; };
    const double length = length_of(crack.points),
                 own = length / static_cast<double>(std::ranges::count_if(scene.enriched.tips, of_crack));
    if (crack.notch == 0.0) return {own, own, own};
    const Notch notch = notch_of(crack, crack.grown_at_start);
    const auto behind = [&](double s) { return std::clamp(tip.upper > 0 ? length - s : s, 0.0, own); };
    const auto [begins, ends] = std::minmax({behind(notch.from), behind(notch.to)});
    return {own, begins, ends};
}

/// Beyond them nothing touches.
std::vector<std::string> closure_warnings(const Scene& scene, const std::vector<double>& distance) {
    std::vector<std::string> all;
    const std::vector<Tip>& tips = scene.enriched.tips;
    for (std::size_t t = 0; t < tips.size(); ++t) {
        const double own = faces_behind(scene, tips[t]).that_touch();
        if (may_touch(scene.input.cracks[at(tips[t].crack)]) && distance[t] >= own)
            all.push_back(fmt::format(
                "tip {}: closure is looked at {:.3g} mm behind it, and its faces that may touch end after {:.3g} mm: "
                "nothing touches there, and it counts as open all the cycle{} (closure.distance)",
                t, distance[t], own,
                scene.input.growth ? fmt::format(" until it has grown by {:.3g} mm", distance[t] - own) : ""));
    }
    return all;
}

/// The distance that nobody gives goes by the largest K, though it be that of one overload: the cycles before it have
/// another K_op than in a run without it. Where nothing yields at the tip it is zero by either K: there is none to
/// give.
std::vector<std::string> overload_warnings(const Scene& scene, const std::vector<double>& largest,
                                           const std::vector<double>& usual, const std::vector<double>& distance) {
    constexpr double much_smaller = 0.9;
    if (scene.input.closure.distance) return {};
    const std::vector<double> without = closure_distances(scene.input.closure, usual, scene.yield_stress_at_tips());
    std::vector<std::string> all;
    const std::vector<Tip>& tips = scene.enriched.tips;
    for (std::size_t t = 0; t < tips.size(); ++t)
        if (may_touch(scene.input.cracks[at(tips[t].crack)]) && usual[t] > 0.0 &&
            usual[t] < much_smaller * largest[t] && distance[t] > 0.0)
            all.push_back(fmt::format(
                "tip {}: closure is looked at {:.3g} mm behind it, which goes by the largest K of the history, {:.4g} "
                "MPa sqrt(mm); by the usual {:.4g} it would be {:.2g} mm, and K_op is higher nearer to the tip: "
                "closure.distance = {:.2g} compares with a run without the larger loads",
                t, distance[t], largest[t], usual[t], without[t], without[t]));
    return all;
}

/// Part of the way up from which on no increment is longer than one of E647's segments: below it no compliance is told.
double told_from(const LoadSection& load) {
    constexpr double segment = 0.1 * (1.0 + 1e-9);
    const std::vector<double> ways = graded_ways(load.steps.value() / 2, load.power());
    std::size_t k = ways.size() - 1;
    while (k > 0 && ways[k] - ways[k - 1] <= segment) --k;
    return ways[k];
}

/// The compliance offset is read at a mouth, in segments of a tenth of the load range.
std::vector<std::string> offset_warnings(const Scene& scene) {
    const LoadSection& load = scene.input.load;
    if (scene.input.closure.definition != OpeningDefinition::Offset) return {};
    std::vector<std::string> all;
    const std::vector<Tip>& tips = scene.enriched.tips;
    for (std::size_t t = 0; t < tips.size(); ++t)
        if (std::ranges::count_if(tips, [&](const Tip& tip) { return tip.crack == tips[t].crack; }) > 1)
            all.push_back(fmt::format("tip {}: its crack has two tips and no mouth at which a compliance is read: no "
                                      "K_op by closure.definition = \"offset\"; \"contact\" and \"tension\" tell one",
                                      t));
    const double from = load.steps.is_auto() ? 0.0 : told_from(load);
    if (from > 0.0)
        all.push_back(
            fmt::format("closure.definition = \"offset\" takes segments of a tenth of the load range, and some of the "
                        "increments are longer: no K_op is told{}; load.steps = 40 with load.grading = 1 tells it",
                        from < 1.0 ? fmt::format(" of a crack that opens below {:.2g} of the way up", from) : ""));
    return all;
}

constexpr double elements_before_notch = 1.75;

/// What pressed faces between a tip and a notch are too short for.
std::string pressed_before_notch(std::size_t t, double to_notch, double element, double K_I) {
    return fmt::format(
        "tip {}: only {:.3g} mm of faces that may touch, {:.2g} elements of {:.3g} mm, lie between it and the notch, "
        "and the load presses them with a nominal K_I of {:.4g} MPa sqrt(mm); on fewer than {:g} they press too hard, "
        "six "
        "times so on a thirtieth, and K_I under pressure, which is nothing there, is off by 0.4 of the nominal one on "
        "one element, by 0.9 on a quarter, by 3 to 7 times that on a thirtieth, J by 0.1 to 0.4 of the nominal one",
        t, to_notch, to_notch / element, element, K_I, elements_before_notch);
}

/// The same of the faces that a tip leaves which starts at the notch's end.
std::string pressed_from_notch(std::size_t t, double element, double K_I) {
    return fmt::format(
        "tip {}: it starts where its notch ends, and the load presses the faces that it leaves between it and the "
        "notch with a nominal K_I of {:.4g} MPa sqrt(mm); on fewer than {:g} elements of {:.3g} mm they press too "
        "hard, and "
        "K_I and J under pressure, which are nothing there, were 0.4 to 0.7 and 0.4 to 0.9 of the nominal ones one "
        "element from the notch",
        t, K_I, elements_before_notch, element);
}

/// Between a tip and a notch pressed faces are as if they were whole, and the pressure is singular at the notch: mean 2
/// K / sqrt(2 pi d) over d, and no K_I at the tip. On fewer elements there is one multiplier, or none but the tip's
/// (docs/verification/contact.md, K of a closed tip).
std::vector<std::string> pressed_faces_warnings(const Scene& scene, const UnitResponse& nominal) {
    constexpr double rounding = 1e-6;  // of an element
    std::vector<std::string> all;
    const std::vector<double> least = least_K_I(scene.input, nominal);
    const bool grows = scene.input.growth.has_value();
    for (std::size_t t = 0; t < scene.enriched.tips.size(); ++t) {
        const Tip& tip = scene.enriched.tips[t];
        const CrackSection& crack = scene.input.cracks[at(tip.crack)];
        const double element = tip_element_edge(scene.enriched, tip), to_notch = faces_behind(scene, tip).begins;
        const double lacks = elements_before_notch * element - to_notch;
        const bool has_faces = to_notch > rounding * element;
        if (!may_touch(crack) || crack.notch == 0.0 || lacks <= 0.0 || least[t] >= 0.0) continue;
        if (!has_faces && !grows) continue;
        const bool shorter_helps = tip.upper > 0 && crack.notch > lacks;
        const std::string until = grows ? fmt::format(", until it has grown by {:.3g} mm", lacks) : "",
                          notch = fmt::format("crack.{}.notch = {:.5g}", tip.crack, crack.notch - lacks);
        if (has_faces)
            all.push_back(pressed_before_notch(t, to_notch, element, least[t]) + until +
                          fmt::format(": elements of {:.2g} mm there", to_notch / elements_before_notch) +
                          (shorter_helps ? ", or " + notch : ""));
        else
            all.push_back(pressed_from_notch(t, element, least[t]) + until + (shorter_helps ? ": " + notch : ""));
    }
    return all;
}

}  // namespace

std::vector<std::string> case_warnings(const Scene& scene, const UnitResponse& nominal) {
    const std::vector<double> opening = largest_K_I(scene.input, nominal),
                              turned = largest_K_behind_turns(scene.input, nominal),
                              usual = common_K_behind_turns(scene.input, nominal),
                              largest = K_of_closure(scene.input, nominal),
                              distance = closure_distances(scene.input.closure, largest, scene.yield_stress_at_tips());
    std::vector<std::string> all = material_warnings(scene.input);
    const auto add = [&](std::vector<std::string> more) { std::ranges::move(more, std::back_inserter(all)); };
    add(thickness_warnings(scene.input));
    add(steps_warnings(scene.input));
    add(units_of_K_warnings(scene.input));
    add(rate_warnings(scene.input, usual, turned));
    add(early_break_warnings(scene.input, opening, turned));
    add(travel_warnings(scene.input));
    add(growth_warnings(scene.input));
    add(closure_warnings(scene, distance));
    add(overload_warnings(scene, largest, usual, distance));
    add(offset_warnings(scene));
    add(pressed_faces_warnings(scene, nominal));
    add(mesh_warnings(scene, usual, distance));
    return all;
}

}  // namespace stria::coarse
