// The operator of an element that no crack enriches: four functions at 2 x 2 points, made on demand, nothing on the
// heap. It answers to the same names as ElementOperator.
#pragma once

#include <array>

#include "common/integration/element_operator.hpp"

namespace stria {

struct PlainOperator {
    using Values = Eigen::Matrix<double, 8, 1>;
    using Gradient = Eigen::Matrix<double, 4, 2>;

    int element = 0;
    std::array<int, 8> unknowns{};
    std::array<IntegrationPoint, 4> points{};
    std::array<Gradient, 4> gradients{};
    Gradient mean = Gradient::Zero();
    bool mean_dilatation = true;
    double area = 0.0;
    // Of the gradients one mode is left, the element's warping: gradients - mean = warp * a vector of each point.
    Eigen::Vector4d warp = Eigen::Vector4d::Zero();
    double largest_warp = 0.0;  // length of the longest of these vectors, 1/mm

    [[nodiscard]] Mandel strain(const Values& u, std::size_t q) const;
    [[nodiscard]] Mandel mean_strain(const Values& u) const;
    /// No point's strain is farther from mean_strain() than this.
    [[nodiscard]] double warping(const Values& u) const;
    [[nodiscard]] Eigen::Matrix2d displacement_gradient(const Values& u, std::size_t q) const;
    void add_force(const Mandel& stress, std::size_t q, Values& force) const;
    [[nodiscard]] Eigen::Matrix<double, 8, 8> stiffness(const MandelMatrix& elastic) const;
};

/// True where none of the element's nodes carries a term or hangs.
[[nodiscard]] bool is_plain(const EnrichedMesh& mesh, int element);

/// The two standard unknowns of each node.
[[nodiscard]] std::array<int, 8> plain_unknowns(const EnrichedMesh& mesh, int element);

/// Of a plain element.
PlainOperator plain_operator(const EnrichedMesh& mesh, int element, bool mean_dilatation);

PlainOperator::Values gather(const Eigen::VectorXd& values, const std::array<int, 8>& unknowns);

}  // namespace stria
