// Elements of a structure that are condensed onto their rim, which is what they share with others. Neither a growing
// crack nor a moving zone changes them, so the part serves one structure after another. The far elements are such a
// part. Nearer ones lie on top of it and hold its rim (near_elements.hpp).
#pragma once

#include <memory>
#include <vector>

#include "coarse/elements/scene_elements.hpp"
#include "common/index_lists.hpp"
#include "common/index_set.hpp"
#include "common/substructure/stacked_leaf.hpp"

namespace stria::coarse {

/// Seconds that a structure took to make.
struct StructureSeconds {
    double assembly = 0.0;  // numbering and stiffness
    double ordering = 0.0;  // of the elimination
    double factor = 0.0;    // analysis, factor, condensed tangent and load
};

/// It depends on the mesh, the supports, the choice of elements and the part below alone: whoever makes it gets the
/// same bits.
class BodyPart : public Substructure {
public:
    /// `elements`: of no tip's functions. `below`: the part that it lies on, which has other elements; may be null.
    BodyPart(const Scene& scene, ElementSet elements, std::shared_ptr<const BodyPart> below, StructureSeconds& seconds);

    /// Its own elements are those, on its mesh or on one with others of its elements split, and it lies on that part.
    [[nodiscard]] bool is_of(const ElementSet& elements, const BodyPart* below) const;

    /// Of its own elements, and of these or those of the parts below.
    [[nodiscard]] bool contains(int element) const { return elements_.holds(element); }

    [[nodiscard]] bool holds(int element) const { return contains(element) || (below_ && below_->holds(element)); }

    /// Unknowns of the mesh in the order of elimination: those that only its own elements and the part below see, and
    /// those of the rim, which ascend. None is prescribed. On a mesh on which the elements have the same functions.
    [[nodiscard]] std::vector<int> inner(const EnrichedMesh& mesh) const { return unknowns_of(mesh, inner_); }
    [[nodiscard]] std::vector<int> rim(const EnrichedMesh& mesh) const { return unknowns_of(mesh, rim_); }
    /// How many unknowns inner() has.
    [[nodiscard]] int inner_count() const { return static_cast<int>(inner_.size()); }

    /// Unknowns of loads and answers: the inner ones of the part below, its own, the rim.
    [[nodiscard]] const Eigen::MatrixXd& tangent() const override { return leaf_->tangent(); }
    [[nodiscard]] ReducedLoad reduce(const Eigen::VectorXd& load) const override { return leaf_->reduce(load); }
    [[nodiscard]] Eigen::VectorXd reduce_interior(const ConstPart& load, Part reduced) const override {
        return leaf_->reduce_interior(load, reduced);
    }
    [[nodiscard]] Eigen::VectorXd expand(const ReducedLoad& load, const Eigen::VectorXd& rim) const override {
        return leaf_->expand(load, rim);
    }
    /// Its own inner unknowns and the rim. `load`: what of ReducedLoad::interior belongs to the own ones.
    [[nodiscard]] Eigen::VectorXd expand_own(const Eigen::VectorXd& load, const Eigen::VectorXd& rim) const {
        return leaf_->expand_above(load, rim);
    }
    /// Of that answer, what lies on the rim of the part below.
    [[nodiscard]] Eigen::VectorXd on_rim_below(const Eigen::VectorXd& own) const { return leaf_->on_rim(own); }
    /// Of its own factor.
    [[nodiscard]] double factor_entries() const { return factor_entries_; }

private:
    struct Place {
        int node, term, component;  // EnrichedMesh::unknown()
        bool operator==(const Place&) const = default;
    };
    [[nodiscard]] static std::vector<int> unknowns_of(const EnrichedMesh& mesh, const std::vector<Place>& places);
    [[nodiscard]] std::vector<int> number(const SceneElements& all);
    [[nodiscard]] IndexLists order_elimination(const SceneElements& all);
    [[nodiscard]] SparseMatrix assemble(const SceneElements& all, const IndexLists& of_elements,
                                        StructureSeconds& seconds) const;

    ElementSet elements_;
    std::shared_ptr<const BodyPart> below_;
    std::vector<Place> inner_, rim_;
    std::unique_ptr<const StackedLeaf> leaf_;
    double factor_entries_ = 0.0;
};

}  // namespace stria::coarse
