// How large a zone is, and will be once its cracks have grown: before a run.
#pragma once

#include <vector>

#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// Sizes of a mesh with its zone.
struct ZoneSize {
    double all = 0.0;       // elements of the mesh, those of the zone among them
    double elements = 0.0;  // of the zone
    double points = 0.0;    // likewise
};

/// Of a zone on its scene as it stands: points as the fine component places them.
[[nodiscard]] ZoneSize size_of_zone(const Scene& scene, const ElementSet& zone);

/// The same once each tip has gone straight on by `way`, mm: the disk of eq. (3) has passed along it, small elements
/// follow, and what a tip has passed keeps its points. `zone`: of select_zone by `K`. `K_on_way`: its mean, likewise
/// one per tip, MPa sqrt(mm).
[[nodiscard]] ZoneSize size_after(const Scene& scene, const ElementSet& zone, const std::vector<double>& K,
                                  const std::vector<double>& K_on_way, double way);

/// The largest K of the load history once each tip has gone straight on by `way`, mm, on the scene's mesh, one per tip,
/// MPa sqrt(mm): takes what the elastic body does. None where cracks cannot be as long.
[[nodiscard]] std::vector<double> K_after(const Scene& scene, double way);

}  // namespace stria::coarse
