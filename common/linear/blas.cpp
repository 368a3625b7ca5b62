#include "common/linear/blas.hpp"

#include <cstdlib>

#include <dlfcn.h>
#include <unistd.h>

namespace stria {
namespace {

constexpr const char* kernels_variable = "OPENBLAS_CORETYPE";

/// Null where no library of the program has it: not every BLAS is OpenBLAS.
template <class Function> Function* find(const char* symbol) {
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, symbol));
}

template <class... Arguments> void call_if_present(const char* symbol, Arguments... arguments) {
    if (auto* found = find<void(Arguments...)>(symbol)) found(arguments...);
}

}  // namespace

void use_one_thread() {
    // Both symbols are absent with the reference BLAS and without OpenMP: then there is nothing to stop.
    call_if_present("openblas_set_num_threads", 1);
    call_if_present("omp_set_max_active_levels", 0);
}

VectorInstructions vector_instructions() {
    VectorInstructions found;
#ifdef __x86_64__
    found.avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    found.avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512cd") &&
                   __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
                   __builtin_cpu_supports("avx512vl");
#endif
    return found;
}

std::string better_kernels(std::string_view has_chosen, const VectorInstructions& processor) {
    const bool knows_it = has_chosen != "Prescott" && has_chosen != "Barcelona";
    if (knows_it || !processor.avx2) return "";
    return processor.avx512 ? "SkylakeX" : "Haswell";
}

void begin_with_kernels_of_the_processor(char** arguments) {
    auto* const chosen = find<char*()>("openblas_get_corename");
    if (chosen == nullptr || std::getenv(kernels_variable) != nullptr) return;
    const std::string better = better_kernels(chosen(), vector_instructions());
    if (better.empty() || setenv(kernels_variable, better.c_str(), 1) != 0) return;
    execv("/proc/self/exe", arguments);  // where it fails the program goes on, slower
}

}  // namespace stria
