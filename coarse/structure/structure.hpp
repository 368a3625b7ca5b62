// The coarse component's elements: linear elastic, never subdivided, condensed onto the boundary of the zone: the far
// ones first, once for many structures, the near ones with these on top.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "coarse/fracture/ring_forms.hpp"
#include "coarse/load/target.hpp"
#include "coarse/model/scene.hpp"
#include "coarse/structure/far_body.hpp"
#include "coarse/structure/near_elements.hpp"
#include "common/fracture/domain_integral.hpp"
#include "common/index.hpp"
#include "common/index_lists.hpp"
#include "common/integration/plain_operator.hpp"
#include "common/substructure/stacked_leaf.hpp"

namespace stria::coarse {

/// The near elements condensed onto Gamma: the same matrix has the same factor.
struct NearFactor {
    SparseMatrix matrix;  // lower triangle, in the order of elimination, with the far body's tangent on the rim
    int boundary;
    std::shared_ptr<const SparseLeaf> leaf;
};

/// What one structure leaves to the next.
struct StructureFactors {
    std::shared_ptr<const FarBody> far;  // null: no element is far
    std::shared_ptr<const NearFactor> near;
};

class Structure {
public:
    /// `in_zone`: per element, 1 where the fine component owns it. Every element belongs to exactly one side. `far`:
    /// per element, 1 where each increment does without it. `known`: factors that serve again where they are those of
    /// this structure too, to the last bit.
    Structure(const Scene& scene, std::vector<char> in_zone, const std::vector<char>& far, StructureFactors known = {});

    /// With the far elements that near_elements.hpp chooses.
    Structure(const Scene& scene, const std::vector<char>& in_zone)
        : Structure(scene, in_zone, far_elements(scene, in_zone)) {}

    [[nodiscard]] StructureFactors factors() const { return {far_, near_factor_}; }

    /// Gamma (gamma.hpp).
    [[nodiscard]] const std::vector<int>& gamma() const { return gamma_; }

    /// Places in gamma() that are not prescribed: the unknowns of the condensed system, in order.
    [[nodiscard]] const std::vector<int>& free_places() const { return free_places_; }

    /// Condensed tangent and unit load on the free places: the structure pushes with load * lambda - tangent * u.
    [[nodiscard]] const Eigen::MatrixXd& tangent() const { return leaf_->tangent(); }
    [[nodiscard]] const Eigen::VectorXd& unit_load() const { return reduced_.boundary; }

    /// The scene's mean displacement on the free places. What of it lies inside the structure acts through its
    /// stiffness on them, and with them held gives way to the load alone.
    [[nodiscard]] const Controlled& mean_displacement() const { return mean_displacement_; }

    /// What holds the loaded boundary along its direction, N/mm, as far as coarse elements do: on the free places, like
    /// mean_displacement(); zero where forces load it.
    [[nodiscard]] const Controlled& holding_force() const { return holding_force_; }

    /// What the unit loads on the structure do work on, the same way.
    [[nodiscard]] const Controlled& load_displacement() const { return load_displacement_; }

    /// What unit imposed displacements do work against, as far as coarse elements resist, the same way.
    [[nodiscard]] const Controlled& imposed_force() const { return imposed_force_; }

    /// Of the coarse elements, N (per mm of thickness): (1/2) u . K u without visiting one.
    [[nodiscard]] double stored_energy(const Eigen::VectorXd& gamma_displacement, double load_factor) const;

    /// The free ones of values on gamma().
    [[nodiscard]] Eigen::VectorXd on_free_places(const Eigen::VectorXd& gamma_values) const;

    /// All unknowns of the whole mesh that coarse elements see, given the displacement of gamma(); others are zero.
    [[nodiscard]] Eigen::VectorXd expand(const Eigen::VectorXd& gamma_displacement, double load_factor) const;

    /// Coarse elements that each increment looks at, ascending; the others are far (near_elements.hpp).
    [[nodiscard]] const std::vector<int>& near_elements() const { return near_elements_; }
    [[nodiscard]] bool is_far(int element) const { return far_ && far_->far()[at(element)] != 0; }

    /// Unknowns that near elements see, and those of free_places(), which are the last, in their order. Prescribed ones
    /// are not among them.
    [[nodiscard]] std::span<const int> near_unknowns() const {
        return std::span(leaf_unknowns_).subspan(at(far_count_));
    }

    /// Those that far elements see too: with the load factor they tell all of the far body. Ascending.
    [[nodiscard]] const std::vector<int>& rim() const { return rim_; }

    /// expand() on near elements alone: overwrites in `u` (of the whole mesh) what they see. Costs the near factor.
    void expand_near(const Eigen::VectorXd& gamma_displacement, double load_factor, Eigen::VectorXd& u) const;

    /// What far elements resist with on the rim, given its displacement and no load, N/mm. Half their product is the
    /// far energy.
    [[nodiscard]] Eigen::VectorXd far_force(const Eigen::VectorXd& rim_displacement) const;

    /// All unknowns of the whole mesh that far elements see, given the same; others are zero.
    [[nodiscard]] Eigen::VectorXd expand_far(const Eigen::VectorXd& rim_displacement) const;

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const std::vector<char>& in_zone() const { return in_zone_; }
    [[nodiscard]] int unknowns() const { return static_cast<int>(leaf_unknowns_.size()); }
    [[nodiscard]] const StructureSeconds& seconds() const { return seconds_; }
    [[nodiscard]] double factor_entries() const {
        return near_factor_->leaf->factor_entries() + (far_ ? far_->factor_entries() : 0.0);
    }

