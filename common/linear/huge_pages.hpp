// Memory of CHOLMOD and UMFPACK.
#pragma once

namespace stria {

/// From now on their large blocks lie in pages of 2 MB, where the kernel has such (Linux, transparent huge pages). The
/// factor of a large body is one block of tens of MB that comes and goes with each step of growth; in pages of 4 kB the
/// kernel takes a third of the step to clear them one by one (docs/log/speed.md).
void use_huge_pages();

}  // namespace stria
