// Messages as flat bytes: numbers as they stand in memory, lists after their length, each message field by field. Both
// components run on machines of one kind (little-endian, IEEE doubles), so doubles arrive with the bits they left with.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "coupling/transport/protocol.hpp"

namespace stria::coupling {

template <class M> [[nodiscard]] std::vector<std::byte> pack(const M& message);

/// Throws ComponentLost where the bytes are not exactly one `M`.
template <class M> [[nodiscard]] M unpack(std::span<const std::byte> bytes);

}  // namespace stria::coupling
