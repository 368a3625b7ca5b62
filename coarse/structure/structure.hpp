// The coarse component: linear elastic elements that are never subdivided, condensed onto Gamma, the boundary of the
// zone. The far elements are condensed first, once for many structures; the near ones come on top of them.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "coarse/elements/coarse_elements.hpp"
#include "coarse/elements/near_elements.hpp"
#include "coarse/structure/condensed_loads.hpp"
#include "coarse/structure/far_body.hpp"
#include "coarse/structure/leaf_numbering.hpp"
#include "coarse/structure/near_factor.hpp"
#include "common/substructure/stacked_leaf.hpp"

namespace stria::coarse {

/// What one structure leaves to the next.
struct StructureFactors {
    std::shared_ptr<const FarBody> far;  // null: no element is far
    std::shared_ptr<const NearFactor> near;
};

class Structure {
public:
    /// `in_zone`: elements that the fine component owns; all others are coarse. `far`: coarse elements that no
    /// increment visits. `known`: factors that may serve again; they do where they are those of this structure to the
    /// last bit. `scene` must outlive the structure. Throws NumericalFailure where the structure moves freely.
    Structure(const Scene& scene, ElementSet in_zone, const ElementSet& far, StructureFactors known = {});

    /// With the far elements that near_elements.hpp chooses.
    Structure(const Scene& scene, const ElementSet& in_zone)
        : Structure(scene, in_zone, far_elements(scene, in_zone)) {}

    /// Of a body without a zone.
    explicit Structure(const Scene& scene) : Structure(scene, ElementSet(scene.mesh.elements.size())) {}

    [[nodiscard]] const Scene& scene() const { return elements_.scene(); }
    [[nodiscard]] const CoarseElements& elements() const { return elements_; }
    [[nodiscard]] const ElementSet& in_zone() const { return elements_.in_zone(); }
    [[nodiscard]] bool is_far(int element) const { return far_ && far_->contains(element); }
    [[nodiscard]] StructureFactors factors() const { return {far_, near_}; }

    /// Gamma (gamma.hpp): unknowns of the whole mesh, ascending.
    [[nodiscard]] const std::vector<int>& gamma() const { return numbering_.gamma(); }

    /// Places in gamma() that are not prescribed, ascending: the unknowns of the condensed system.
    [[nodiscard]] const std::vector<int>& free_places() const { return numbering_.free_places(); }

    /// Of values on gamma(), those on the free places.
    [[nodiscard]] Eigen::VectorXd on_free_places(const Eigen::VectorXd& gamma_values) const;

    /// Condensed tangent on the free places, square, MPa. The structure pushes the zone with
    /// boundary_load(factors) - tangent * u, N/mm.
    [[nodiscard]] const Eigen::MatrixXd& tangent() const { return leaf_.tangent(); }
    [[nodiscard]] const CondensedLoads& loads() const { return loads_; }
    /// On the free places, that of the initial stress included, N/mm.
    [[nodiscard]] Eigen::VectorXd boundary_load(const LoadFactors& factors) const;

    /// Displacement of the whole mesh, mm, given that of gamma(); zero where no coarse element sees it. `initial`:
    /// share of the initial stress; 0 for what is linear in the load, such as an increment.
    [[nodiscard]] Eigen::VectorXd expand(const Eigen::VectorXd& gamma_displacement, const LoadFactors& factors,
                                         double initial = 0.0) const;

    /// The same on near elements alone: overwrites in `u` (of the whole mesh) what they see. Visits no far element.
    void expand_near(const Eigen::VectorXd& gamma_displacement, const LoadFactors& factors, double initial,
                     Eigen::VectorXd& u) const;

    /// Unknowns that near elements see, free_places() last. Prescribed ones are not among them.
    [[nodiscard]] std::span<const int> near_unknowns() const { return numbering_.near_unknowns(); }

    /// Unknowns that near and far elements share, ascending. Together with the load factors their displacement
    /// determines that of all far elements.
    [[nodiscard]] const std::vector<int>& rim() const { return numbering_.rim(); }

    /// Force of the far elements on the rim, N/mm, at a displacement of the rim without load. Half their product is the
    /// energy of the far elements.
    [[nodiscard]] Eigen::VectorXd far_force(const Eigen::VectorXd& rim_displacement) const;

    /// Displacement of the whole mesh at the same state; zero where no far element sees it.
    [[nodiscard]] Eigen::VectorXd expand_far(const Eigen::VectorXd& rim_displacement) const;

    /// How many unknowns the structure has, those of free_places() included.
    [[nodiscard]] int unknowns() const { return numbering_.size(); }
    [[nodiscard]] const StructureSeconds& seconds() const { return seconds_; }
    [[nodiscard]] double factor_entries() const;

private:
    [[nodiscard]] std::shared_ptr<const NearFactor> factor(std::shared_ptr<const NearFactor> known);
    void find_near_supports();
    [[nodiscard]] ReducedLoad load_at(const LoadFactors& factors, double initial) const;

    StructureSeconds seconds_;
    std::shared_ptr<const FarBody> far_;
    CoarseElements elements_;
    LeafNumbering numbering_;
    std::shared_ptr<const NearFactor> near_;
    StackedLeaf leaf_;
    CondensedLoads loads_;
    std::vector<PrescribedUnknown> near_supports_;  // that near elements see
};

}  // namespace stria::coarse
