// What a benchmark is asked to measure.
#pragma once

#include <cstdlib>
#include <vector>

namespace stria {

/// The numbers on the command line from argument `first` on, or `standard` where there are none.
inline std::vector<int> sizes_from(int argc, const char* const* argv, int first, std::vector<int> standard) {
    std::vector<int> sizes;
    for (int k = first; k < argc; ++k) sizes.push_back(std::atoi(argv[k]));
    return sizes.empty() ? standard : sizes;
}

}  // namespace stria
