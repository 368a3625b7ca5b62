// What is said where something is refused.
#pragma once

#include <string>

#include "common/error.hpp"

namespace stria::test {

/// The text of the error that the work ends with; "accepted" where it ends with none.
template <class Error = CaseError> std::string refusal_of(auto&& work) {
    try {
        work();
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace stria::test
