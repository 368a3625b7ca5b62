// Load spectra from CSV files.
#pragma once

#include <filesystem>
#include <vector>

#include "common/case/case.hpp"

namespace stria {

/// Blocks in the order of the file. Columns `max`, `min` and, if wanted, `cycles`; or one column `turning_point`:
/// values between two turns are passed over, a cycle is a maximum and the minimum after it, and what comes before the
/// first maximum or after the last minimum is left out. Throws CaseError: what is wrong, and in which line.
std::vector<LoadBlock> read_spectrum(const std::filesystem::path& path);

}  // namespace stria
