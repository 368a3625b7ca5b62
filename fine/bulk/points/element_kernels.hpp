// Strains, forces and tangents of one element from its points, compiled for the four functions of a plain element, the
// eight of one of which every corner jumps, and any number. Fields are stored component by component with `stride`,
// those of the element from their pointer on.
#pragma once

#include "common/fem/strain_operator.hpp"
#include "common/index.hpp"
#include "common/integration/element_operator.hpp"

namespace stria::fine {

template <int functions> class ElementKernel {
public:
    using Nodal = Eigen::Matrix<double, 2, functions>;
    static constexpr int unknowns = functions == Eigen::Dynamic ? Eigen::Dynamic : 2 * functions;
    using Matrix = Eigen::Matrix<double, unknowns, unknowns>;

    explicit ElementKernel(const ElementOperator& op) : op_(op), count_(std::ssize(op.unknowns) / 2) {}

    /// Of a displacement of all unknowns, one column a function.
    [[nodiscard]] Nodal gather(const Eigen::VectorXd& u) const {
        Nodal nodal(2, count_);
        for (std::size_t k = 0; k < op_.unknowns.size(); ++k) nodal.data()[k] = u[op_.unknowns[k]];
        return nodal;
    }

    /// From 2f numbers in the order of the element's unknowns.
    [[nodiscard]] auto nodal(const double* values) const { return Eigen::Map<const Nodal>(values, 2, count_); }

    [[nodiscard]] Mandel strain(const Nodal& nodal, std::size_t q) const {
        return with_mean(q, [&](const Gradient& g, const Gradient* mean) { return strain_at(nodal, g, mean); });
    }

    /// Row: component.
    [[nodiscard]] Eigen::Matrix2d displacement_gradient(const Nodal& nodal, std::size_t q) const {
        return nodal * Gradient(op_.gradients[q].data(), count_, 2);
    }

    /// 4 components a point.
    void write_strains(const Nodal& nodal, double* strains, std::ptrdiff_t stride) const {
        for (std::size_t q = 0; q < op_.points.size(); ++q) {
            const Mandel value = strain(nodal, q);
            for (int c = 0; c < 4; ++c) strains[c * stride + static_cast<std::ptrdiff_t>(q)] = value[c];
        }
    }

    /// Of a displacement increment.
    [[nodiscard]] Nodal elastic_force(const Eigen::MatrixXd& stiffness, const Nodal& nodal) const {
        Nodal force(2, count_);
        const Eigen::Map<const Matrix> K(stiffness.data(), 2 * count_, 2 * count_);
        Eigen::Map<Eigen::Matrix<double, unknowns, 1>>(force.data(), 2 * count_).noalias() =
            K.lazyProduct(Eigen::Map<const Eigen::Matrix<double, unknowns, 1>>(nodal.data(), 2 * count_));
        return force;
    }

    [[nodiscard]] Nodal force(const double* stress, std::ptrdiff_t stride) const {
        Nodal force = Nodal::Zero(2, count_);
        for (std::size_t q = 0; q < op_.points.size(); ++q) {
            const double* s = stress + q;
            const Mandel value(s[0], s[stride], s[2 * stride], s[3 * stride]);
            with_mean(q, [&](const Gradient& g, const Gradient* mean) {
                add_force_at(value, op_.points[q].weight, g, mean, force);
            });
        }
        return force;
    }

    /// B at point q.
    [[nodiscard]] Eigen::Matrix<double, 4, unknowns> strain_matrix(std::size_t q) const {
        Eigen::Matrix<double, 4, unknowns> B(4, 2 * count_);
        with_mean(q, [&](const Gradient& g, const Gradient* mean) { fill_strain_matrix(g, mean, B); });
        return B;
    }

    /// Adds weight * B^T D B at point q.
    void add_stiffness(const MandelMatrix& D, std::size_t q, Matrix& K) const {
        const Eigen::Matrix<double, 4, unknowns> B = strain_matrix(q);
        const Eigen::Matrix<double, 4, unknowns> stress = op_.points[q].weight * D * B;
        K.noalias() += B.transpose().lazyProduct(stress);
    }

private:
    using Gradient = Eigen::Map<const Eigen::Matrix<double, functions, 2>>;

    /// Calls visit(gradients, their mean or null) of point q.
    template <class Visit> decltype(auto) with_mean(std::size_t q, Visit&& visit) const {
        const Gradient g(op_.gradients[q].data(), count_, 2);
        if (op_.mean.empty()) return visit(g, static_cast<const Gradient*>(nullptr));
        const Gradient mean(op_.mean[at(op_.points[q].region)].data(), count_, 2);
        return visit(g, &mean);
    }

    const ElementOperator& op_;
    Eigen::Index count_;
};

/// Calls visit(kernel) with the kernel that fits the element.
template <class Visit> void with_kernel(const ElementOperator& op, Visit&& visit) {
    if (op.unknowns.size() == 8)
        visit(ElementKernel<4>(op));
    else if (op.unknowns.size() == 16)
        visit(ElementKernel<8>(op));
    else
        visit(ElementKernel<Eigen::Dynamic>(op));
}

}  // namespace stria::fine
