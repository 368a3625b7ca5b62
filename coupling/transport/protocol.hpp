// The rules of the conversation: its version, the questions beyond messages.hpp, and what ends it.
#pragma once

#include <cstdint>
#include <string>

#include "coupling/messages.hpp"
#include "coupling/transport/transport.hpp"
#include "coupling/zone_snapshot.hpp"

namespace stria::coupling {

/// Grows with any change of messages.hpp or of the layouts in wire.cpp; Hello's own layout never changes.
inline constexpr std::uint32_t protocol_version = 43;

/// An exception on its way across: thrown again on the other side with the same type and text.
struct Failure {
    enum class Kind : std::uint32_t { Numerical = 1, Case = 2 };
    Kind kind = Kind::Numerical;
    std::string text;
};

/// Question of Tag::Restore.
struct Restore {
    Patch patch;
    ZoneSnapshot snapshot;
};

inline constexpr const char* different_cases =
    "the coarse and the fine component were given different cases, or the file changed in between";

/// Throws ComponentLost where the two sides speak different protocols, CaseError where they have read different cases.
void check_same(const Hello& own, const Hello& other);

/// Name of a tag, for error texts.
[[nodiscard]] const char* name(Tag tag);

/// Throws ComponentLost where another kind of message arrived than the conversation foresees.
void expect(Tag expected, Tag received);

}  // namespace stria::coupling
