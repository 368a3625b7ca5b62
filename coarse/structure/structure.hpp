// The coarse component: linear elastic elements that are never subdivided, condensed onto Gamma, the boundary of the
// zone. Far elements are condensed first, those of the middle on top of them, each once for many structures; the core
// comes last.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "coarse/elements/coarse_elements.hpp"
#include "coarse/elements/near_elements.hpp"
#include "coarse/structure/body_part.hpp"
#include "coarse/structure/condensed_loads.hpp"
#include "coarse/structure/core_factor.hpp"
#include "coarse/structure/far_displacement.hpp"
#include "coarse/structure/leaf_numbering.hpp"
#include "common/substructure/stacked_leaf.hpp"

namespace stria::coarse {

/// What one structure leaves to the next.
struct StructureFactors {
    std::shared_ptr<const BodyPart> far, middle, behind;  // null: no element is there
    std::shared_ptr<const CoreFactor> core;
};

class Structure {
public:
    /// `in_zone`: elements that the fine component owns; all others are coarse. `known`: factors that may serve again;
    /// they do where they are those of this structure to the last bit. `scene` must outlive the structure. Throws
    /// NumericalFailure where the structure moves freely.
    Structure(const Scene& scene, ElementSet in_zone, const StillElements& still, StructureFactors known = {});

    /// With the far elements that near_elements.hpp chooses.
    Structure(const Scene& scene, const ElementSet& in_zone)
        : Structure(scene, in_zone, {.far = far_elements(scene, in_zone), .middle = {}}) {}

    /// Of a body without a zone.
    explicit Structure(const Scene& scene) : Structure(scene, ElementSet(scene.mesh->elements.size())) {}

    [[nodiscard]] const Scene& scene() const { return elements_.scene(); }
    [[nodiscard]] const CoarseElements& elements() const { return elements_; }
    [[nodiscard]] const ElementSet& in_zone() const { return elements_.in_zone(); }
    [[nodiscard]] bool is_far(int element) const { return far_ && far_->contains(element); }
    [[nodiscard]] bool is_in_middle(int element) const { return middle_ && middle_->contains(element); }
    [[nodiscard]] StructureFactors factors() const { return {far_, middle_, behind_, core_}; }

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
                     Eigen::VectorXd& u) const {
        expand_below(expand_core(gamma_displacement, factors, initial, u), factors, initial, u);
    }

    /// The same on what elements of the core see, supports aside. Returns what lies on the rim below the core.
    Eigen::VectorXd expand_core(const Eigen::VectorXd& gamma_displacement, const LoadFactors& factors, double initial,
                                Eigen::VectorXd& u) const;

    /// On near elements at the load factor 1 of what has no zone, mm, zero elsewhere: found when it is first asked for.
    /// `found`: counts that.
    [[nodiscard]] const Eigen::VectorXd& near_of_unit_load(std::int64_t& found) const;

    /// What the near displacement has besides: supports are put into `u` at once.
    [[nodiscard]] std::shared_ptr<const FarDisplacement> beside_near(const LoadFactors& factors, double initial,
                                                                     Eigen::VectorXd& u) const;

    /// Unknowns that near elements see, free_places() last, and those that the core does: the last of them. Prescribed
    /// ones are not among them.
    [[nodiscard]] std::span<const int> near_unknowns() const { return numbering_.near_unknowns(); }
    [[nodiscard]] std::span<const int> core_unknowns() const { return numbering_.core_unknowns(); }

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
    [[nodiscard]] const std::shared_ptr<const BodyPart>& below_behind() const { return middle_ ? middle_ : far_; }
    [[nodiscard]] const std::shared_ptr<const BodyPart>& below() const { return behind_ ? behind_ : below_behind(); }
    [[nodiscard]] std::shared_ptr<const CoreFactor> factor(std::shared_ptr<const CoreFactor> known);
    void find_near_supports();
    void expand_below(Eigen::VectorXd on_rim, const LoadFactors& factors, double initial, Eigen::VectorXd& u) const;
    /// Of the load on what lies inside the structure, so much from there on.
    [[nodiscard]] Eigen::VectorXd interior_load(const LoadFactors& factors, double initial, Eigen::Index from,
                                                Eigen::Index count) const;

    StructureSeconds seconds_;
    std::shared_ptr<const BodyPart> far_, middle_, behind_;
    CoarseElements elements_;
    LeafNumbering numbering_;
    std::shared_ptr<const CoreFactor> core_;
    StackedLeaf leaf_;
    CondensedLoads loads_;
    std::vector<PrescribedUnknown> near_supports_;  // that near elements see
    mutable std::optional<Eigen::VectorXd> near_of_unit_load_;
};

}  // namespace stria::coarse
