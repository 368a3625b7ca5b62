#include "common/memory.hpp"

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <limits>

#include "common/error.hpp"

namespace stria {
namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();

/// Of /proc/meminfo.
double left_in_machine() {
    std::ifstream file("/proc/meminfo");
    std::string name, unit;
    for (double kilobytes = 0.0; file >> name >> kilobytes; std::getline(file, unit))
        if (name == "MemAvailable:") return 1024.0 * kilobytes;
    return unknown;
}

double left_below_limit() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return unknown;
    double pages = 0.0;
    std::ifstream("/proc/self/statm") >> pages;
    return std::max(0.0, static_cast<double>(limit.rlim_cur) - pages * static_cast<double>(sysconf(_SC_PAGESIZE)));
}

}  // namespace

double available_memory() { return std::min(left_in_machine(), left_below_limit()); }

void require_memory(const std::string& what, double bytes) {
    const double left = available_memory();
    if (bytes <= left) return;
    throw CaseError(
        fmt::format("{} would take about {:.3g} GB of memory, {:.3g} GB are left", what, bytes / 1e9, left / 1e9));
}

void keep_freed_memory() {
    constexpr int megabyte = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, 32 * megabyte);  // the largest that there is
    mallopt(M_TRIM_THRESHOLD, 64 * megabyte);
    mallopt(M_TOP_PAD, 4 * megabyte);
}

}  // namespace stria
