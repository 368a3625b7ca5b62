// A linear elastic structure as a leaf of the tree of substructures: condensed once by a supernodal Cholesky factor
// with the boundary ordered last; S is its trailing block (docs/method.md, section 10).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "common/linear/sparse.hpp"
#include "common/substructure/substructure.hpp"

namespace stria {

/// Whether a leaf remembers its last answers, because one structure after another asks it for the same loads.
enum class Answers : std::uint8_t { Anew, Remembered };

class SparseLeaf : public Substructure {
public:
    /// `stiffness`: symmetric, its lower triangle is read, unknowns 0..n-1. `boundary`: the unknowns to keep, may be
    /// empty. A body that floats on its boundary is allowed (S is then singular, exactly). Throws NumericalFailure
    /// where K_ii is not positive definite.
    SparseLeaf(const SparseMatrix& stiffness, const std::vector<int>& boundary);

    /// Of a lower triangle whose unknowns are numbered in a good order of elimination, the last `boundary` ones to
    /// keep: for large structures (nested_dissection.hpp). Spoils `lower`.
    SparseLeaf(int boundary, SparseMatrix&& lower, Answers answers = Answers::Anew);
    ~SparseLeaf() override;

    [[nodiscard]] const Eigen::MatrixXd& tangent() const override;
    [[nodiscard]] ReducedLoad reduce(const Eigen::VectorXd& load) const override;
    [[nodiscard]] Eigen::VectorXd reduce_interior(const ConstPart& load, Part reduced) const override;
    [[nodiscard]] Eigen::VectorXd expand(const ReducedLoad& load, const Eigen::VectorXd& boundary) const override;

    /// The last unknowns of expand() in the order of elimination, the boundary after them: reads their columns of the
    /// factor and no others. `last_of_load`: the end of ReducedLoad::interior, as long as there are unknowns wanted.
    [[nodiscard]] Eigen::VectorXd expand_last(const Eigen::VectorXd& last_of_load,
                                              const Eigen::VectorXd& boundary) const;

    /// The boundary's included.
    [[nodiscard]] int unknowns() const;

    /// Entries in the Cholesky factor.
    [[nodiscard]] double factor_entries() const;

private:
    void condense(SparseMatrix& lower);
    [[nodiscard]] ReducedLoad reduce_anew(const Eigen::VectorXd& load) const;

    struct Factor;  // CHOLMOD stays behind this door
    std::unique_ptr<Factor> factor_;
    Eigen::MatrixXd tangent_;
    struct Answer {
        Eigen::VectorXd load;
        ReducedLoad reduced;
    };
    Answers kind_ = Answers::Anew;
    mutable std::vector<Answer> answers_;
};

}  // namespace stria
