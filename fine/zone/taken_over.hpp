// What a new zone has of the one before.
#pragma once

#include <vector>

#include "fine/bulk/bulk_elements.hpp"
#include "fine/contact/contact_interface.hpp"

namespace stria::fine {

struct TakenOver {
    bool all = false;  // nothing is new but the places of the tips
    /// Of each, its number there, -1: it is new. Such elements have the same elastic matrix. Faces may have changed.
    std::vector<int> elements, multipliers;
};

/// `all`: the elements are the same object. `old_contact`: null, or the faces of the zone before.
[[nodiscard]] TakenOver taken_over(const BulkElements& elements, bool all, const ContactInterface& contact,
                                   const ContactInterface* old_contact);

/// What a zone has of the one before the last, which gave `to_last` to the last one.
[[nodiscard]] TakenOver compose(const TakenOver& to_last, TakenOver now);

}  // namespace stria::fine
