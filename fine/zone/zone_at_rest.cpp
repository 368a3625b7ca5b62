#include "fine/zone/zone_at_rest.hpp"

#include <algorithm>

#include "common/index.hpp"

namespace stria::fine {

Resting may_rest(const Bulk& bulk, const ContactInterface& contact, const coupling::Patch& patch,
                 const Eigen::VectorXd& held) {
    ElementSet may = bulk.may_rest();
    const auto bears_load = [&](int unknown) {
        return patch.unit_load[unknown] != 0.0 || held[unknown] != 0.0 ||
               (patch.case_loads.cols() > 0 && !patch.case_loads.row(unknown).isZero(0.0));
    };
    for (int e = 0; e < may.size(); ++e) {
        if (std::ranges::any_of(bulk.elements().op(e).unknowns, bears_load)) may.erase(e);
        for (std::size_t t = 0; t < patch.ahead.size(); ++t)
            if (bulk.elements().is_near(e, patch.mesh.tips[t].position, patch.ahead[t])) may.erase(e);
    }
    MultiplierSet steady(contact.multipliers());
    for (int k = 0; k < steady.size(); ++k)
        if (contact.may_rest(k)) steady.insert(k);
    return {std::move(may), std::move(steady)};
}

ZoneAtRest::ZoneAtRest(const Bulk& bulk, const ContactInterface& contact, UnknownSet inside)
    : inside_(std::move(inside)), of_bulk_(bulk.rest_load()), load_(contact.rest_load(bulk.resting().displacement())) {
    load_.head(of_bulk_.size()) += of_bulk_;
}

// -of_bulk . m + m^T K m / 2, m what the unknowns have moved and K the matrix of what rests. K m is the load inside,
// where nothing is out of balance, and what the response lacks of it outside. A multiplier adds nothing: its gap stays
// closed, or its pressure zero.
double ZoneAtRest::energy(const Eigen::VectorXd& moved) const {
    if (response_.size() == 0) return 0.0;
    return 0.5 * moved.dot(load_ - response_) - moved.head(of_bulk_.size()).dot(of_bulk_);
}

}  // namespace stria::fine
