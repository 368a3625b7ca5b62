// Files that know whether they are still what was written.
#pragma once

#include <filesystem>
#include <string_view>

namespace stria {

/// A content of HDF5 behind a block of 512 bytes with its checksum. To HDF5 the block is a user block: every reader of
/// the format passes over it. `earlier`: where to keep the file that was there. Throws FileFailure.
void write_sealed(const std::filesystem::path& path, std::string_view content, const std::filesystem::path& earlier);

/// Throws FileFailure where the file cannot be read, or a bit is not as it was written.
void check_seal(const std::filesystem::path& path);

}  // namespace stria
