// The merge above several fine ranks (docs/architecture.md): a tree of fronts whose elements are the ranks' condensed
// tangents. It eliminates the seams onto Gamma.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "common/substructure/front_tree.hpp"
#include "coupling/ranks/divided_patch.hpp"

namespace stria::coupling {

/// Vectors are in the order of Seams::kept unless they say Gamma.
class SeamTree {
public:
    SeamTree(const EnrichedMesh& zone, const std::vector<RankPart>& parts, const Seams& seams);

    /// `tangent`: of a part, on its shared unknowns, N/mm per mm.
    void set_tangent(std::size_t part, CondensedTangent tangent);

    /// Factors anew what set_tangent has changed; false where there was nothing. Throws NumericalFailure.
    bool factor();

    /// The zone's tangent on Gamma.
    [[nodiscard]] CondensedTangent tangent() const { return {tree_->lower_tangent(), tree_->symmetry()}; }

    /// Condenses what is out of balance on the kept unknowns, and their load per unit load factor, N/mm.
    void reduce(const Eigen::VectorXd& load, const Eigen::VectorXd& unit_load);

    /// The condensed loads on Gamma.
    [[nodiscard]] const Eigen::VectorXd& load() const { return load_.boundary; }
    [[nodiscard]] const Eigen::VectorXd& unit_load() const { return unit_load_.boundary; }

    /// How the kept unknowns move, mm, where Gamma moves by `step` and the load factor changes by `load_step`.
    [[nodiscard]] Eigen::VectorXd follow(const Eigen::VectorXd& step, double load_step) const;

private:
    void mirror_where_read();

    std::unique_ptr<FrontTree> tree_;
    std::vector<CondensedTangent> tangents_;  // per part
    std::vector<char> changed_;               // per part: since the last factor
    ReducedLoad load_, unit_load_;
};

}  // namespace stria::coupling
