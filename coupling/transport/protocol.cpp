#include "coupling/transport/protocol.hpp"

#include <fmt/format.h>

#include "common/error.hpp"

namespace stria::coupling {

void check_same(const Hello& own, const Hello& other) {
    if (own.protocol != other.protocol)
        throw ComponentLost(
            fmt::format("the components are of different versions: protocols {} and {}", own.protocol, other.protocol));
    if (own.case_digest != other.case_digest) throw CaseError(different_cases);
}

const char* name(Tag tag) {
    switch (tag) {
    case Tag::Hello:
        return "Hello";
    case Tag::Patch:
        return "Patch";
    case Tag::Displacement:
        return "Displacement";
    case Tag::Response:
        return "Response";
    case Tag::Commit:
        return "Commit";
    case Tag::Report:
        return "Report";
    case Tag::Rollback:
        return "Rollback";
    case Tag::State:
        return "State";
    case Tag::Failure:
        return "Failure";
    case Tag::Stop:
        return "Stop";
    case Tag::Done:
        return "Done";
    case Tag::Snapshot:
        return "Snapshot";
    case Tag::Restore:
        return "Restore";
    case Tag::Keep:
        return "Keep";
    case Tag::Kept:
        return "Kept";
    case Tag::Increments:
        return "Increments";
    }
    return "a message of an unknown kind";
}

void expect(Tag expected, Tag received) {
    if (expected != received)
        throw ComponentLost(
            fmt::format("the components lost step: {} expected, {} received", name(expected), name(received)));
}

}  // namespace stria::coupling
