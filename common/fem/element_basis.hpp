// Eq. (1) on one element: values and gradients of its functions, standard and enriched. The only place that evaluates
// them.
#pragma once

#include <vector>

#include "common/fem/enriched_mesh.hpp"

namespace stria {

/// Values and gradients of an element's functions at a point: one row a function.
struct BasisValues {
    Eigen::VectorXd value;
    Eigen::Matrix<double, Eigen::Dynamic, 2> gradient;  // 1/mm
};

class ElementBasis {
public:
    /// Functions that vanish on the whole element (Heaviside terms of nodes whose side the element shares) are left
    /// out.
    ElementBasis(const EnrichedMesh& mesh, int element, bool cut);

    [[nodiscard]] int functions() const { return static_cast<int>(functions_.size()); }

    /// Unknowns of the element: 2 a function, component fastest.
    [[nodiscard]] const std::vector<int>& unknowns() const { return unknowns_; }

    [[nodiscard]] const std::array<Vec2, 4>& corners() const { return corners_; }

    /// Any function beyond the standard four.
    [[nodiscard]] bool enriched() const { return functions_.size() > 4; }

    /// Any tip function.
    [[nodiscard]] bool singular() const { return singular_; }

    /// At the physical point x with parent coordinates xi; `side`: of the crack in a cut element, else ignored.
    void evaluate(const Vec2& xi, const Vec2& x, int side, BasisValues& out) const;

private:
    struct Function {
        int corner;
        Term term;
        bool standard;
    };
    const EnrichedMesh* mesh_;
    std::array<Vec2, 4> corners_;
    std::vector<Function> functions_;
    std::vector<int> unknowns_;
    int own_side_;  // of an uncut element that touches the crack
    bool singular_ = false;
};

}  // namespace stria
