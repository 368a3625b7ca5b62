// The coarse component's elements: linear elastic, never subdivided, condensed once onto the boundary of the zone.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "coarse/near_elements.hpp"
#include "coarse/ring_forms.hpp"
#include "coarse/scene.hpp"
#include "coarse/target.hpp"
#include "common/fem/domain_integral.hpp"
#include "common/fem/plain_operator.hpp"
#include "common/index_lists.hpp"
#include "common/linear/sparse_leaf.hpp"

namespace stria::coarse {

/// Seconds that a structure took to make.
struct StructureSeconds {
    double assembly = 0.0;  // numbering and stiffness
    double ordering = 0.0;  // of the elimination
    double factor = 0.0;    // analysis, factor, condensed tangent and load
};

class Structure {
public:
    /// `in_zone`: per element, 1 where the fine component owns it. Every element belongs to exactly one side.
    Structure(const Scene& scene, std::vector<char> in_zone);

    /// Gamma: unknowns of the whole mesh that zone elements share with coarse ones or that are prescribed or reported,
    /// ascending.
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
    [[nodiscard]] bool is_far(int element) const {
        return in_zone_[static_cast<std::size_t>(element)] == 0 && is_near_[static_cast<std::size_t>(element)] == 0;
    }

    /// Unknowns that near elements see, and those of free_places(), which are the last, in their order. Prescribed ones
    /// are not among them.
    [[nodiscard]] std::span<const int> near_unknowns() const {
        return std::span(leaf_unknowns_).last(static_cast<std::size_t>(near_count_));
    }

    /// expand() on near elements alone: overwrites in `u` (of the whole mesh) what they see. Costs the near part of the
    /// factor.
    void expand_near(const Eigen::VectorXd& gamma_displacement, double load_factor, Eigen::VectorXd& u) const;

    /// What far elements resist with on near_unknowns(), given the displacement there of a state in equilibrium without
    /// load, N/mm: what near ones beside them push. Half its product with that displacement is the far energy.
    [[nodiscard]] Eigen::VectorXd far_force(const Eigen::VectorXd& near_displacement) const;

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const std::vector<char>& in_zone() const { return in_zone_; }
    [[nodiscard]] int unknowns() const { return static_cast<int>(leaf_unknowns_.size()); }
    [[nodiscard]] const StructureSeconds& seconds() const { return seconds_; }
    [[nodiscard]] double factor_entries() const { return leaf_->factor_entries(); }

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

    void make_enriched_operators();
    void keep_plain_operators();
    void number_unknowns();
    [[nodiscard]] IndexLists order_elimination();
    [[nodiscard]] Eigen::VectorXd load_of_imposed(const Eigen::VectorXd& imposed) const;
    [[nodiscard]] SparseMatrix assemble();
    void condense();
    void condense_readings();
    void number_near_unknowns(const IndexLists& of_elements);
    void find_rim(const IndexLists& of_elements, int first_near);
    void condense_energy(const Eigen::VectorXd& of_unit_load);
    [[nodiscard]] Controlled force_of(const Eigen::VectorXd& shares, const Eigen::VectorXd& gamma_held) const;

    const Scene& scene_;
    std::vector<char> in_zone_, is_near_;
    std::vector<int> near_elements_;
    bool mean_dilatation_;
    std::vector<ElementOperator> enriched_;  // of coarse elements that are not plain, ascending
    std::vector<PlainOperator> plain_;       // of near ones that are, ascending; empty: made on demand
    std::vector<int> plain_place_;           // per element: in plain_
    std::vector<int> supported_;             // coarse elements with a prescribed unknown
    std::vector<int> gamma_, free_places_;
    std::vector<int> leaf_unknowns_;                // whole-mesh unknown of each leaf unknown
    std::vector<int> leaf_index_;                   // and back; -1: prescribed or inside the zone
    int near_count_ = 0;                            // of the leaf's unknowns: the last ones
    std::vector<int> rim_elements_;                 // near ones beside far ones, ascending
    IndexLists rim_places_;                         // in near_unknowns(), of each of their unknowns; -1: prescribed
    std::vector<char> on_rim_;                      // per near unknown, 1 where far elements see it
    std::vector<PrescribedUnknown> near_supports_;  // that near elements see
    std::unique_ptr<SparseLeaf> leaf_;
    ReducedLoad reduced_;        // of the unit load factor
    Eigen::VectorXd near_load_;  // the near part of its interior
    Controlled mean_displacement_, holding_force_, load_displacement_, imposed_force_;
    double unit_energy_ = 0.0;  // twice the energy of the unit load factor with the free places held
    StructureSeconds seconds_;
    mutable std::vector<std::unique_ptr<RingForms>> rings_;  // per tip
};

template <class Visit> void Structure::visit_operator(int element, Visit&& visit) const {
    if (!plain_.empty() && plain_place_[static_cast<std::size_t>(element)] >= 0)
        visit(plain_[static_cast<std::size_t>(plain_place_[static_cast<std::size_t>(element)])]);
    else if (is_plain(scene_.enriched, element))
        visit(plain_operator(scene_.enriched, element, mean_dilatation_));
    else
        visit(*std::ranges::lower_bound(enriched_, element, {}, &ElementOperator::element));
}

template <class Visit> void Structure::for_each_coarse(Visit&& visit) const {
    auto enriched = enriched_.begin();
    for (int element = 0; element < static_cast<int>(in_zone_.size()); ++element) {
        if (in_zone_[static_cast<std::size_t>(element)] != 0) continue;
        if (is_plain(scene_.enriched, element))
            visit(element, std::span<const int>(plain_unknowns(scene_.enriched, element)));
        else
            visit(element, std::span<const int>((enriched++)->unknowns));
    }
}

template <class Visit> void Structure::for_each_operator(Visit&& visit) const {
    for (int element = 0; element < static_cast<int>(in_zone_.size()); ++element)
        if (in_zone_[static_cast<std::size_t>(element)] == 0) visit_operator(element, visit);
}

}  // namespace stria::coarse
