// Axes, combinations and names of a study.
#include "app/study/variants/grid.hpp"

#include <gtest/gtest.h>

#include "common/error.hpp"

namespace stria::study {
namespace {

using Texts = std::vector<std::string>;

TEST(StudyGrid, SplitsAtCommasOutsideBracketsBracesAndQuotes) {
    EXPECT_EQ(split_list("1, 2,4"), (Texts{"1", "2", "4"}));
    EXPECT_EQ(split_list("[1,2],[3,[4,5]]"), (Texts{"[1,2]", "[3,[4,5]]"}));
    EXPECT_EQ(split_list("[{max=1,min=0}],none"), (Texts{"[{max=1,min=0}]", "none"}));
    EXPECT_EQ(split_list(R"("a,b",'c,d',"e\",f")"), (Texts{R"("a,b")", "'c,d'", R"("e\",f")"}));
    EXPECT_EQ(split_list("1,,2"), (Texts{"1", "", "2"}));
    EXPECT_EQ(split_list(""), Texts{""});
}

TEST(StudyGrid, AxisIsAKeyAndItsValues) {
    const Axis axis = parse_axis("fine.beta = 0.5,1, 2");
    EXPECT_EQ(axis.key, "fine.beta");
    EXPECT_EQ(axis.values, (Texts{"0.5", "1", "2"}));
}

TEST(StudyGrid, RefusesWhatIsNoAxis) {
    for (const char* text : {"", "fine.beta", "=1,2", "fine.beta=", "fine.beta=1,", "fine.beta=1,2,1"})
        EXPECT_THROW(parse_axis(text), CaseError) << text;
}

TEST(StudyGrid, RefusesAKeyThatIsThereTwice) {
    const Axis beta{"fine.beta", {"1", "2"}}, size{"mesh.size", {"5"}};
    EXPECT_NO_THROW(check_distinct({beta, size}, {"fine.guard=warn"}));
    EXPECT_THROW(check_distinct({beta, size, beta}, {}), CaseError);
    EXPECT_THROW(check_distinct({beta}, {"fine.beta = 4"}), CaseError);
}

TEST(StudyGrid, CombinesEveryValueWithEveryOtherTheLastAxisFastest) {
    const std::vector<Settings> all = combinations({{"a", {"1", "2"}}, {"b", {"x", "y", "z"}}});
    ASSERT_EQ(all.size(), 6);
    EXPECT_EQ(to_text(all.front()), "a=1, b=x");
    EXPECT_EQ(to_text(all[1]), "a=1, b=y");
    EXPECT_EQ(to_text(all.back()), "a=2, b=z");
}

TEST(StudyGrid, ReplacesSomeSettingsAndAddsTheOthers) {
    const Settings settings = {{"a", "1"}, {"b", "x"}};
    EXPECT_EQ(to_text(replaced(settings, {{"c", "8"}, {"a", "4"}})), "a=4, b=x, c=8");
    EXPECT_EQ(replaced(settings, {}), settings);
}

TEST(StudyGrid, ReadsSettings) {
    EXPECT_EQ(to_text(parse_settings("fine.beta=8,load.blocks=[{max=1,min=0}]", "--reference")),
              "fine.beta=8, load.blocks=[{max=1,min=0}]");
    for (const char* text : {"", "fine.beta", "fine.beta=", "a=1,a=2"})
        EXPECT_THROW(parse_settings(text, "--reference"), CaseError) << text;
}

TEST(StudyGrid, NamesFoldersSoThatNobodyMinds) {
    EXPECT_EQ(folder_name(3, 12, {{"fine.beta", "0.5"}, {"mesh.size", "2"}}), "03-fine.beta=0.5-mesh.size=2");
    EXPECT_EQ(folder_name(7, 120, {{"mode", "mpi"}}), "007-mode=mpi");
    const std::string name = folder_name(1, 2, {{"load.blocks", "[{cycles = 1, max=\"50/3\"}]"}});
    EXPECT_EQ(name.find_first_of("[]{}\"/ ,"), std::string::npos) << name;
    EXPECT_LE(folder_name(1, 2, {{"key", std::string(400, 'x')}}).size(), 255);
}

TEST(StudyGrid, TellsLongValuesApartByWhatDiffers) {
    using Words = std::vector<std::string>;
    EXPECT_EQ(differing_parts({"[{max=300.0,ratio=-1.0}]", "[{max=300.0,ratio=0.0}]"}), (Words{"-1.0", "0.0"}));
    EXPECT_EQ(differing_parts({"[[0,20],[6,20]]", "[[0,20],[86,20]]"}), (Words{"6", "86"}));
    EXPECT_EQ(differing_parts({"mpi", "monolithic"}), (Words{"mpi", "monolithic"}));
    EXPECT_EQ(differing_parts({"[1]", "[1]"}), (Words{"[1]", "[1]"}));
    EXPECT_EQ(differing_parts({"[]", "[1]"}), (Words{"[]", "[1]"}));
    EXPECT_EQ(differing_parts({"12", "120"}), (Words{"12", "120"}));
}

}  // namespace
}  // namespace stria::study
