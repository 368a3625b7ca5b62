#include "coarse/advice/settled_stress.hpp"

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// Elastic energy of the stress as it is given, by the centres of the elements, N.
double energy_as_given(const Scene& scene) {
    double energy = 0.0;
    for (int e = 0; e < std::ssize(scene.mesh->elements); ++e) {
        const auto& nodes = scene.mesh->elements[at(e)];
        const Vec2 a = scene.mesh->nodes[at(nodes[2])] - scene.mesh->nodes[at(nodes[0])];
        const Vec2 b = scene.mesh->nodes[at(nodes[3])] - scene.mesh->nodes[at(nodes[1])];
        const double area = 0.5 * cross(a, b);
        energy += area * scene.elastic(e).energy(scene.initial_stress(e, centre(*scene.mesh, e)));
    }
    return energy;
}

}  // namespace

void judge_settled_stress(const Scene& scene, double stored, const std::function<void(const std::string&)>& note) {
    constexpr double least = 0.25;
    const double given = energy_as_given(scene);
    if (given == 0.0) return;
    const double share = stored / given;
    note(fmt::format("initial stress: equilibrium leaves {:.3g} % of its energy", 100.0 * share));
    if (scene.input.initial_stress && share < least)
        throw CaseError(fmt::format("initial_stress: equilibrium without load leaves {:.3g} % of its energy: the field "
                                    "is not self-equilibrated in this body",
                                    100.0 * share));
}

}  // namespace stria::coarse
