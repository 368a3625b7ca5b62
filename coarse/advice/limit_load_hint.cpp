#include "coarse/advice/limit_load_hint.hpp"

#include <fmt/format.h>
#include <limits>

namespace stria::coarse {

namespace {

constexpr double part_of_body = 0.1;  // no equilibrium of a body that bears its load moves a boundary by as much

/// Width and height, mm.
Vec2 size_of(const Mesh& mesh) {
    Vec2 least = mesh.nodes.front(), most = least;
    for (const Vec2& node : mesh.nodes) {
        least = least.cwiseMin(node);
        most = most.cwiseMax(node);
    }
    return most - least;
}

bool may_have_limit_load(const Scene& scene) {
    return scene.materials.may_yield() && !scene.unit_force.isZero(0.0) && scene.input.load.control == Control::Load;
}

}  // namespace

std::string limit_load_hint(const Scene& scene, double moved) {
    if (!may_have_limit_load(scene)) return "";
    constexpr auto remedy = "load.control = \"displacement\" goes past its limit load";
    // Of the last equilibrium, which is one that gives_way_at() has let pass: the width tells sooner.
    if (moved < part_of_body * size_of(scene.mesh).x()) return fmt::format("; if the body bears no more, {}", remedy);
    return fmt::format("; the body bears no more, its loaded boundary has moved by {:.3g} mm: {}", moved, remedy);
}

double gives_way_at(const Scene& scene) {
    if (!may_have_limit_load(scene)) return std::numeric_limits<double>::infinity();
    return part_of_body * size_of(scene.mesh).maxCoeff();
}

}  // namespace stria::coarse
