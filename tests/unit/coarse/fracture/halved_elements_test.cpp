// K on elements half as large, beside elements an eighth as large.
#include "coarse/fracture/halved_elements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "coarse/model/mesh_refinement.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

std::vector<int> all_of(const Mesh& mesh) {
    std::vector<int> all(mesh.elements.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// How far K is off, by elements an eighth as large, over how far elements half as large say.
double error_over_change(const Scene& scene) {
    Mesh fine = scene.mesh;
    for (int time = 0; time < 3; ++time) {
        const std::vector<int> all = all_of(fine);
        fine = split_again(std::move(fine), {all});
    }
    const double K = solve_nominal(scene).tips[0].K_I,
                 converged = solve_nominal(make_scene(scene.input, BodyMesh(std::move(fine)))).tips[0].K_I;
    const double change = change_of_K(solve_nominal(scene).tips[0], tips_on_halved_elements(scene)[0]);
    EXPECT_GT(change, 1e-3);
    return std::abs(K / converged - 1.0) / change;
}

// Of first order about a tip with functions in one ring of elements, of second order in the body about small elements.
TEST(HalvedElements, TellHowFarKIsFromConverged) {
    for (const auto& [size, refine] : {std::pair(1.6, 1), std::pair(0.8, 1), std::pair(1.6, 8)}) {
        Case input = test::pulled_plate(size, true, false);
        input.cracks[0].points = {{0.0, 10.03}, {5.0 * size, 10.23}};
        input.fine.refine = refine;
        input.load.blocks = {{.cycles = 1, .max = 60.0, .min = 0.0}};
        const double ratio = error_over_change(refined_scene(input));
        EXPECT_GT(ratio, 1.1) << size << ' ' << refine;
        EXPECT_LT(ratio, 2.3) << size << ' ' << refine;
    }
}

// The case of a crack along the middle of a row: it lies on edges of the halved elements.
TEST(HalvedElements, MayHaveTheirEdgesAlongTheCrack) {
    Case input = test::pulled_plate(0.8, false, false);
    input.cracks[0].points = {{0.0, 10.0}, {5.0, 10.0}};
    const Scene scene = refined_scene(input);
    EXPECT_LT(change_of_K(solve_nominal(scene).tips[0], tips_on_halved_elements(scene)[0]), 0.02);
}

TEST(HalvedElements, LookAtEachLoadThatHasAK) {
    TipResult coarser, finer;
    EXPECT_TRUE(std::isnan(change_of_K(coarser, finer)));
    coarser.K_II_of_cases = {1.0, 10.0};
    finer.K_II_of_cases = {1.1, 10.0};
    EXPECT_NEAR(change_of_K(coarser, finer), 0.01, 1e-12);
    coarser.K_initial = -20.5;
    finer.K_initial = -20.0;
    EXPECT_NEAR(change_of_K(coarser, finer), 0.5 / 20.0, 1e-12);
    coarser.K_II_initial = 21.0;
    finer.K_II_initial = 20.0;
    EXPECT_NEAR(change_of_K(coarser, finer), 1.0 / 20.0, 1e-12);
}

}  // namespace
}  // namespace stria::coarse
