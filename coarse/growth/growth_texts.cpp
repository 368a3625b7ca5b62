#include "coarse/growth/growth_texts.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "coarse/enrichment/retained_functions.hpp"
#include "coarse/enrichment/tip_enrichment.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/fracture/turned_tip.hpp"
#include "coarse/model/crack_room.hpp"
#include "coarse/model/rings.hpp"

namespace stria::coarse {

std::optional<std::string> turns_sharply(std::size_t tip, double grows, double element) {
    const double elements = grows / element;
    if (elements >= elements_for_J) return std::nullopt;
    const std::string untold =
        elements < elements_behind_bend
            ? fmt::format("less than {:g} elements of {:.3g} mm: its K is not resolved until it is as far behind the "
                          "bend, and its J is not told until it is {:g} elements behind it",
                          elements_behind_bend, element, elements_for_J)
            : fmt::format("{:.2g} elements of {:.3g} mm: its J is not told until it is {:g} elements behind the bend",
                          elements, element, elements_for_J);
    return fmt::format("warning: tip {} turns sharply and grows by {:.3g} mm, {}; steps of {:.3g} mm or more, or "
                       "elements of {:.3g} mm or less, tell both",
                       tip, grows, untold, elements_for_J * element, grows / elements_for_J);
}

std::string turns_at_end_of_edge(double angle, bool sharp) {
    const std::string late =
        "a crack runs along an element edge, and turns at its end: the mesh does not hold it where it would leave that";
    if (!sharp) return late;
    return fmt::format("warning: {}. So it turns by {:.0f} degrees up to an element too late, which N tells; smaller "
                       "elements do so earlier, and a crack a little beside the line of nodes at once",
                       late, std::abs(angle) * 180.0 * std::numbers::inv_pi);
}

std::string functions_change(bool stand) {
    return fmt::format(
        "warning: from here on {} at the tips: {}all of their elements are smaller than 1/{:g} of "
        "their cracks (fine.enrichment = \"auto\"). Opening loads leap, by some hundredths of K_max in a "
        "trial; with fine.enrichment = \"none\" from the start they do not",
        stand ? "functions stand" : "no function stands", stand ? "not " : "", 1.0 / small_elements);
}

std::string functions_frozen(int tip) {
    return fmt::format(
        "tip {} has moved by less than {:g} elements: its functions are frozen there in spite of growth.retain = "
        "\"all\", for the equations would not tell them from those that follow. Where it does so again nothing is said",
        tip, apart_to_retain);
}

std::string breaks(int tip, double K, double K_I) {
    if (K == K_I) return fmt::format("tip {}: K = {:.6g} MPa sqrt(mm) (growth.toughness)", tip, K);
    return fmt::format(
        "tip {}: K = {:.6g} MPa sqrt(mm) behind the turn that K_II makes of it, K_I = {:.6g} before that "
        "(growth.toughness)",
        tip, K, K_I);
}

std::string rate_is_infinite(GrowthLaw law, std::ptrdiff_t tip) {
    const char* keys = law == GrowthLaw::Table ? "growth.ranges and growth.rates" : "growth.C and growth.m";
    return fmt::format("tip {}: {} make da/dN of what drives it larger than any number", tip, keys);
}

std::string why_no_longer(const CaseError& error) {
    const auto* at_boundary = dynamic_cast<const TipAtBoundary*>(&error);
    return at_boundary != nullptr ? at_boundary->met : error.what();
}

std::string growth_ends(const std::string& why, bool by_the_mesh) {
    return fmt::format("{}: {}", by_the_mesh ? "warning: growth ends here, and not the life" : "growth ends here", why);
}

std::string is_arrested(bool by_last_cycle, const std::optional<TurnOfTip>& untold) {
    const std::string arrested =
        fmt::format("warning: nothing drives a tip any more: the crack is arrested{}",
                    by_last_cycle ? ", by the last cycle of a load that varies (growth.every = 1)" : "");
    if (!untold) return arrested;
    return fmt::format(
        "{}. But K_II turns tip {} by {:.0f} degrees, and what drives it behind that turn is not known here: "
        "a crack that begins with a kink of two elements in that direction tells",
        arrested, untold->tip, untold->angle * 180.0 * std::numbers::inv_pi);
}

}  // namespace stria::coarse
