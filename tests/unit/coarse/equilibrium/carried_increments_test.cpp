// Increments that an equilibrium remembers, on the Gamma of longer cracks.
#include "coarse/equilibrium/carried_increments.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/index.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

/// A disk of 1.5 mm about the tip, and all that the crack cuts, make the zone.
Scene crack_to(double x) {
    Case input = test::pulled_plate(0.5, true, true);
    input.mesh.width = input.mesh.height = 40.0;
    input.cracks[0].points = {{0.0, 20.2}, {x, 20.2}};
    input.fine.radius = 1.5;
    input.load.blocks = {{.cycles = 20, .max = 50.0, .min = 0.0}};
    input.growth = GrowthSection{.increment = 0.5};
    return refined_scene(input);
}

class IncrementsOnGamma : public testing::Test {
protected:
    IncrementsOnGamma() {
        const auto size = std::ssize(structure.gamma());
        known.increments = {Eigen::VectorXd::LinSpaced(size, 1.0, 2.0), Eigen::VectorXd::LinSpaced(size, 4.0, 3.0)};
        known.load_increments = {3.0, -2.0};
    }
    [[nodiscard]] static ElementSet zone_of(const Scene& scene) { return select_zone(scene, {0.0}); }
    /// The increment of the first structure on all that its near elements see.
    [[nodiscard]] Eigen::VectorXd near(std::size_t k) const {
        Eigen::VectorXd u = Eigen::VectorXd::Zero(scene.enriched.unknowns);
        structure.expand_near(known.increments[k], known.load_increments[k], 0.0, u);
        u(structure.gamma()) = known.increments[k];
        return u;
    }

    const Scene scene = crack_to(7.3), longer = crack_to(7.8);
    const Structure structure{scene, zone_of(scene)}, next{longer, zone_of(longer)};
    EquilibriumState known;
};

TEST_F(IncrementsOnGamma, AreTheSameOnTheSameGamma) {
    const CarriedIncrements carried(structure, known, scene.enriched, NextGamma::Here);
    EquilibriumState state;
    state.load_factor = 7.0;
    state.increments = {Eigen::VectorXd::Zero(3)};
    state.whole_increments = state.increments;
    state = carried.added_to(std::move(state), structure);
    EXPECT_EQ(state.increments, known.increments);
    EXPECT_EQ(state.load_increments, known.load_increments);
    EXPECT_TRUE(state.whole_increments.empty());
    EXPECT_EQ(state.load_factor, 7.0) << "what is committed is the next one's";
}

// Unknowns of Gamma that are the same keep theirs, by node and function; the structure tells those that were its own.
// Functions that are new begin with none.
TEST_F(IncrementsOnGamma, GoOverByNodeAndFunction) {
    const std::vector<int> same = same_unknowns(longer.enriched, scene.enriched);
    const CarriedIncrements near_by(structure, known, longer.enriched, NextGamma::Anywhere),
        here(structure, known, longer.enriched, NextGamma::Here);
    const EquilibriumState from_all = near_by.added_to({}, next), from_gamma = here.added_to({}, next);
    int stayed = 0, from_structure = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        const Eigen::VectorXd u = near(k);
        for (std::size_t i = 0; i < next.gamma().size(); ++i) {
            const auto place = static_cast<Eigen::Index>(i);
            const int before = same[at(next.gamma()[i])];
            const bool on_gamma = before >= 0 && std::ranges::binary_search(structure.gamma(), before);
            EXPECT_EQ(from_all.increments[k][place], before >= 0 ? u[before] : 0.0);
            EXPECT_EQ(from_gamma.increments[k][place], on_gamma ? u[before] : 0.0);
            stayed += on_gamma ? 1 : 0;
            from_structure += before >= 0 && !on_gamma ? 1 : 0;
        }
    }
    EXPECT_GT(stayed, 20);
    EXPECT_GT(from_structure, 20);
}

TEST_F(IncrementsOnGamma, GammaMovesAsFarAsItsElements) {
    ElementSet zone = structure.in_zone();
    EXPECT_EQ(gamma_about(zone, structure), NextGamma::Here);
    const auto insert = [&](auto&& is_wanted) {
        for (int e = 0; e < zone.size(); ++e)
            if (!zone.contains(e) && is_wanted(e)) {
                zone.insert(e);
                return;
            }
        FAIL() << "no such element";
    };
    insert([&](int e) { return !structure.is_far(e) && !structure.is_in_middle(e); });
    EXPECT_EQ(gamma_about(zone, structure), NextGamma::InTheCore);
    insert([&](int e) { return structure.is_far(e); });
    EXPECT_EQ(gamma_about(zone, structure), NextGamma::Anywhere);
}

}  // namespace
}  // namespace stria::coarse
