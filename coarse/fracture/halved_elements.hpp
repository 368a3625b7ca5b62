// What elements half as large make of K: how far that of a mesh is from converged, for whoever asks before a run.
#pragma once

#include <vector>

#include "coarse/fracture/nominal_solution.hpp"

namespace stria::coarse {

/// The nominal solution's tips, where each element of the scene's mesh is split in four. Outlines stay as they are: a
/// round one is as many chords as before. Takes four to five times the work of the scene's own nominal solution.
[[nodiscard]] std::vector<TipResult> tips_on_halved_elements(const Scene& scene);

/// The largest difference of a K, over the largest K of the unit load, of any load case and of the initial stress: of
/// one tip on two meshes. NaN where nothing drives it. Where K converges with the h-th power of the elements' size the
/// error of the coarser mesh is 1 / (1 - 2^-h) times this: 4/3 for h = 2, twice this for h = 1.
[[nodiscard]] double change_of_K(const TipResult& coarser, const TipResult& finer);

}  // namespace stria::coarse
