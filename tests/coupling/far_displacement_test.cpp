// A growth carries on the displacement of the whole body, though far elements are asked for theirs only where somebody
// wants it.
#include <gtest/gtest.h>

#include <optional>

#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/error.hpp"
#include "fine/zone/fine_model.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::test {
namespace {

/// A wide plate: most of its elements are far from the crack, which grows once.
Case wide_plate(double increment) {
    Case input = pulled_plate(0.5, true, true);
    input.mesh.width = input.mesh.height = 40.0;
    input.cracks[0].points = {{0.0, 20.2}, {7.3, 20.2}};
    input.fine.radius = 1.5;
    input.load.steps = 2;
    input.load.blocks = {{.cycles = 1, .max = 20.0, .min = 0.0}};
    input.growth = GrowthSection{.increment = increment};
    return input;
}

/// Keeps what the zone was told when it grew.
class Watching : public coarse::CondensedFactory {
public:
    Watching(coupling::FineScale* fine, const Case& input, bool fails) : CondensedFactory(fine, input), fails_(fails) {}
    void begin_zone(const coupling::Patch& patch) override {
        if (fails_) throw NumericalFailure("the tangent of the zone is singular");
        last = patch;
        CondensedFactory::begin_zone(patch);
    }
    std::optional<coupling::Patch> last;

private:
    bool fails_;
};

/// Up to where its faces would be released, or to where the growth fails.
struct GrownPlate {
    explicit GrownPlate(double increment, bool fails = false)
        : input(wide_plate(increment)), scene(coarse::refined_scene(input)), fine(input), factory(&fine, input, fails) {
        coarse::Listener listener;
        listener.accepted = [this](const coarse::Increment& accepted, const coarse::Structure& structure) {
            u = accepted.equilibrium->structure_displacement();
            mesh = structure.scene().enriched;
            far = structure.factors().far;
        };
        listener.goes_on = [this] { return !analysis || analysis->state().release.held == 0.0; };
        analysis.emplace(scene, factory, listener);
        try {
            analysis->run();
        } catch (const NumericalFailure&) {
            failed = true;
        }
    }

    Case input;
    coarse::Scene scene;
    fine::FineModel fine;
    Watching factory;
    std::optional<coarse::FatigueAnalysis> analysis;
    bool failed = false;
    Eigen::VectorXd u;  // the last one accepted, of the whole mesh
    EnrichedMesh mesh;
    std::shared_ptr<const coarse::BodyPart> far;
};

// In the last growth the crack gets to where elements were far.
TEST(FarDisplacement, IsThatBeforeTheGrowth) {
    for (const double increment : {0.5, 13.0}) {
        const GrownPlate plate(increment);
        ASSERT_NE(plate.far, nullptr);
        for (const int unknown : plate.far->inner(plate.mesh)) ASSERT_NE(plate.u[unknown], 0.0);
        const coarse::Structure& structure = plate.analysis->structure();
        const EnrichedMesh& longer = structure.scene().enriched;
        const coarse::AnalysisState state = plate.analysis->state();
        EXPECT_EQ(state.release.held, 1.0);
        EXPECT_EQ(state.displacement, carry_over(plate.mesh, plate.u, longer, Eigen::VectorXd::Zero(longer.unknowns)));
        ASSERT_TRUE(plate.factory.last);
        const EnrichedMesh& zone = plate.factory.last->mesh;
        EXPECT_EQ(plate.factory.last->displacement,
                  carry_over(plate.mesh, plate.u, zone, Eigen::VectorXd::Zero(zone.unknowns)));
        EXPECT_EQ(increment > 5.0, std::ranges::any_of(structure.in_zone().members(),
                                                       [&](int element) { return plate.far->contains(element); }));
    }
}

TEST(FarDisplacement, IsThatBeforeAGrowthThatFails) {
    const GrownPlate plate(0.5, true);
    EXPECT_TRUE(plate.failed);
    ASSERT_NE(plate.far, nullptr);
    EXPECT_EQ(plate.analysis->state().displacement, plate.u);
}

}  // namespace
}  // namespace stria::test
