// docs/method.md, section 1: a substructure owns elements and interior unknowns, offers its condensed tangent on its
// boundary, carries loads to the boundary, and recovers its interior when asked. Implementations: SparseLeaf,
// FrontTree.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <utility>

namespace stria {

/// Stated by who makes a matrix, not found by looking at its numbers: Armstrong-Frederick tangents and faces that slide
/// make a general one, and so is all that has one of them below it.
enum class Symmetry : std::uint8_t { Symmetric, General };

/// A condensed tangent as it is handed on. Of a symmetric one the lower triangle counts: what stands above it is not
/// told.
struct CondensedTangent {
    Eigen::MatrixXd matrix;
    Symmetry symmetry = Symmetry::Symmetric;

    [[nodiscard]] Eigen::VectorXd column(Eigen::Index j) const {
        Eigen::VectorXd column = matrix.col(j);
        if (symmetry == Symmetry::Symmetric) column.head(j) = matrix.row(j).head(j).transpose();
        return column;
    }
};

/// A load b carried to the boundary: boundary = b_b - K_bi K_ii^-1 b_i; interior: what expand() needs again.
struct ReducedLoad {
    Eigen::VectorXd interior;
    Eigen::VectorXd boundary;
};

class Substructure {
public:
    Substructure() = default;
    Substructure(const Substructure&) = delete;
    Substructure& operator=(const Substructure&) = delete;
    virtual ~Substructure() = default;

    /// Condensed tangent S = K_bb - K_bi K_ii^-1 K_ib, boundary unknowns in the order given at construction.
    [[nodiscard]] virtual const Eigen::MatrixXd& tangent() const = 0;

    /// Carries a load on all unknowns to the boundary.
    [[nodiscard]] virtual ReducedLoad reduce(const Eigen::VectorXd& load) const = 0;

    using Part = Eigen::Ref<Eigen::VectorXd>;
    using ConstPart = Eigen::Ref<const Eigen::VectorXd>;

    /// The same of a load on the interior alone. Puts what reduce() gives as interior into `reduced`, and returns what
    /// comes to the boundary.
    [[nodiscard]] virtual Eigen::VectorXd reduce_interior(const ConstPart& load, Part reduced) const {
        Eigen::VectorXd all = Eigen::VectorXd::Zero(load.size() + tangent().rows());
        all.head(load.size()) = load;
        ReducedLoad found = reduce(all);
        reduced = found.interior;
        return std::move(found.boundary);
    }

    /// All unknowns x of K x = load, given those on the boundary.
    [[nodiscard]] virtual Eigen::VectorXd expand(const ReducedLoad& load, const Eigen::VectorXd& boundary) const = 0;
};

}  // namespace stria
