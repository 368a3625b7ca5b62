// The linear elastic elements outside the zone and their operators.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "coarse/elements/scene_elements.hpp"
#include "common/index.hpp"
#include "common/index_set.hpp"
#include "common/linear/sparse.hpp"

namespace stria::coarse {

/// Coarse elements that stay as they are while cracks grow (near_elements.hpp). Each set may be of size zero.
struct StillElements {
    ElementSet far;          // plain; no increment visits them
    ElementSet middle;       // plain and near, but of no core: away from tips and zone
    ElementSet behind = {};  // of the whole body, without a zone: what else is away from the tips, wakes included
    bool operator==(const StillElements&) const = default;
};

class CoarseElements {
public:
    /// `in_zone`: elements that the fine component owns; all others are coarse. `scene` must outlive the elements.
    CoarseElements(const Scene& scene, ElementSet in_zone, const StillElements& still);

    [[nodiscard]] const Scene& scene() const { return all_.scene(); }
    [[nodiscard]] const ElementSet& in_zone() const { return in_zone_; }

    /// Coarse elements that each increment visits, ascending.
    [[nodiscard]] const std::vector<int>& near() const { return near_; }

    /// Those of them that are neither in the middle nor behind, ascending.
    [[nodiscard]] const std::vector<int>& core() const { return core_; }

    /// Coarse elements with a prescribed unknown, ascending.
    [[nodiscard]] const std::vector<int>& supported() const { return supported_; }

    /// Calls visit(op) for each coarse element, ascending. `op` is a PlainOperator or an ElementOperator; both answer
    /// to the same names. Those of the core that are not plain are kept, and plain ones where there are few enough;
    /// others are made on demand and last for the visit.
    template <class Visit> void for_each(Visit&& visit) const;

    /// The same for some coarse elements, in the order given.
    template <class Visit> void for_each(std::span<const int> elements, Visit&& visit) const {
        for (const int element : elements) visit_operator(element, visit);
    }

    /// Calls visit(element, its unknowns) for some coarse elements, in the order given. `unknowns`: a span over
    /// unknowns of the whole mesh.
    template <class Visit> void for_each_unknowns(std::span<const int> elements, Visit&& visit) const {
        for (const int element : elements) visit_unknowns(element, visit);
    }
    /// The same for each one, ascending.
    template <class Visit> void for_each_unknowns(Visit&& visit) const;

    /// Internal force on all unknowns of the whole mesh, N/mm, at the displacement `u` of the whole mesh, mm, without
    /// that of the initial stress. It is integrated from stresses: K u would round badly where u is mostly a rigid
    /// motion.
    [[nodiscard]] Eigen::VectorXd internal_force(const Eigen::VectorXd& u) const;

    /// What an initial stress does before anything has moved.
    struct Initial {
        Eigen::VectorXd
            load;             // on all unknowns of the whole mesh, N/mm: minus its internal force; empty: there is none
        double energy = 0.0;  // N (per mm of thickness)
    };
    [[nodiscard]] const Initial& initial() const { return initial_; }

    /// Stiffness over all unknowns of the whole mesh, MPa: the monolithic yardstick.
    [[nodiscard]] SparseMatrix stiffness() const;

private:
    template <class Visit> void visit_operator(int element, Visit&& visit) const;
    template <class Visit> void visit_unknowns(int element, Visit&& visit) const;
    /// Null where it is none that is kept.
    [[nodiscard]] const ElementOperator* kept_operator(int element) const;
    void make_enriched_operators();
    void keep_plain_operators();
    void find_supported();
    void integrate_initial_stress();

    SceneElements all_;
    ElementSet in_zone_;
    std::vector<int> near_, core_;
    std::vector<int> supported_;
    std::vector<ElementOperator> enriched_;  // of elements of the core that are not plain, ascending
    std::vector<PlainOperator> plain_;       // of near ones that are, ascending; empty: made on demand
    std::vector<int> plain_place_;           // per element: in plain_, or -1
    Initial initial_;
};

inline const ElementOperator* CoarseElements::kept_operator(int element) const {
    const auto found = std::ranges::lower_bound(enriched_, element, {}, &ElementOperator::element);
    return found != enriched_.end() && found->element == element ? &*found : nullptr;
}

template <class Visit> void CoarseElements::visit_operator(int element, Visit&& visit) const {
    if (!plain_.empty() && plain_place_[at(element)] >= 0)
        visit(plain_[at(plain_place_[at(element)])]);
    else if (const ElementOperator* const kept = kept_operator(element))
        visit(*kept);
    else
        all_.visit_operator(element, visit);
}

template <class Visit> void CoarseElements::visit_unknowns(int element, Visit&& visit) const {
    if (const ElementOperator* const kept = kept_operator(element))
        visit(element, std::span<const int>(kept->unknowns));
    else
        all_.visit_unknowns(element, [&](std::span<const int> unknowns) { visit(element, unknowns); });
}

template <class Visit> void CoarseElements::for_each(Visit&& visit) const {
    for (int element = 0; element < in_zone_.size(); ++element)
        if (!in_zone_.contains(element)) visit_operator(element, visit);
}

template <class Visit> void CoarseElements::for_each_unknowns(Visit&& visit) const {
    for (int element = 0; element < in_zone_.size(); ++element)
        if (!in_zone_.contains(element)) visit_unknowns(element, visit);
}

}  // namespace stria::coarse
