// How far a result is from converged, by what it is on elements of two or more sizes: the grid convergence index of
// Roache, J. Fluids Eng. 116 (1994) 405, with the observed order as Celik and others, ibid. 130 (2008) 078001, tell it
// for any ratio of sizes.
#pragma once

#include <vector>

namespace stria::study {

struct GridValue {
    double size;  // of the elements, in any unit
    double value;
};

enum class Approach {
    Same,         // equal to rounding on the two smallest
    Assumed,      // two sizes: first order is assumed, that of opening loads and of lives by them
    Monotone,     // differences shrink and keep their sign
    Oscillating,  // the sign of the last two differences changes
    Away          // differences do not shrink with the elements
};

/// In one word, for a table.
const char* to_text(Approach approach);

struct GridConvergence {
    Approach approach;
    double finest;       // value on the smallest elements
    double order;        // observed; NaN but where the approach is monotone
    double limit;        // extrapolated to no size; NaN where it oscillates or goes away
    double uncertainty;  // half width of the band about `finest`, in its unit; NaN where it goes away
};

/// Of the three smallest sizes, or of two. The limit takes orders between 1/2 and 2. The difference from it counts 1.25
/// times where three sizes show such an order, else three times. Throws std::invalid_argument for fewer than two
/// different sizes.
GridConvergence grid_convergence(std::vector<GridValue> grids);

}  // namespace stria::study
