// What a case would take of this machine's memory, before it is taken.
#pragma once

#include <string>

namespace stria {

/// Measured (docs/performance.md, what `stria check` says of a run): an element with its unknowns and their factor,
/// what an element of the zone takes besides, its operators and its share in the fronts, a point of it with its history
/// and gradients, a cycle with the turns of its load.
constexpr double bytes_of_element = 4000.0, bytes_of_zone_element = 15e3, bytes_of_point = 650.0,
                 bytes_of_cycle = 200.0;
/// Of the first, its share in the factor of the body, which growing cracks have twice: the next one is found while the
/// last is still asked.
constexpr double bytes_of_factor = 2400.0;
/// The program itself, and what of its freed memory it keeps (keep_freed_memory()).
constexpr double bytes_of_program = 40e6;

/// Bytes that this process may still take: what the machine has left, or less where a limit is set (ulimit -v).
double available_memory();

/// Throws CaseError, "<what> would take about 64 GB of memory, 23 GB are left", where they do not suffice.
void require_memory(const std::string& what, double bytes);

/// What is freed stays with this process, up to 64 MB: messages and matrices of some MB come and go in every iteration,
/// and the kernel would take their pages and clear them each time.
void keep_freed_memory();

}  // namespace stria
