// The committed states of an element's points, one after another, without a list of them.
#pragma once

#include "fine/bulk/bulk.hpp"
#include "fine/bulk/element_kernels.hpp"

namespace stria::fine {

template <class Visit> void Bulk::for_each_committed_state(int e, Visit&& visit) const {
    with_kernel(elements_.op(e), [&](const auto& kernel) {
        const auto u = kernel.gather(committed_u_);
        const auto moved = (u - kernel.gather(resting_.displacement())).eval();
        const bool rests = resting_.contains(e);
        for (std::size_t q = 0; q < at(history_.points(e)); ++q) {
            PointState state{history_.stress(e, q), history_.work(e, q), kernel.displacement_gradient(u, q)};
            if (history_.has_frozen_gradients()) state.gradient += history_.frozen_gradient(e, q);
            if (rests) {
                const Mandel strain = kernel.strain(moved, q), change = elements_.elastic_stiffness(e) * strain;
                state.work += (state.stress + 0.5 * change).dot(strain);
                state.stress += change;
            }
            visit(q, state);
        }
    });
}

}  // namespace stria::fine
