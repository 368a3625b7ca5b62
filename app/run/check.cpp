#include "app/run/check.hpp"

#include <cmath>
#include <fmt/format.h>

#include "app/run/coarse_run.hpp"
#include "coarse/fracture/handbook_comparison.hpp"
#include "coarse/zone/mesh_adequacy.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/case/case_file.hpp"

namespace stria {
namespace {

void print_handbook(const coarse::NominalSolution& nominal) {
    for (const coarse::HandbookLine& line : coarse::compare_with_handbook(nominal)) {
        fmt::print("# {}: handbook {:.6g}", line.quantity + (line.unit.empty() ? "" : ", " + line.unit), line.handbook);
        if (std::isfinite(line.own))
            fmt::print(", this mesh {:.6g} ({:+.2f} %)", line.own, 100.0 * (line.own / line.handbook - 1.0));
        fmt::print("\n");
    }
}

void print_zone_estimate(const coarse::Scene& scene, const coarse::NominalSolution& nominal) {
    const coarse::UnitResponse unit = coarse::unit_response(nominal);
    const double largest = coarse::largest_load_factor(scene.input.load, unit);
    const std::vector<double> K_I = coarse::largest_K_I(scene.input.load, unit);
    for (std::size_t t = 0; t < K_I.size(); ++t) {
        fmt::print("# tip {}: K_I = {:.5g} MPa sqrt(mm) at the load factor {:g} (elastic, traction-free faces)\n",
                   t + 1, K_I[t], largest);
        if (scene.initial_stress().any())
            fmt::print("#   of it {:.5g} MPa sqrt(mm) by the initial stress\n", unit.K_initial[t]);
        if (const double yield_stress = scene.yield_stress_at_tips()[t]; std::isfinite(yield_stress)) {
            fmt::print("#   radius of the zone, eq. (3): {:.4g} mm\n",
                       coarse::subdivision_radius(scene.input.fine.beta, K_I[t], yield_stress));
        }
    }
    const int elements = coarse::select_zone(scene, K_I).count();
    const int subcells = subcells_elsewhere(scene.input.fine);
    fmt::print("# zone: {} elements, about {} points\n", elements, elements * 4 * subcells * subcells);
}

void print_warnings(const coarse::Scene& scene, const coarse::NominalSolution& nominal) {
    for (const std::string& warning :
         coarse::mesh_warnings(scene, coarse::largest_K_I(scene.input.load, coarse::unit_response(nominal))))
        fmt::print("# warning: {}\n", warning);
}

}  // namespace

int check(const RunOptions& options) {
    const Case input = read_case(options.case_path, options.overrides);
    const coarse::Scene scene = scene_of(options, input);
    fmt::print("{}\n", resolved_toml(input));
    fmt::print("# mesh: {} nodes, {} elements, {} unknowns with enrichment; {} tips\n", scene.mesh.nodes.size(),
               scene.mesh.elements.size(), scene.enriched.unknowns, scene.enriched.tips.size());
    const coarse::NominalSolution nominal = coarse::solve_nominal(scene);
    print_handbook(nominal);
    print_warnings(scene, nominal);
    if (!needs_fine(input)) {
        fmt::print("# elastic, traction-free, unrefined: no fine component is started\n");
        return 0;
    }
    print_zone_estimate(scene, nominal);
    return 0;
}

}  // namespace stria
