#include "fine/zone/taken_over.hpp"

#include "common/index.hpp"

namespace stria::fine {

TakenOver taken_over(const BulkElements& elements, bool all, const ContactInterface& contact,
                     const ContactInterface* old_contact) {
    TakenOver same{.all = all, .elements = {}, .multipliers = std::vector<int>(at(contact.multipliers()), -1)};
    for (int e = 0; e < elements.count(); ++e) same.elements.push_back(all ? e : elements.was(e));
    if (old_contact != nullptr) same.multipliers = contact.operators().places_in(old_contact->operators());
    return same;
}

TakenOver compose(const TakenOver& to_last, TakenOver now) {
    now.all = now.all && to_last.all;
    for (int& e : now.elements) e = e >= 0 ? to_last.elements[at(e)] : -1;
    for (int& k : now.multipliers) k = k >= 0 ? to_last.multipliers[at(k)] : -1;
    return now;
}

}  // namespace stria::fine
