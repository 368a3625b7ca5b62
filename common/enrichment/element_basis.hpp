// Eq. (1) on one element: values and gradients of its functions, standard and enriched. The only place that evaluates
// them.
#pragma once

#include <vector>

#include "common/enrichment/enriched_mesh.hpp"
#include "common/fem/shape_q4.hpp"

namespace stria {

/// Values and gradients of an element's functions at a point: one row per function.
struct BasisValues {
    Eigen::VectorXd value;
    Eigen::Matrix<double, Eigen::Dynamic, 2> gradient;  // 1/mm
};

class ElementBasis {
public:
    /// Functions that vanish on the whole element (Heaviside terms of nodes whose side the element shares) are left
    /// out.
    ElementBasis(const EnrichedMesh& mesh, int element, bool cut);

    [[nodiscard]] int functions() const { return static_cast<int>(unknowns_.size()) / 2; }

    /// Unknowns of the element: 2 a function, component fastest.
    [[nodiscard]] const std::vector<int>& unknowns() const { return unknowns_; }

    [[nodiscard]] const std::array<Vec2, 4>& corners() const { return corners_; }

    /// Any function beyond those of plain corners.
    [[nodiscard]] bool enriched() const { return functions() > 4 || ties_.size() > 0; }

    /// Any tip function.
    [[nodiscard]] bool singular() const { return singular_; }

    /// At the physical point x with parent coordinates xi; `side`: of the crack in a cut element, else ignored.
    void evaluate(const Vec2& xi, const Vec2& x, int side, BasisValues& out) const;

private:
    struct Function {
        int corner;
        int term_index;  // of the corner's node; 0: standard
        Term term;
    };
    /// Functions of one tip that all nodes of its disk share.
    struct Gathered {
        int tip;
        int functions;
        Eigen::Vector4d inside;                                 // 1 at corners within the disk, else 0
        std::array<Eigen::Matrix<double, 4, 6>, 2> at_corners;  // psi seen from the minus and from the plus side
    };
    void add_corner(int corner, bool cut);
    void gather_tip(int tip, int functions);
    void number_functions();
    void add_gathered(const ShapeQ4& shape, const Vec2& x, int side, BasisValues& out) const;

    const EnrichedMesh* mesh_;
    std::array<Vec2, 4> corners_;
    std::array<int, 4> nodes_;
    std::vector<Function> functions_;
    std::vector<Gathered> gathered_;
    Eigen::MatrixXd ties_;  // with hanging corners: what each unknown has of each function; else empty
    std::vector<int> unknowns_;
    int own_side_;  // of an uncut element that touches the crack
    int tip_side_;  // of an uncut element with a node beside the crack: chooses the branch of theta
    bool singular_ = false;
};

}  // namespace stria
