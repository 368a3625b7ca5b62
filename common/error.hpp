// How a run can fail: by the user's input, by the numbers, by a component that is lost, and by our own mistakes
// (assertions). What the disk refuses is a FileFailure (io/file_failure.hpp).
#pragma once

#include <stdexcept>
#include <string>

namespace stria {

/// The user's input is wrong (exit code 2). The text is one line: "file:line: key: what is wrong, what is allowed".
class CaseError : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The numbers failed (exit code 3 if nothing helps). A load step may be cut and tried again.
class NumericalFailure : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A component or the transport to it was lost (exit code 4).
class ComponentLost : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// Throws std::logic_error: a broken invariant of our own code.
inline void require(bool condition, const char* invariant) {
    if (!condition) throw std::logic_error(invariant);
}

}  // namespace stria
