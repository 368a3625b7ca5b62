#include "coarse/structure/far_body.hpp"

#include <algorithm>
#include <numeric>

#include "coarse/elements/coarse_elements.hpp"
#include "common/fem/centre.hpp"
#include "common/index.hpp"
#include "common/integration/plain_operator.hpp"
#include "common/linear/symmetric_assembly.hpp"
#include "common/stopwatch.hpp"
#include "common/substructure/nested_dissection.hpp"

namespace stria::coarse {

FarBody::FarBody(const Scene& scene, ElementSet far, StructureSeconds& seconds) : far_(std::move(far)) {
    IndexLists of_elements;
    {
        const Stopwatch watch(seconds.ordering);
        of_elements = order_elimination(scene);
    }
    SparseMatrix lower = assemble(scene, of_elements, seconds);
    const Stopwatch watch(seconds.factor);
    leaf_ = std::make_unique<SparseLeaf>(static_cast<int>(rim_.size()), std::move(lower));
}

ReducedLoad FarBody::reduce(const Eigen::VectorXd& load) const {
    constexpr std::size_t most = 6;  // a structure has no more of them
    const auto known = std::ranges::find_if(answers_, [&](const Answer& answer) { return answer.load == load; });
    if (known != answers_.end()) return known->reduced;
    if (answers_.size() == most) answers_.erase(answers_.begin());
    answers_.push_back({load, leaf_->reduce(load)});
    return answers_.back().reduced;
}

SparseMatrix FarBody::assemble(const Scene& scene, const IndexLists& of_elements, StructureSeconds& seconds) const {
    const Stopwatch watch(seconds.assembly);
    SparseMatrix lower = lower_pattern(of_elements, static_cast<int>(inner_.size() + rim_.size()));
    std::size_t k = 0;
    for (int e = 0; e < far_.size(); ++e)
        if (far_.contains(e))
            add_to_lower(lower, of_elements[k++], plain_operator(scene, e).stiffness(scene.stiffness(e)));
    return lower;
}

/// Of each unknown of the mesh, ascending; -1 where far elements do not see it, or it is prescribed.
std::vector<int> FarBody::number(const Scene& scene) {
    const EnrichedMesh& mesh = scene.enriched;
    NodeSet by_far(mesh.nodes.size()), by_others = by_far;
    UnknownSet prescribed(mesh.unknowns);
    for (const PrescribedUnknown& p : scene.prescribed) prescribed.insert(p.unknown);
    for (int e = 0; e < far_.size(); ++e)
        for (const int node : mesh.elements[at(e)]) (far_.contains(e) ? by_far : by_others).insert(node);
    for (int node = 0; node < std::ssize(mesh.nodes); ++node) {
        if (!by_far.contains(node)) continue;
        for (const int component : {0, 1}) {
            if (prescribed.contains(mesh.unknown(node, 0, component))) continue;
            (by_others.contains(node) ? rim_ : inner_).push_back({node, component});
        }
    }
    std::vector<int> place(at(mesh.unknowns), -1);
    int next = 0;
    for (const std::vector<Place>* part : {&inner_, &rim_})
        for (const auto& [node, component] : *part) place[at(mesh.unknown(node, 0, component))] = next++;
    return place;
}

/// Renumbers the inner unknowns; returns the elements' unknowns with their new numbers.
IndexLists FarBody::order_elimination(const Scene& scene) {
    const EnrichedMesh& mesh = scene.enriched;
    const std::vector<int> place = number(scene);
    IndexLists of_elements;
    std::vector<Vec2> centres;
    for (const int e : far_.members()) {
        of_elements.append(plain_unknowns(mesh, e));
        centres.push_back(centre(mesh, e));
    }
    of_elements.map([&](int unknown) { return place[at(unknown)]; });
    std::vector<int> kept(rim_.size());
    std::iota(kept.begin(), kept.end(), static_cast<int>(inner_.size()));
    const int unknowns = static_cast<int>(inner_.size() + rim_.size());
    const std::vector<int> order = nested_dissection(of_elements, centres, unknowns, kept);
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

std::vector<int> FarBody::unknowns_of(const EnrichedMesh& mesh, const std::vector<Place>& places) {
    std::vector<int> unknowns;
    unknowns.reserve(places.size());
    for (const auto& [node, component] : places) unknowns.push_back(mesh.unknown(node, 0, component));
    return unknowns;
}

}  // namespace stria::coarse
