// The linear elastic elements outside the zone and their operators.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "coarse/model/scene.hpp"
#include "common/index.hpp"
#include "common/index_set.hpp"
#include "common/integration/plain_operator.hpp"
#include "common/linear/sparse.hpp"

namespace stria::coarse {

/// Of a plain element (plain_operator.hpp), with the mean dilatation that its material wants.
[[nodiscard]] inline PlainOperator plain_operator(const Scene& scene, int element) {
    return stria::plain_operator(scene.enriched, element, scene.mean_dilatation(element) != MeanDilatation::Nowhere);
}

/// Plain coarse elements that stay as they are while cracks grow (near_elements.hpp). Both sets may be of size zero.
struct StillElements {
    ElementSet far;     // no increment visits them
    ElementSet middle;  // near, but of no core: away from tips and zone
    bool operator==(const StillElements&) const = default;
};

class CoarseElements {
public:
    /// `in_zone`: elements that the fine component owns; all others are coarse. `scene` must outlive the elements.
    CoarseElements(const Scene& scene, ElementSet in_zone, const StillElements& still);

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] const ElementSet& in_zone() const { return in_zone_; }

    /// Coarse elements that each increment visits, ascending.
    [[nodiscard]] const std::vector<int>& near() const { return near_; }

    /// Those of them that are not in the middle, ascending. An element that is not plain is one of them.
    [[nodiscard]] const std::vector<int>& core() const { return core_; }

    /// Coarse elements with a prescribed unknown, ascending.
    [[nodiscard]] const std::vector<int>& supported() const { return supported_; }

    /// Calls visit(op) for each coarse element, ascending. `op` is a PlainOperator or an ElementOperator; both answer
    /// to the same names. Plain ones are made on demand and last for the visit, unless there are few enough to keep.
    template <class Visit> void for_each(Visit&& visit) const;

    /// The same for some coarse elements, in the order given.
    template <class Visit> void for_each(std::span<const int> elements, Visit&& visit) const {
        for (const int element : elements) visit_operator(element, visit);
    }

    /// Calls visit(element, its unknowns) for each coarse element, ascending, for near ones, and for those of the core
    /// alone. `unknowns`: a span over unknowns of the whole mesh.
    template <class Visit> void for_each_unknowns(Visit&& visit) const;
    template <class Visit> void for_each_near_unknowns(Visit&& visit) const { for_each_unknowns(near_, visit); }
    template <class Visit> void for_each_core_unknowns(Visit&& visit) const { for_each_unknowns(core_, visit); }

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
    /// `elements`: ascending, all that are not plain among them.
    template <class Visit> void for_each_unknowns(const std::vector<int>& elements, Visit& visit) const;
    void make_enriched_operators();
    void keep_plain_operators();
    void find_supported();
    void integrate_initial_stress();

    const Scene* scene_;
    ElementSet in_zone_;
    std::vector<int> near_, core_;
    std::vector<int> supported_;
    std::vector<ElementOperator> enriched_;  // of coarse elements that are not plain, ascending
    std::vector<PlainOperator> plain_;       // of near ones that are, ascending; empty: made on demand
    std::vector<int> plain_place_;           // per element: in plain_, or -1
    Initial initial_;
};

template <class Visit> void CoarseElements::visit_operator(int element, Visit&& visit) const {
    if (!plain_.empty() && plain_place_[at(element)] >= 0)
        visit(plain_[at(plain_place_[at(element)])]);
    else if (is_plain(scene_->enriched, element))
        visit(plain_operator(*scene_, element));
    else
        visit(*std::ranges::lower_bound(enriched_, element, {}, &ElementOperator::element));
}

template <class Visit> void CoarseElements::for_each(Visit&& visit) const {
    for (int element = 0; element < in_zone_.size(); ++element)
        if (!in_zone_.contains(element)) visit_operator(element, visit);
}

template <class Visit> void CoarseElements::for_each_unknowns(Visit&& visit) const {
    auto enriched = enriched_.begin();
    for (int element = 0; element < in_zone_.size(); ++element) {
        if (in_zone_.contains(element)) continue;
        if (is_plain(scene_->enriched, element))
            visit(element, std::span<const int>(plain_unknowns(scene_->enriched, element)));
        else
            visit(element, std::span<const int>((enriched++)->unknowns));
    }
}

template <class Visit> void CoarseElements::for_each_unknowns(const std::vector<int>& elements, Visit& visit) const {
    auto enriched = enriched_.begin();
    for (const int element : elements) {
        if (is_plain(scene_->enriched, element))
            visit(element, std::span<const int>(plain_unknowns(scene_->enriched, element)));
        else
            visit(element, std::span<const int>((enriched++)->unknowns));
    }
}

}  // namespace stria::coarse
