// The coarse component's elements: linear elastic, never subdivided, condensed once onto the boundary of the zone.
#pragma once

#include <memory>
#include <vector>

#include "coarse/scene.hpp"
#include "common/fem/domain_integral.hpp"
#include "common/fem/element_operator.hpp"
#include "common/linear/sparse_leaf.hpp"

namespace stria::coarse {

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

    /// All unknowns of the whole mesh that coarse elements see, given the displacement of gamma(); others are zero.
    [[nodiscard]] Eigen::VectorXd expand(const Eigen::VectorXd& gamma_displacement, double load_factor) const;

    [[nodiscard]] const Scene& scene() const { return scene_; }
    [[nodiscard]] const std::vector<ElementOperator>& operators() const { return operators_; }
    [[nodiscard]] const std::vector<char>& in_zone() const { return in_zone_; }
    [[nodiscard]] int unknowns() const { return static_cast<int>(leaf_unknowns_.size()); }
    [[nodiscard]] double factor_entries() const { return leaf_->factor_entries(); }

    /// Elements (of the whole mesh) whose von Mises stress exceeds a limit at some point, inserts left out.
    [[nodiscard]] std::vector<int> elements_beyond(double stress, const Eigen::VectorXd& u) const;

    /// Elastic domain integrals over the coarse part of a ring; q: one value a node of the whole mesh.
    [[nodiscard]] DomainIntegral ring_integral(const Tip& tip, const Eigen::VectorXd& q, const Eigen::VectorXd& u,
                                               bool want_J, bool want_K) const;

    /// Internal force of the coarse elements on the prescribed unknowns of the scene, N/mm, in their order.
    [[nodiscard]] Eigen::VectorXd forces_on_prescribed(const Eigen::VectorXd& u) const;

    /// Internal force of the coarse elements on all unknowns of the whole mesh, from stresses: no rounding of K u where
    /// u is mostly rigid motion, N/mm.
    [[nodiscard]] Eigen::VectorXd internal_force(const Eigen::VectorXd& u) const;

    /// The stiffness of the coarse elements over all unknowns of the whole mesh (the monolithic yardstick).
    [[nodiscard]] SparseMatrix stiffness() const;

private:
    void number_unknowns();
    void condense();

    const Scene& scene_;
    std::vector<char> in_zone_;
    std::vector<ElementOperator> operators_;  // of coarse elements
    std::vector<int> gamma_, free_places_;
    std::vector<int> leaf_unknowns_;  // whole-mesh unknown of each leaf unknown
    std::vector<int> leaf_index_;     // and back; -1: prescribed or inside the zone
    std::unique_ptr<SparseLeaf> leaf_;
    ReducedLoad reduced_;  // of the unit load factor
};

}  // namespace stria::coarse
