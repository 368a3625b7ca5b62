// The folder that results go to.
#pragma once

#include <filesystem>

namespace stria {

/// Makes it, and those above it, where there is none. Throws FileFailure, with the reason, where that cannot be done or
/// nothing can be written there.
void make_writable_folder(const std::filesystem::path& folder);

}  // namespace stria
