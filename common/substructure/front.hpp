// A dense front: the unknowns of one node of the tree, those it eliminates first, then those it keeps; summed up from
// what lies below, partly factored, its Schur complement handed up.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "common/substructure/substructure.hpp"

namespace stria {

/// Where the rows of a contribution (a child's Schur complement, an element matrix) fall in a front, by runs of
/// neighbours that stay neighbours. Runs ascend in the front, so that lower triangles fall on lower triangles; none
/// holds both unknowns that the front eliminates and unknowns that it keeps.
struct Placement {
    struct Run {
        int source;
        int target;
        int length;
        bool operator==(const Run&) const = default;
    };
    int order = 0;  // rows of the contribution
    std::vector<Run> runs;
    bool operator==(const Placement&) const = default;
};

class Front {
public:
    /// `multipliers`: the last so many of the eliminated unknowns, whose pivots are negative.
    Front(int eliminated, int multipliers, int kept);

    /// To be summed up anew, from contributions that are all symmetric, or not.
    void clear(Symmetry symmetry);
    [[nodiscard]] Symmetry symmetry() const { return symmetry_; }

    /// Adds a square contribution, stored by columns. To a symmetric front: reads its entries of lower place only.
    void add(const Eigen::MatrixXd& contribution, const Placement& placement);

    /// Factors the eliminated block (L D L^T if symmetric, D one, and minus one for multipliers) and leaves the Schur
    /// complement (its lower triangle where symmetric). Returns the place of the first pivot that is not finite, or
    /// below `tolerance` of the scale of its row and column; else -1.
    [[nodiscard]] int eliminate(double tolerance);

    /// Fills the upper triangle of a symmetric Schur complement.
    void mirror();

    [[nodiscard]] const Eigen::MatrixXd& schur() const { return schur_; }

    using Vector = Eigen::Ref<Eigen::VectorXd>;
    using ConstVector = Eigen::Ref<const Eigen::VectorXd>;

    /// product = -(Schur complement) x.
    void minus_schur(const ConstVector& x, Vector product) const;

    /// own = L11^-1 P own, kept -= L21 own, then own = D own.
    void forward(Vector own, Vector kept) const;

    /// own = U11^-1 (own - U12 kept), where U = L^T if symmetric.
    void backward(Vector own, const ConstVector& kept) const;

private:
    [[nodiscard]] int eliminate_symmetric(double tolerance);
    [[nodiscard]] int eliminate_multipliers(double tolerance);
    [[nodiscard]] int eliminate_general(double tolerance);

    /// Scales columns, then rows, so that displacements beside pressures, whatever their units, have entries near 1.
    void measure_scales();

    /// Adds runs of one column of a contribution to column `target`, but for the first `above` rows of the first run.
    void add_column(const double* column, int target, std::span<const Placement::Run> rows, int above);

    /// Where an entry is stored; those below it follow as far as its block reaches.
    [[nodiscard]] double* entry(int row, int column);

    [[nodiscard]] bool symmetric() const { return symmetry_ == Symmetry::Symmetric; }

    Symmetry symmetry_ = Symmetry::Symmetric;
    int eliminated_;
    int multipliers_;
    int kept_;
    int stride_;                 // of panel_: LAPACK wants at least 1
    Eigen::MatrixXd panel_;      // columns of the eliminated unknowns, all rows: F11 over F21, then L11 (LU) over L21
    Eigen::MatrixXd upper_;      // general only: F12, then U12
    Eigen::MatrixXd schur_;      // F22, then F22 - F21 F11^-1 F12
    Eigen::VectorXd scale_;      // of each pivot before elimination: its diagonal entry; general: of its column
    Eigen::VectorXd row_scale_;  // general only: of rows, once columns are scaled
    std::vector<int> pivots_;    // general only: row interchanges
};

}  // namespace stria
