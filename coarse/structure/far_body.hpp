// The far elements of a structure, condensed onto the rim. The rim is what they share with near elements. They are most
// of the body, and neither a growing crack nor a moving zone changes them.
#pragma once

#include <memory>
#include <vector>

#include "coarse/model/scene.hpp"
#include "common/index_lists.hpp"
#include "common/index_set.hpp"
#include "common/substructure/sparse_leaf.hpp"
#include "common/substructure/substructure.hpp"

namespace stria::coarse {

/// Seconds that a structure took to make.
struct StructureSeconds {
    double assembly = 0.0;  // numbering and stiffness
    double ordering = 0.0;  // of the elimination
    double factor = 0.0;    // analysis, factor, condensed tangent and load
};

/// It depends on the mesh, the supports and the choice of elements alone: whoever makes it gets the same bits.
class FarBody : public Substructure {
public:
    /// `far`: its elements (near_elements.hpp). All of them are plain.
    FarBody(const Scene& scene, ElementSet far, StructureSeconds& seconds);

    /// Its elements are those, on its mesh or on one with others of its elements split.
    [[nodiscard]] bool is_of(const ElementSet& far) const { return far_.members() == far.members(); }
    [[nodiscard]] bool contains(int element) const { return element < far_.size() && far_.contains(element); }

    /// Unknowns of the mesh in the order of elimination: those that only far elements see, and those of the rim, which
    /// ascend. All are standard unknowns, and none is prescribed.
    [[nodiscard]] std::vector<int> inner(const EnrichedMesh& mesh) const { return unknowns_of(mesh, inner_); }
    [[nodiscard]] std::vector<int> rim(const EnrichedMesh& mesh) const { return unknowns_of(mesh, rim_); }

    [[nodiscard]] const Eigen::MatrixXd& tangent() const override { return leaf_->tangent(); }
    /// Remembers its last answers, because one structure after another asks for the same loads.
    [[nodiscard]] ReducedLoad reduce(const Eigen::VectorXd& load) const override;
    [[nodiscard]] Eigen::VectorXd expand(const ReducedLoad& load, const Eigen::VectorXd& rim) const override {
        return leaf_->expand(load, rim);
    }
    [[nodiscard]] double factor_entries() const { return leaf_->factor_entries(); }

private:
    struct Place {
        int node, component;
    };
    [[nodiscard]] static std::vector<int> unknowns_of(const EnrichedMesh& mesh, const std::vector<Place>& places);
    [[nodiscard]] std::vector<int> number(const Scene& scene);
    [[nodiscard]] IndexLists order_elimination(const Scene& scene);
    [[nodiscard]] SparseMatrix assemble(const Scene& scene, const IndexLists& of_elements,
                                        StructureSeconds& seconds) const;

    ElementSet far_;
    std::vector<Place> inner_, rim_;
    std::unique_ptr<const SparseLeaf> leaf_;
    struct Answer {
        Eigen::VectorXd load;
        ReducedLoad reduced;
    };
    mutable std::vector<Answer> answers_;
};

}  // namespace stria::coarse
