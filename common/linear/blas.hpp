// The BLAS library that Eigen, CHOLMOD and UMFPACK compute with: its threads, and its kernels for this processor.
#pragma once

#include <string>
#include <string_view>

namespace stria {

/// BLAS and OpenMP take one thread per process, whatever environment it was started with: MPI ranks and an in-process
/// component must not fight for the same cores, and small matrices gain nothing from threads.
void use_one_thread();

/// What a processor can compute with beside the two doubles of every x86-64.
struct VectorInstructions {
    bool avx2 = false;    // four doubles, with fused multiply-add
    bool avx512 = false;  // eight doubles, as Skylake-X has them
};
[[nodiscard]] VectorInstructions vector_instructions();

/// Kernels of OpenBLAS, by its own names (OPENBLAS_CORETYPE), that a processor should have instead of those that it
/// `has_chosen`; empty: they are right. OpenBLAS goes by the model of a processor. Of one that is younger than itself
/// it takes what those of 2004 and 2007 had, Prescott of Intel's and Barcelona of AMD's: Debian 12's 0.3.21 does not
/// know Emerald Rapids (docs/benchmarks.md).
[[nodiscard]] std::string better_kernels(std::string_view has_chosen, const VectorInstructions& processor);

/// Where OpenBLAS does not know the processor the program begins once more, with OPENBLAS_CORETYPE set: the choice is
/// made as the library is loaded. What the user has set stays. Does nothing with another BLAS. `arguments`: those of
/// main().
void begin_with_kernels_of_the_processor(char** arguments);

}  // namespace stria
