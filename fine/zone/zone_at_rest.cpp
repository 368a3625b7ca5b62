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
            if (bulk.elements().is_near(e, patch.mesh.tips[t].end_of_faces(), patch.ahead[t])) may.erase(e);
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

// -of_bulk . u + u^T K u / 2, u what the displacements have moved and K the matrix of the elements that rest. With the
// changes t of the tractions, K u - B^T t = d_u and -B u = d_t, where d is the load inside, where nothing is out of
// balance, and what the response lacks of it outside. So u^T K u = u . d_u - t . d_t. Most gaps are closed from the
// start, d_t = 0; those of a bend that growth has moved are not.
double ZoneAtRest::energy(const Eigen::VectorXd& moved) const {
    if (response_.size() == 0) return 0.0;
    const Eigen::VectorXd done = load_ - response_;
    const Eigen::Index displacements = of_bulk_.size(), tractions = moved.size() - displacements;
    const auto u = moved.head(displacements);
    return 0.5 * (u.dot(done.head(displacements)) - moved.tail(tractions).dot(done.tail(tractions))) - u.dot(of_bulk_);
}

}  // namespace stria::fine
