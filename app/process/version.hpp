// The version of this build.
#pragma once

#include <string>

namespace stria {

std::string version_text();  // "stria 0.1.0 (1a2b3c4)", with the commit where it is known

}  // namespace stria
