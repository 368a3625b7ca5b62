// Load spectra from CSV files.
#pragma once

#include <filesystem>
#include <vector>

#include "common/case/case.hpp"

namespace stria {

struct Spectrum {
    std::vector<LoadBlock> blocks;              // in the order of the file
    std::vector<std::vector<CaseBlock>> cases;  // per load case, one block for each of `blocks`
};

/// Columns `max`, `min` and, if wanted, `cycles`; or `turning_point`: values between two turns are passed over, a cycle
/// is a maximum and the minimum after it, and what comes before the first maximum or after the last minimum is left
/// out, unless the sequence `repeats`, when it follows on its own end. Beside it stands a column for each of `cases`:
/// its factors in the same lines; where turning_point does not turn they must lie on the straight line. Throws
/// CaseError: what is wrong, and in which line.
Spectrum read_spectrum(const std::filesystem::path& path, const std::vector<std::string>& cases = {},
                       bool repeats = false);

/// Reads load.spectrum of a case file in `folder`: its cycles follow the blocks. Load cases without a history of their
/// own are columns of it.
void take_spectrum(Case& whole, const std::filesystem::path& folder);

}  // namespace stria
