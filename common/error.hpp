// The three ways a run can fail: the user's input, the numbers, and our own mistakes (assertions).
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
