// Ids and counts are int; containers count in std::size_t. The one place that goes from the former to the latter.
#pragma once

#include <concepts>
#include <cstddef>

namespace stria {

/// Place of an id in a container; also a count as a container's size. Never negative.
constexpr std::size_t at(std::integral auto index) { return static_cast<std::size_t>(index); }

}  // namespace stria
