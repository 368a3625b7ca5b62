// The far elements of a structure, condensed onto the rim that they share with near ones: most of the body, of which
// cracks that grow and zones that move change nothing.
#pragma once

#include <memory>
#include <vector>

#include "coarse/model/scene.hpp"
#include "common/index_lists.hpp"
#include "common/substructure/sparse_leaf.hpp"
#include "common/substructure/substructure.hpp"

namespace stria::coarse {

/// Seconds that a structure took to make.
struct StructureSeconds {
    double assembly = 0.0;  // numbering and stiffness
    double ordering = 0.0;  // of the elimination
    double factor = 0.0;    // analysis, factor, condensed tangent and load
};

/// A function of the mesh, the supports and the choice of elements alone: to the last bit the same for whoever makes
/// it.
class FarBody : public Substructure {
public:
    /// `far`: per element, 1 where it is one of them (near_elements.hpp); all of them are plain.
    FarBody(const Scene& scene, std::vector<char> far, StructureSeconds& seconds);

    [[nodiscard]] const std::vector<char>& far() const { return far_; }

    /// Unknowns of a mesh, in the leaf's numbering: those that far elements alone see, and those of the rim; none that
    /// are prescribed. All are standard ones, and the rim's ascend.
    [[nodiscard]] std::vector<int> inner(const EnrichedMesh& mesh) const { return unknowns_of(mesh, inner_); }
    [[nodiscard]] std::vector<int> rim(const EnrichedMesh& mesh) const { return unknowns_of(mesh, rim_); }

    [[nodiscard]] const Eigen::MatrixXd& tangent() const override { return leaf_->tangent(); }
    /// Remembers its answers: structure after structure asks for the same loads.
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

    std::vector<char> far_;
    std::vector<Place> inner_, rim_;
    std::unique_ptr<const SparseLeaf> leaf_;
    struct Answer {
        Eigen::VectorXd load;
        ReducedLoad reduced;
    };
    mutable std::vector<Answer> answers_;
};

}  // namespace stria::coarse
