// What the language of the case file has and this version has not, in one place.
#pragma once

#include <vector>

#include "common/schema/known_keys.hpp"

namespace stria {

/// A line goes when the thing is built.
const std::vector<schema::NotYet>& not_in_this_version();

}  // namespace stria
