// From which checkpoints a run may go on: what of the case may differ, and how a difference is named.
#include "coarse/results/case_mark.hpp"

#include <gtest/gtest.h>

#include "coarse/results/checkpoint.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/error.hpp"
#include "tests/support/load_cases.hpp"
#include "tests/support/refusal.hpp"
#include "tests/support/sent_analysis.hpp"

namespace stria::coarse {
namespace {

using test::refusal_of;

class SameCase : public testing::Test {
protected:
    static CaseMark mark(std::vector<std::string> settings = {}) {
        settings.insert(settings.begin(),
                        {"mesh.size=10.0", "mesh.grading=[]", "load.blocks=[{cycles=2, max=50.0, ratio=-1.0}]"});
        return mark_of(refined_scene(test::sent_case(settings)));
    }
    static std::string against(std::vector<std::string> settings) {
        Checkpoint checkpoint;
        checkpoint.mark = mark();
        checkpoint.analysis.load.leg = 3;  // down, in the second cycle
        return refusal_of(
            [&] { check_same_case(checkpoint.mark, mark(std::move(settings)), checkpoint.analysis.load); });
    }
    static constexpr const char* fine = "accepted";
};

TEST_F(SameCase, MayBeWrittenOtherwiseAndSolvedMoreTightly) {
    EXPECT_EQ(against({}), fine);
    EXPECT_EQ(against({"output.faces=all", "solver.tolerance=1e-10", "title=other", "coupling.state=increment"}), fine);
}

TEST_F(SameCase, MayHaveAnotherFuture) {
    EXPECT_EQ(against({"load.blocks=[{cycles=3, max=50.0, ratio=-1.0}]"}), fine);
    EXPECT_EQ(against({"load.blocks=[{cycles=2, max=50.0, ratio=-1.0}, {cycles=1, max=20.0, ratio=0.0}]"}), fine);
    EXPECT_EQ(against({"load.repeat=3"}), fine);
}

TEST_F(SameCase, IsNamedWhereItDiffers) {
    EXPECT_NE(against({"fine.beta=3.0"}).find("[fine] \"beta = 3"), std::string::npos) << against({"fine.beta=3.0"});
    EXPECT_NE(against({"mesh.size=8.0"}).find("[mesh] \"size = 8"), std::string::npos);
    EXPECT_NE(against({"growth.increment=0.1"}).find("growth"), std::string::npos);
    EXPECT_NE(against({"load.blocks=[{cycles=1, max=50.0, ratio=-1.0}]"}).find("in cycle 2"), std::string::npos);
    EXPECT_NE(against({"load.blocks=[{cycles=2, max=51.0, ratio=-1.0}]"}).find("in cycle 0"), std::string::npos);
    EXPECT_NE(against({"load.scale=2.0"}).find("in cycle 0"), std::string::npos);
}

// A run that is done is made longer by an overload: its last cycle would end at that, and nothing said why it is
// another.
TEST_F(SameCase, SaysWhereItsLastCycleEnds) {
    const auto longer = [](const std::string& blocks) {
        LoadPosition done;
        done.leg = 4;  // at the end of the second cycle
        return refusal_of([&] { check_same_case(mark(), mark({"load.blocks=[" + blocks + "]"}), done); });
    };
    const std::string same = "{cycles=2, max=50.0, ratio=-1.0}", peak = "{cycles=1, max=80.0, min=0.0}";
    const std::string said = longer(same + "," + peak);
    EXPECT_NE(said.find("in cycle 2, which"), std::string::npos) << said;
    EXPECT_NE(said.find("it ended at 50, not 80; a cycle to 50 between them"), std::string::npos) << said;
    EXPECT_EQ(longer(same + ", {cycles=1, max=50.0, ratio=0.0}," + peak), fine);
    EXPECT_EQ(longer("{cycles=2, max=50.0, ratio=0.0}").find("it ended at"), std::string::npos);
}

// The way from where dead loads have moved the boundary has another end.
TEST_F(SameCase, BeginsWithTheSameDisplacementBesideADeadLoad) {
    const auto begins_with = [](double max) {
        Scene scene = refined_scene(test::sent_case({"mesh.size=10.0", "mesh.grading=[]"}));
        scene.input.load.control = Control::Displacement;
        scene.input.load.blocks = {{.cycles = 1, .max = max, .min = -1.0}};
        scene.input.load_cases = {test::dead_load("dead", 1.0)};
        return mark_of(scene);
    };
    LoadPosition reached;
    const auto against_now = [&](double now) {
        return refusal_of([&] { check_same_case(begins_with(0.0), begins_with(now), reached); });
    };
    EXPECT_EQ(against_now(2.0), fine) << "the dead load is on its way yet";
    reached.leg = 1;
    EXPECT_EQ(against_now(0.0), fine);
    EXPECT_NE(against_now(2.0).find("in cycle 0"), std::string::npos);
    reached.leg = 2;
    EXPECT_EQ(against_now(0.0), fine);
}

// So has the way from where an initial stress has, and nothing comes before it.
TEST_F(SameCase, BeginsWithTheSameDisplacementBesideAnInitialStress) {
    const auto begins_with = [](std::vector<LoadBlock> blocks) {
        Scene scene = refined_scene(test::sent_case({"mesh.size=10.0", "mesh.grading=[]"}));
        scene.input.load.control = Control::Displacement;
        scene.input.load.blocks = std::move(blocks);
        scene.input.initial_stress.emplace();
        return mark_of(scene);
    };
    const auto against_now = [&](const std::vector<LoadBlock>& then, const std::vector<LoadBlock>& now,
                                 std::size_t leg) {
        LoadPosition reached;
        reached.leg = leg;
        return refusal_of([&] { check_same_case(begins_with(then), begins_with(now), reached); });
    };
    const std::vector<LoadBlock> from_zero{{0, 0.0, 0.0}, {0, 2.0, 0.0}}, at_once{{0, 2.0, 0.0}};
    EXPECT_EQ(against_now(from_zero, from_zero, 0), fine);
    EXPECT_EQ(against_now(from_zero, {{0, 0.0, 0.0}, {0, 3.0, 0.0}}, 0), fine) << "it is not there yet";
    EXPECT_NE(against_now(from_zero, {{0, 0.0, 0.0}, {0, 3.0, 0.0}}, 1).find("in cycle 0"), std::string::npos);
    for (const std::size_t leg : {0U, 1U}) {
        EXPECT_NE(against_now(from_zero, at_once, leg).find("in cycle 0"), std::string::npos);
        EXPECT_NE(against_now(at_once, from_zero, leg).find("in cycle 0"), std::string::npos);
    }
}

// A mesh file may have moved, but not changed.
TEST_F(SameCase, HasTheSameMesh) {
    Scene scene = refined_scene(test::sent_case({"mesh.size=10.0", "mesh.grading=[]"}));
    scene.input.mesh.file = "/there/part.msh";
    const CaseMark before = mark_of(scene);
    const auto against_now = [&] { return refusal_of([&] { check_same_case(before, mark_of(scene), {}); }); };
    scene.input.mesh.file = "/here/part.msh";
    EXPECT_EQ(against_now(), fine);
    Mesh other = *scene.mesh;
    std::swap(other.elements[0], other.elements[1]);
    scene.mesh = BodyMesh(other);
    EXPECT_NE(against_now().find("the mesh is another one"), std::string::npos);
    std::swap(other.elements[0], other.elements[1]);
    other.boundary["top"].pop_back();
    scene.mesh = BodyMesh(other);
    EXPECT_NE(against_now().find("the mesh is another one"), std::string::npos);
    scene.input.mesh.file = "/here/other.msh";
    EXPECT_NE(against_now().find("other.msh"), std::string::npos);
}

}  // namespace
}  // namespace stria::coarse
