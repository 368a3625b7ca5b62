// Every key explained.
#include "common/case/schema/case_file.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include "common/case/case_questions.hpp"
#include "common/error.hpp"
#include "common/memory.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/folders.hpp"

#include <fstream>
#include <sstream>

namespace stria::test {
namespace {

std::string text_of(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

TEST(CaseReference, ExplainsEveryKey) {
    EXPECT_NE(explain("material.yield_stress").find("MPa; > 0; default absent"), std::string::npos);
    EXPECT_NE(explain("crack.0.contact.friction").find("Coulomb"), std::string::npos);
    EXPECT_NE(explain("mesh.file").find("Gmsh"), std::string::npos);
    EXPECT_NE(explain("").find("output.format"), std::string::npos);
    EXPECT_THROW(static_cast<void>(explain("material.yung")), CaseError);
}

TEST(CaseReference, DocumentIsUpToDate) {
    const std::filesystem::path document = std::filesystem::path(test::source_folder) / "docs/case-reference.md";
    EXPECT_TRUE(case_reference_markdown() == text_of(document))
        << "write it anew: stria explain --markdown > docs/case-reference.md";
}

}  // namespace
}  // namespace stria::test
