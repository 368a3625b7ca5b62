#include "coarse/fracture/halved_elements.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>

#include "coarse/model/mesh_refinement.hpp"

namespace stria::coarse {
namespace {

std::vector<double> all_K(const TipResult& tip) {
    std::vector<double> all{tip.K_I, tip.K_II, tip.K_initial, tip.K_II_initial};
    for (const std::vector<double>* of_cases : {&tip.K_I_of_cases, &tip.K_II_of_cases})
        all.insert(all.end(), of_cases->begin(), of_cases->end());
    return all;
}

}  // namespace

std::vector<TipResult> tips_on_halved_elements(const Scene& scene) {
    std::vector<int> all(scene.mesh->elements.size());
    std::iota(all.begin(), all.end(), 0);
    const Scene halved = make_scene(scene.input, BodyMesh(split_again(scene.mesh, {all})));
    const std::unique_ptr<const Scene> own = nominal_scene(halved);
    return solve_nominal_near(std::make_unique<Structure>(own ? *own : halved)).tips;
}

double change_of_K(const TipResult& coarser, const TipResult& finer) {
    const std::vector<double> before = all_K(coarser), after = all_K(finer);
    double largest = 0.0, change = 0.0;
    for (std::size_t k = 0; k < after.size(); ++k) {
        largest = std::max(largest, std::abs(after[k]));
        change = std::max(change, std::abs(after[k] - before[k]));
    }
    return largest > 0.0 ? change / largest : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace stria::coarse
