// Whether the mesh about a tip lets rings tell its K and J.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "coarse/advice/mesh_doubt.hpp"
#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// A bend less than two elements behind a tip, which rings pass over.
[[nodiscard]] std::optional<MeshDoubt> doubt_of_bend(const Scene& scene, std::size_t tip);

/// A sharp bend that leaves no ring for J.
[[nodiscard]] std::optional<MeshDoubt> doubt_of_sharp_bend(const Scene& scene, std::size_t tip);

/// No ring of as many elements about it as K wants, two or three, which is not due to a bend. `radius`: of the largest
/// ring, mm.
[[nodiscard]] std::optional<MeshDoubt> doubt_of_room(const Scene& scene, std::size_t tip, double radius);

/// Where there are several metals: no ring of two elements in its own, and graver, none that leaves K within a percent.
[[nodiscard]] std::optional<MeshDoubt> doubt_of_metal(const Scene& scene, std::size_t tip);

/// Another crack as near as functions of the tip's element alone, or none, leave K off by more than two percent.
[[nodiscard]] std::optional<MeshDoubt> doubt_of_neighbour(const Scene& scene, std::size_t tip);

/// Of a tip whose elements make functions stand at others, which have elements small enough for none.
struct TipOfFunctions {
    std::size_t tip;
    MeshDoubt doubt;
};
[[nodiscard]] std::optional<TipOfFunctions> doubt_of_functions(const Scene& scene);

}  // namespace stria::coarse
