#include "common/linear/huge_pages.hpp"

#include <suitesparse/SuiteSparse_config.h>
#include <sys/mman.h>

#include <cstdlib>

namespace stria {
namespace {

constexpr std::size_t page = std::size_t{2} << 20U;
constexpr std::size_t large = 16 * page;  // smaller blocks stay with the process (keep_freed_memory())

void* allocate(std::size_t bytes) {
    if (bytes < large) return std::malloc(bytes);
    const std::size_t whole = (bytes + page - 1) / page * page;
    void* const block = std::aligned_alloc(page, whole);
    if (block != nullptr) madvise(block, whole, MADV_HUGEPAGE);  // where it is refused, pages are as small as they were
    return block;
}

}  // namespace

void use_huge_pages() { SuiteSparse_config.malloc_func = allocate; }

}  // namespace stria
