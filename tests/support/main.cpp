// Runs the tests of a folder, with the kernels that the programs compute with.
#include <gtest/gtest.h>

#include "common/linear/blas.hpp"

int main(int argc, char** argv) {
    stria::begin_with_kernels_of_the_processor(argv);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
