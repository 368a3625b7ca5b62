// A zone's snapshot as the groups of a file (common/io/archive.hpp): its lists of small things are kept in the bytes of
// the wire.
#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "coupling/transport/message_members.hpp"
#include "coupling/transport/wire.hpp"

namespace stria::coupling {

template <class T>
concept Small =
    std::is_same_v<T, MultiplierSnapshot> || std::is_same_v<T, FrozenTip> || std::is_same_v<T, NearestContact>;

template <Small T> std::vector<std::byte> bytes_of(const std::vector<T>& list) { return pack(list); }

template <Small T> void from_bytes(std::span<const std::byte> bytes, std::vector<T>& list) {
    list = unpack<std::vector<T>>(bytes);
}

}  // namespace stria::coupling
