// The zone, enrichment and what is measured.
#include "common/case/schema/case_file.hpp"

#include <gtest/gtest.h>

#include <sys/stat.h>

#include "common/case/case_questions.hpp"
#include "common/error.hpp"
#include "common/memory.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/folders.hpp"

namespace stria::test {
namespace {

TEST_F(CaseFile, AnOpeningRangeIsReadSomewhere) {
    const std::string grows = std::string(complete) + "[growth]\nlaw = \"ctod\"\nincrement = 0.1\nC = 1.0\nm = 2.0\n";
    EXPECT_EQ(complaint(grows),
              "case.toml:27: growth.law = \"ctod\" needs closure.distance: how far behind the tip the "
              "opening is read");
    EXPECT_EQ(read(grows + "[closure]\ndistance = 0.2\n").closure.distance, 0.2);
}

TEST_F(CaseFile, AComplianceNeedsIncrementsOfANumber) {
    const std::string offset = std::string(complete) + "[closure]\ndefinition = \"offset\"\n";
    EXPECT_NE(complaint(offset, {"load.steps=\"auto\""}).find("closure.definition = \"offset\" needs load.steps, "),
              std::string::npos);
    EXPECT_EQ(read(offset, {"load.steps=40"}).closure.definition, OpeningDefinition::Offset);
}

TEST_F(CaseFile, RefinementNeedsARadiusWhereNothingYields) {
    const std::string plastic = "yield_stress = 300.0\n";
    std::string elastic = complete;
    elastic.erase(elastic.find(plastic), plastic.size());
    EXPECT_NE(complaint(elastic, {"fine.refine=8"}).find("fine.refine = 8 needs fine.radius"), std::string::npos);
    const auto accepted = [&](const std::string& text, const std::vector<std::string>& settings) {
        return complaint(text, settings).find("fine.refine") == std::string::npos;
    };
    EXPECT_TRUE(accepted(elastic, {"fine.refine=8", "fine.radius=2.0"}));
    EXPECT_TRUE(accepted(complete, {"fine.refine=8"}));
    EXPECT_FALSE(accepted(complete, {"fine.refine=3"}));
}

TEST_F(CaseFile, GeometricalEnrichmentIsForElasticTractionFreeScenes) {
    EXPECT_NE(
        complaint(complete + "[fine]\nenrichment = \"geometrical\"\n").find("fine.enrichment = \"geometrical\" is for"),
        std::string::npos);
    EXPECT_NE(
        complaint(complete + "[fine]\nenrichment = \"single\"\nenrichment_radius = 1.0\n").find("needs enrichment"),
        std::string::npos);
}

}  // namespace
}  // namespace stria::test
