// Messages as flat bytes: numbers as they stand in memory, lists after their length, each message field by field. Both
// components run on machines of one kind (little-endian, IEEE doubles), so doubles arrive with the bits they left with.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "coupling/messages.hpp"
#include "coupling/transport.hpp"
#include "coupling/zone_snapshot.hpp"

namespace stria::coupling {

/// Grows with any change of messages.hpp or of the layouts in wire.cpp; Hello's own layout never changes.
inline constexpr std::uint32_t protocol_version = 6;

/// An exception on its way across: thrown again on the other side with the same type and text.
struct Failure {
    enum class Kind : std::uint32_t { Numerical = 1, Case = 2 };
    Kind kind = Kind::Numerical;
    std::string text;
};

/// Question of Tag::Commit.
struct Commit {
    bool reversal = false;
};

/// Question of Tag::Restore.
struct Restore {
    Patch patch;
    ZoneSnapshot snapshot;
};

template <class M> [[nodiscard]] std::vector<std::byte> pack(const M& message);

/// Throws ComponentLost where the bytes are not exactly one `M`.
template <class M> [[nodiscard]] M unpack(std::span<const std::byte> bytes);

/// Throws ComponentLost where the two sides speak different protocols, CaseError where they have read different cases.
void check_same(const Hello& own, const Hello& other);

/// Name of a tag, for error texts.
[[nodiscard]] const char* name(Tag tag);

/// Throws ComponentLost where another kind of message arrived than the conversation foresees.
void expect(Tag expected, Tag received);

}  // namespace stria::coupling
