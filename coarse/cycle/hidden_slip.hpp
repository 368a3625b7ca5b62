// Slip that neither of two states shows: of a contact that slides and then parts, or sticks, on the way between them.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "coarse/cycle/signal_crossing.hpp"

namespace stria::coarse {

/// A contact that slides at neither of two states may on the way between them: it is not the same one, or others have
/// parted, met, begun to slide or stuck (their numbers tell), and the way of its tractions has a bend.
[[nodiscard]] bool may_hide_slip(const coupling::NearestContact& before, const coupling::NearestContact& after);

/// Contact `k` of ClosureStation::nearest has slid neither at station i of a way nor at i + 1: where between them it is
/// to be looked for, or, where that is known to `precision`, of a target, where it slides. Null: nothing slides.
[[nodiscard]] std::optional<Crossing> hidden_slip(const std::vector<ClosureStation>& way, std::size_t i, std::size_t k,
                                                  double precision);

}  // namespace stria::coarse