    /// The rings about a tip and the coarse elements' share in their domain integrals; made when first asked for.
    [[nodiscard]] const RingForms& rings(int tip) const;
    void make_rings() const;

    /// Internal force of the coarse elements on the prescribed unknowns of the scene, N/mm, in their order.
    [[nodiscard]] Eigen::VectorXd forces_on_prescribed(const Eigen::VectorXd& u) const;

    /// Internal force of the coarse elements on all unknowns of the whole mesh, from stresses: no rounding of K u where
    /// u is mostly rigid motion, N/mm.
    [[nodiscard]] Eigen::VectorXd internal_force(const Eigen::VectorXd& u) const;

    /// The stiffness of the coarse elements over all unknowns of the whole mesh (the monolithic yardstick).
    [[nodiscard]] SparseMatrix stiffness() const;

    /// Calls visit(op) for each coarse element, ascending, with its PlainOperator or its ElementOperator: alike to a
    /// generic visitor. Plain ones are made on demand and last for the visit, unless there are few enough to keep.
    template <class Visit> void for_each_operator(Visit&& visit) const;

    /// Of some coarse elements.
    template <class Visit> void for_each_operator(std::span<const int> elements, Visit&& visit) const {
        for (const int element : elements) visit_operator(element, visit);
    }

private:
    template <class Visit> void visit_operator(int element, Visit&& visit) const;
    template <class Visit> void for_each_coarse(Visit&& visit) const;  // visit(element, its unknowns), ascending
    template <class Visit> void for_each_near(Visit&& visit) const;    // likewise

    void make_enriched_operators();
    void keep_plain_operators();
    void number_unknowns();
    void make_far_body(const std::vector<char>& far, StructureFactors& known);
    [[nodiscard]] IndexLists order_elimination();
    [[nodiscard]] Eigen::VectorXd load_of_imposed(const Eigen::VectorXd& imposed) const;
    [[nodiscard]] SparseMatrix assemble();
    void condense(const StructureFactors& known);
    void condense_loads();
    void condense_readings();
    void find_near_supports();
    void condense_energy();
    [[nodiscard]] Controlled displacement_of(const Eigen::VectorXd& weights) const;
    [[nodiscard]] Controlled force_of(const Eigen::VectorXd& shares) const;

    const Scene& scene_;
    std::vector<char> in_zone_;
    std::vector<int> near_elements_;
    std::shared_ptr<const FarBody> far_;
    std::shared_ptr<const NearFactor> near_factor_;
    bool mean_dilatation_;
    std::vector<ElementOperator> enriched_;  // of coarse elements that are not plain, ascending
    std::vector<PlainOperator> plain_;       // of near ones that are, ascending; empty: made on demand
    std::vector<int> plain_place_;           // per element: in plain_
    std::vector<int> supported_;             // coarse elements with a prescribed unknown
    std::vector<int> gamma_, free_places_;
    std::vector<int> leaf_unknowns_;  // whole-mesh unknown of each leaf unknown
    std::vector<int> leaf_index_;     // and back; -1: prescribed or inside the zone
    int far_count_ = 0;               // of the leaf's unknowns: the first ones, which far elements alone see
    std::vector<int> rim_;
    std::vector<PrescribedUnknown> near_supports_;  // that near elements see
    std::unique_ptr<StackedLeaf> leaf_;
    ReducedLoad reduced_;        // of the unit load factor
    Eigen::VectorXd near_load_;  // the near part of its interior
    Controlled mean_displacement_, holding_force_, load_displacement_, imposed_force_;
    double unit_energy_ = 0.0;  // twice the energy of the unit load factor with the free places held
    StructureSeconds seconds_;
    mutable std::vector<std::unique_ptr<RingForms>> rings_;  // per tip
};

template <class Visit> void Structure::visit_operator(int element, Visit&& visit) const {
    if (!plain_.empty() && plain_place_[at(element)] >= 0)
        visit(plain_[at(plain_place_[at(element)])]);
    else if (is_plain(scene_.enriched, element))
        visit(plain_operator(scene_.enriched, element, mean_dilatation_));
    else
        visit(*std::ranges::lower_bound(enriched_, element, {}, &ElementOperator::element));
}

template <class Visit> void Structure::for_each_coarse(Visit&& visit) const {
    auto enriched = enriched_.begin();
    for (int element = 0; element < static_cast<int>(in_zone_.size()); ++element) {
        if (in_zone_[at(element)] != 0) continue;
        if (is_plain(scene_.enriched, element))
            visit(element, std::span<const int>(plain_unknowns(scene_.enriched, element)));
        else
            visit(element, std::span<const int>((enriched++)->unknowns));
    }
}

// What is not plain is near.
template <class Visit> void Structure::for_each_near(Visit&& visit) const {
    auto enriched = enriched_.begin();
    for (const int element : near_elements_) {
        if (is_plain(scene_.enriched, element))
            visit(element, std::span<const int>(plain_unknowns(scene_.enriched, element)));
        else
            visit(element, std::span<const int>((enriched++)->unknowns));
    }
}

template <class Visit> void Structure::for_each_operator(Visit&& visit) const {
    for (int element = 0; element < static_cast<int>(in_zone_.size()); ++element)
        if (in_zone_[at(element)] == 0) visit_operator(element, visit);
}

}  // namespace stria::coarse
