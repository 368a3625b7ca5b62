#include "common/linear/blas.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "common/linear/sparse_lu.hpp"

namespace stria {
namespace {

TEST(Blas, OneThreadMayBeAskedForMoreThanOnce) {
    use_one_thread();
    use_one_thread();
    SparseMatrix a(10, 10);
    a.setIdentity();
    EXPECT_TRUE(SparseLu(a).solve(Eigen::VectorXd::Ones(10)).allFinite());
}

TEST(Blas, AYoungProcessorIsNoPrescott) {
    EXPECT_EQ(better_kernels("Prescott", {.avx2 = true, .avx512 = true}), "SkylakeX");
    EXPECT_EQ(better_kernels("Prescott", {.avx2 = true, .avx512 = false}), "Haswell");
    EXPECT_EQ(better_kernels("Barcelona", {.avx2 = true, .avx512 = false}), "Haswell");
    EXPECT_EQ(better_kernels("Prescott", {}), "");
    EXPECT_EQ(better_kernels("Prescott", {.avx2 = false, .avx512 = true}), "")
        << "SkylakeX multiplies and adds at once";
}

TEST(Blas, WhatOpenBlasKnowsStays) {
    for (const char* known : {"Haswell", "Zen", "SkylakeX", "Cooperlake", "Nehalem", "armv8"})
        EXPECT_EQ(better_kernels(known, {.avx2 = true, .avx512 = true}), "") << known;
}

}  // namespace
}  // namespace stria
