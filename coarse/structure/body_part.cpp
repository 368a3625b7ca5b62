#include "coarse/structure/body_part.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include "common/fem/centre.hpp"
#include "common/index.hpp"
#include "common/linear/symmetric_assembly.hpp"
#include "common/stopwatch.hpp"
#include "common/substructure/nested_dissection.hpp"

namespace stria::coarse {
namespace {

/// Whatever the sizes of the sets.
bool same_members(const ElementSet& a, const ElementSet& b) {
    const auto [one, other] = std::ranges::mismatch(a.flags(), b.flags());
    const auto is_in = [](char flag) { return flag != 0; };
    return std::none_of(one, a.flags().end(), is_in) && std::none_of(other, b.flags().end(), is_in);
}

}  // namespace

BodyPart::BodyPart(const Scene& scene, ElementSet elements, std::shared_ptr<const BodyPart> below,
                   StructureSeconds& seconds)
    : elements_(std::move(elements)), below_(std::move(below)) {
    const SceneElements all(scene);
    IndexLists of_elements;
    {
        const Stopwatch watch(seconds.ordering);
        of_elements = order_elimination(all);
    }
    SparseMatrix lower = assemble(all, of_elements, seconds);
    const Stopwatch watch(seconds.factor);
    auto own = std::make_shared<const SparseLeaf>(static_cast<int>(rim_.size()), std::move(lower), Answers::Remembered);
    factor_entries_ = own->factor_entries();
    std::vector<int> places;
    if (below_) places.assign(of_elements[of_elements.size() - 1].begin(), of_elements[of_elements.size() - 1].end());
    leaf_ = std::make_unique<const StackedLeaf>(below_, std::move(places), std::move(own));
}

bool BodyPart::is_of(const ElementSet& elements, const BodyPart* below) const {
    return below_.get() == below && same_members(elements_, elements);
}

SparseMatrix BodyPart::assemble(const SceneElements& all, const IndexLists& of_elements,
                                StructureSeconds& seconds) const {
    const Stopwatch watch(seconds.assembly);
    SparseMatrix lower = lower_pattern(of_elements, static_cast<int>(inner_.size() + rim_.size()));
    std::size_t k = 0;
    for (const int e : elements_.members())
        all.visit_operator(
            e, [&](const auto& op) { add_to_lower(lower, of_elements[k++], op.stiffness(all.scene().stiffness(e))); });
    if (below_) add_to_lower(lower, of_elements[k], below_->tangent());
    return lower;
}

/// Of each unknown of the mesh, ascending; -1 where the part does not see it, or it is prescribed.
std::vector<int> BodyPart::number(const SceneElements& all) {
    const EnrichedMesh& mesh = all.scene().enriched;
    UnknownSet own(mesh.unknowns), by_others = own;
    for (int e = 0; e < elements_.size(); ++e) {
        if (below_ && below_->holds(e)) continue;
        UnknownSet& seen = elements_.contains(e) ? own : by_others;
        all.visit_unknowns(e, [&](std::span<const int> unknowns) {
            for (const int unknown : unknowns) seen.insert(unknown);
        });
    }
    if (below_)
        for (const int unknown : below_->rim(mesh)) own.insert(unknown);
    for (const PrescribedUnknown& p : all.scene().prescribed) own.erase(p.unknown);
    for (const auto& [node, term, first] : mesh.own_unknowns())
        for (const int component : {0, 1})
            if (own.contains(first + component))
                (by_others.contains(first + component) ? rim_ : inner_).push_back({node, term, component});
    std::vector<int> place(at(mesh.unknowns), -1);
    int next = 0;
    for (const std::vector<Place>* part : {&inner_, &rim_})
        for (const int unknown : unknowns_of(mesh, *part)) place[at(unknown)] = next++;
    return place;
}

/// Renumbers the inner unknowns; returns the unknowns of the elements, and as one list more those of the rim below,
/// with their new numbers.
IndexLists BodyPart::order_elimination(const SceneElements& all) {
    const EnrichedMesh& mesh = all.scene().enriched;
    const std::vector<int> place = number(all);
    IndexLists of_elements;
    std::vector<Vec2> centres;
    for (const int e : elements_.members()) {
        all.visit_unknowns(e, [&](std::span<const int> unknowns) { of_elements.append(unknowns); });
        centres.push_back(centre(mesh, e));
    }
    std::vector<char> late;
    if (below_) {  // its rim is no element's own: it comes after all of them
        late.assign(centres.size(), 1);
        late.push_back(0);
        of_elements.append(below_->rim(mesh));
        centres.emplace_back(Vec2::Zero());
    }
    of_elements.map([&](int unknown) { return place[at(unknown)]; });
    std::vector<int> kept(rim_.size());
    std::iota(kept.begin(), kept.end(), static_cast<int>(inner_.size()));
    const int unknowns = static_cast<int>(inner_.size() + rim_.size());
    const std::vector<int> order = nested_dissection(of_elements, centres, unknowns, kept, late);
    const std::vector<Place> before = std::move(inner_);
    std::vector<int> rank(order.size());
    inner_.clear();
    for (std::size_t k = 0; k < order.size(); ++k) {
        rank[at(order[k])] = static_cast<int>(k);
        if (k < before.size()) inner_.push_back(before[at(order[k])]);
    }
    of_elements.map([&](int unknown) { return unknown < 0 ? -1 : rank[at(unknown)]; });
    return of_elements;
}

std::vector<int> BodyPart::unknowns_of(const EnrichedMesh& mesh, const std::vector<Place>& places) {
    std::vector<int> unknowns;
    unknowns.reserve(places.size());
    for (const auto& [node, term, component] : places) unknowns.push_back(mesh.unknown(node, term, component));
    return unknowns;
}

}  // namespace stria::coarse
