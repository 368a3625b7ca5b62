#include "fine/material/implicit/j2_implicit.hpp"

#include <tuple>

#include "fine/material/implicit/increment_in_parts.hpp"

namespace stria::fine {

void J2Implicit::return_points(const J2Update& update, int points, int stride) const {
    // Their memory serves one pack after the other.
    IncrementInParts<pack_size> of_packs(update.law, elasticity_, law_);
    IncrementInParts<1> of_points(update.law, elasticity_, law_);
    update_packs(
        update, points, stride,
        [&]<int rows>(PackPlace<rows>, const Tensors<rows>& strain) { return elasticity_.stress<rows>(strain); },
        [&]<int rows>(PackPlace<rows> at, const Tensors<rows>& strain, const Prediction<rows>& prediction,
                      int substeps) {
            auto& increment = std::get<IncrementInParts<rows>&>(std::tie(of_packs, of_points));
            increment.begin(update, at, deviators_of<rows>(elasticity_.stress<rows>(strain)));
            if (substeps > 1)
                increment.take_within_bound(prediction.flows);
            else
                increment.take_at_once();
            increment.write(update, at, strain);
        });
}

}  // namespace stria::fine
