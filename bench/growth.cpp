// What a step of growth costs before equilibrium is looked for again: a crack that grows by the same steps in plates of
// more and more elements; once within a zone that holds its way already, once with a zone that moves along.
//     bench_growth [elements across the plate...]
#include <cmath>
#include <cstdio>
#include <vector>

#include "bench/sizes.hpp"
#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/linear/blas.hpp"
#include "fine/zone/fine_model.hpp"

namespace stria {
namespace {

/// Elements of 1 mm, split at the tip; an edge crack that is short beside the plate.
Case plate(int across, int refine) {
    const double side = across, crack = std::floor(0.2 * across) + 0.37;
    Case input;
    input.mesh = {.specimen = "sent", .width = side, .height = side, .size = 1.0, .grading = {}};
    if (refine == 1)
        input.mesh.grading = {{.at = {Vec2(crack, side / 2.0)}, .size = 0.25, .outer_size = {}, .radius = 3.0}};
    input.material = {.young = 200e3, .poisson = 0.3, .yield_stress = 300.0, .isotropic = {}, .kinematic = {}};
    input.material.kinematic = {{.C = 4000.0, .gamma = 0.0}};
    input.cracks = {{.points = {{0.0, side / 2.0 + 0.02}, {crack, side / 2.0 + 0.02}}, .contact = ContactSection{}}};
    for (const double end : {1.0, -1.0}) {
        BoundarySection pulled;
        pulled.on = end > 0.0 ? "top" : "bottom";
        pulled.traction = Vec2(0.0, end);
        input.boundaries.push_back(pulled);
    }
    input.load.steps = 6;
    input.load.blocks = {{.cycles = 6, .max = 100.0 / std::sqrt(crack), .min = 0.0}};
    input.growth.emplace();
    input.growth->increment = 0.3;
    input.fine.radius = 1.5;
    input.fine.refine = refine;
    return input;
}

void measure(int across, int refine) {
    const Case input = plate(across, refine);
    const coarse::Scene scene = coarse::refined_scene(input);
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    coarse::FatigueAnalysis analysis(scene, factory, {});
    analysis.run();
    const int steps = input.load.blocks[0].cycles;
    std::printf("| %zu | %s | %d | %.1f | %.0f |", scene.mesh->elements.size(), refine > 1 ? "within" : "moves",
                analysis.structure().unknowns(), 1e3 * analysis.effort().growth_s / steps,
                1e3 * analysis.effort().setup_s);
    const coupling::WorkCounts made = analysis.effort().work;
    std::printf(" %ld, %ld, %ld, %ld | %zu, %zu |", made.structure_factorisations, made.structure_factors_kept,
                made.middle_factorisations, made.far_factorisations, analysis.structure().elements().near().size(),
                analysis.structure().elements().core().size());
    for (const coarse::TipResult& tip : analysis.nominal()) std::printf(" %.13g |", tip.K_I);
    std::printf("\n");
    std::fflush(stdout);
}

}  // namespace
}  // namespace stria

int main(int argc, char** argv) {
    stria::begin_with_kernels_of_the_processor(argv);
    stria::use_one_thread();
    std::printf("| elements | zone | unknowns of the structure | a step, ms | set-up, ms | core factored, kept, "
                "middle, far factored | near elements, of the core | K_1 |\n|---|---|---|---|---|---|---|---|\n");
    for (const int n : stria::sizes_from(argc, argv, 1, {45, 141, 447}))
        for (const int refine : {4, 1}) stria::measure(n, refine);
}
