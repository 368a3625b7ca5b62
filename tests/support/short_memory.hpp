// CHOLMOD and UMFPACK on a machine that has run out of memory.
#pragma once

#include <suitesparse/SuiteSparse_config.h>

#include <cstdlib>
#include <new>

namespace stria::test {

/// While it lives their first `granted` allocations succeed, and none after them. One at a time.
class ShortMemory {
public:
    explicit ShortMemory(int granted) : before_(SuiteSparse_config) {
        left() = granted;
        SuiteSparse_config.malloc_func = [](std::size_t size) { return takes() ? std::malloc(size) : nullptr; };
        SuiteSparse_config.calloc_func = [](std::size_t count, std::size_t size) {
            return takes() ? std::calloc(count, size) : nullptr;
        };
        SuiteSparse_config.realloc_func = [](void* old, std::size_t size) {
            return takes() ? std::realloc(old, size) : nullptr;
        };
    }
    ShortMemory(const ShortMemory&) = delete;
    ShortMemory& operator=(const ShortMemory&) = delete;
    ~ShortMemory() { SuiteSparse_config = before_; }

private:
    static int& left() {
        static int count = 0;
        return count;
    }
    static bool takes() { return --left() >= 0; }

    decltype(SuiteSparse_config) before_;
};

/// How many allocations the work cannot do without. With fewer it has to end with std::bad_alloc.
template <class Work> int allocations_of(const Work& work) {
    for (int granted = 0;; ++granted) {
        const ShortMemory memory(granted);
        try {
            work();
        } catch (const std::bad_alloc&) {
            continue;
        }
        return granted;
    }
}

}  // namespace stria::test
