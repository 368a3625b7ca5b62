#include "fine/zone/zone_tree.hpp"

#include <utility>

#include "common/index.hpp"
#include "fine/zone/tree_layout.hpp"

namespace stria::fine {

void ZoneTree::turn_to(const TakenOver& taken_over) {
    // While tips stay in their elements the tree stays as it is.
    if (!due_ && tree_ && taken_over.all && busy_ == busy_places(system_.patch().mesh)) return;
    due_ = due_ ? compose(*due_, taken_over) : taken_over;
}

void ZoneTree::plant_where_due() {
    if (!due_) return;
    const TakenOver taken_over = *std::exchange(due_, std::nullopt);
    if (!tree_) return plant();
    const std::vector<int> same = unchanged(taken_over);
    read_multipliers();
    tree_ = std::make_unique<FrontTree>(layout_of_tree(system_), *tree_, same);
    begin(same);
}

void ZoneTree::plant() {
    due_.reset();
    read_multipliers();
    tree_ = std::make_unique<FrontTree>(layout_of_tree(system_));
    begin(std::vector<int>(at(elements() + system_.contact().multipliers()), -1));
}

// Of each id, the one of the last tree with the same matrix in it, -1: none. The tangents of a new zone are elastic.
std::vector<int> ZoneTree::unchanged(const TakenOver& taken_over) const {
    std::vector<int> same;
    const auto equal = [](const auto& a, const auto& b) { return a.rows() == b.rows() && a == b; };
    for (const int e : taken_over.elements) same.push_back(e >= 0 && !flows_.contains(e) ? e : -1);
    for (int k = 0; k < system_.contact().multipliers(); ++k) {
        const int before = taken_over.multipliers[at(k)];
        const bool stays = before >= 0 && statuses_[at(before)] == system_.contact().statuses()[at(k)] &&
                           equal(multiplier_matrices_[at(before)], system_.contact().matrix_of(k));
        same.push_back(stays ? flows_.size() + before : -1);
    }
    return same;
}

void ZoneTree::begin(const std::vector<int>& same) {
    busy_ = busy_places(system_.patch().mesh);
    flows_ = ElementSet(elements());
    changed_ = ElementSet(same.size());
    for (std::size_t id = 0; id < same.size(); ++id)
        if (same[id] < 0) changed_.insert(id);
    new_ = true;
}

void ZoneTree::read_multipliers() {
    statuses_ = system_.contact().statuses();
    multiplier_matrices_.clear();
    for (int k = 0; k < system_.contact().multipliers(); ++k)
        multiplier_matrices_.push_back(system_.contact().matrix_of(k));
}

void ZoneTree::find_changes() {
    const ElementSet& changed = system_.bulk().changed();
    for (int e = 0; e < changed.size(); ++e)
        if (changed.contains(e)) changed_.insert(e);
    const std::vector<FaceStatus>& statuses = system_.contact().statuses();
    for (std::size_t k = 0; k < statuses.size(); ++k) {
        if (statuses_[k] == statuses[k]) continue;
        statuses_[k] = statuses[k];
        multiplier_matrices_[k] = system_.contact().matrix_of(static_cast<int>(k));
        changed_.insert(at(elements()) + k);
    }
}

bool ZoneTree::some_status_changed() const {
    const auto& flags = changed_.flags();
    return std::find(flags.begin() + elements(), flags.end(), 1) != flags.end();
}

void ZoneTree::factor() {
    const long before = tree_->refactored(), general_before = tree_->refactored_general();
    tree_->factor(
        [&](int id) {
            if (id < elements()) return FrontTree::ElementMatrix{system_.bulk().tangent(id)};
            const std::size_t k = at(id - elements());
            return FrontTree::ElementMatrix{multiplier_matrices_[k],
                                            slides(statuses_[k]) ? Symmetry::General : Symmetry::Symmetric};
        },
        changed_.flags());
    const long refactored = tree_->refactored() - before;
    work_.fronts_refactored += refactored;
    work_.fronts_general += tree_->refactored_general() - general_before;
    work_.fronts_kept += tree_->fronts() - refactored;
    for (int e = 0; e < elements(); ++e) {
        if (!changed_.contains(e)) continue;
        if (system_.bulk().softened().contains(e))
            flows_.insert(e);
        else
            flows_.erase(e);
    }
    changed_ = ElementSet(changed_.size());
    new_ = false;
}

ElementSet ZoneTree::ids_of(const Resting& some) const {
    ElementSet ids(changed_.size());
    for (const int e : some.elements.members()) ids.insert(e);
    for (const int k : some.multipliers.members()) ids.insert(elements() + k);
    return ids;
}

Resting ZoneTree::resting() const {
    Resting resting{ElementSet(elements()), MultiplierSet(system_.contact().multipliers())};
    for (const int id : tree_->resting().members()) {
        if (id < elements())
            resting.elements.insert(id);
        else
            resting.multipliers.insert(id - elements());
    }
    return resting;
}

}  // namespace stria::fine
