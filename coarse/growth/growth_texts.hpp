// Sentences of a run about its growth.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "common/case/case.hpp"
#include "common/error.hpp"

namespace stria::coarse {

/// A tip that `grows` by so much behind a sharp turn, less than elements_for_J of this edge, mm: what of it is not told
/// there. Nothing where all is.
[[nodiscard]] std::optional<std::string> turns_sharply(std::size_t tip, double grows, double element);

/// A crack wants to turn by `angle`, radians, within an element edge along which it runs.
[[nodiscard]] std::string turns_at_end_of_edge(double angle, bool sharp);

/// With fine.enrichment = "auto" cracks become so long that elements at their tips are small beside them.
/// `stand`: functions do at the tips from there on, or do no longer.
[[nodiscard]] std::string functions_change(bool stand);

/// With growth.retain = "all" a tip has moved by less than apart_to_retain elements.
[[nodiscard]] std::string functions_frozen(int tip);

/// A tip has reached the toughness, MPa sqrt(mm): by its K_I, or by what that is behind a turn.
[[nodiscard]] std::string breaks(int tip, double K, double K_I);

/// By the law a tip grows at a rate that is no number any more, for a power of that size has none.
[[nodiscard]] std::string rate_is_infinite(GrowthLaw law, std::ptrdiff_t tip);

/// Why a crack cannot be as long as it would be next.
[[nodiscard]] std::string why_no_longer(const CaseError& error);

/// The next growth is refused, and `why`. `by_the_mesh`: the body would hold it, so the life goes on.
[[nodiscard]] std::string growth_ends(const std::string& why, bool by_the_mesh);

/// By which a tip would turn as it grows, radians.
struct TurnOfTip {
    std::size_t tip;
    double angle;
};
/// No tip is driven: `by_last_cycle` of a load that varies, of which others may drive one. `untold`: what drives a tip
/// behind this turn is not known.
[[nodiscard]] std::string is_arrested(bool by_last_cycle, const std::optional<TurnOfTip>& untold);

}  // namespace stria::coarse
