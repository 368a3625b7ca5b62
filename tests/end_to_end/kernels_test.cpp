// Which kernels of OpenBLAS our programs compute with, as it says itself at its start.
#include <cstdlib>

#include <gtest/gtest.h>

#include "common/linear/blas.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_folder.hpp"

namespace stria::test {
namespace {

/// By its last word: a program that began once more has said it twice. Empty with another BLAS.
std::string kernels_of(const std::string& program, const std::string& environment) {
    const TemporaryFolder folder;
    const std::string log = folder / "log", first = "Core: ";
    run_program("sh", {"-c", environment + " OPENBLAS_VERBOSE=2 exec \"$0\" --version", own_program(program)}, log);
    const std::string said = text_of(log);
    const std::size_t at = said.rfind(first);
    if (at == std::string::npos) return "";
    return said.substr(at + first.size(), said.find('\n', at) - at - first.size());
}

TEST(Kernels, AreThoseOfTheProcessor) {
    for (const char* program : {"stria", "stria-coarse", "stria-fine"}) {
        const std::string kernels = kernels_of(program, "unset OPENBLAS_CORETYPE;");
        EXPECT_EQ(better_kernels(kernels, vector_instructions()), "") << program << " computes with " << kernels;
    }
}

TEST(Kernels, AreThoseThatTheUserSets) {
    if (kernels_of("stria", "").empty()) GTEST_SKIP() << "another BLAS";
    EXPECT_EQ(kernels_of("stria", "OPENBLAS_CORETYPE=Prescott"), "Prescott");
}

}  // namespace
}  // namespace stria::test
