// A small grid whose elements trees of fronts eliminate, beside dense algebra of the same.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "common/substructure/front_tree.hpp"

namespace stria::test {

/// nx x ny squares of four nodes with two unknowns each. Without ground the body is free to translate.
struct FrontGrid {
    FrontGrid(int nx_, int ny_, Symmetry symmetry_) : nx(nx_), ny(ny_), symmetry(symmetry_) {
        layout.unknowns = 2 * (nx + 1) * (ny + 1);
        for (int j = 0; j < ny; ++j) {
            for (int i = 0; i < nx; ++i) {
                std::vector<int> unknowns;
                for (const int node : {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}) {
                    unknowns.insert(unknowns.end(), {2 * node, 2 * node + 1});
                }
                layout.element_unknowns.push_back(unknowns);
                layout.centres.emplace_back(i + 0.5, j + 0.5);
                matrices.push_back(element_matrix());
            }
        }
        changed.assign(matrices.size(), 0);
    }

    [[nodiscard]] int at(int i, int j) const { return j * (nx + 1) + i; }

    void keep_outline() {
        for (int j = 0; j <= ny; ++j) {
            for (int i = 0; i <= nx; ++i) {
                if (i > 0 && i < nx && j > 0 && j < ny) continue;
                layout.boundary.insert(layout.boundary.begin(), {2 * at(i, j), 2 * at(i, j) + 1});
            }
        }
    }

    /// Differences between nodes are stiff, coupled between components; the unsymmetric part keeps translations free.
    Eigen::MatrixXd element_matrix() {
        const Eigen::MatrixXd differences = Eigen::MatrixXd::Identity(4, 4) - Eigen::MatrixXd::Constant(4, 4, 0.25);
        const auto uniform = [this] { return std::uniform_real_distribution<double>(-1.0, 1.0)(random); };
        const Eigen::MatrixXd any = Eigen::MatrixXd::NullaryExpr(8, 8, uniform);
        Eigen::MatrixXd project = Eigen::MatrixXd::Zero(8, 8);
        for (int a = 0; a < 4; ++a) {
            for (int b = 0; b < 4; ++b) project.block<2, 2>(2 * a, 2 * b).diagonal().setConstant(differences(a, b));
        }
        const bool symmetric = symmetry == Symmetry::Symmetric;
        const Eigen::MatrixXd core =
            any * any.transpose() + Eigen::MatrixXd::Identity(8, 8) + (symmetric ? 0.0 : 1.0) * (any - any.transpose());
        return project * core * project;
    }

    void ground() { matrices.front() += Eigen::MatrixXd::Identity(8, 8); }

    void change(std::size_t element) {
        matrices[element] *= 1.5;
        changed[element] = 1;
    }

    [[nodiscard]] Eigen::MatrixXd dense() const {
        Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(layout.unknowns, layout.unknowns);
        for (std::size_t e = 0; e < matrices.size(); ++e) {
            sum(layout.element_unknowns[e], layout.element_unknowns[e]) += matrices[e];
        }
        return sum;
    }

    [[nodiscard]] Eigen::MatrixXd dense_schur() const {
        const std::vector<int>& b = layout.boundary;
        std::vector<int> i;
        for (int unknown = 0; unknown < layout.unknowns; ++unknown) {
            if (std::ranges::find(b, unknown) == b.end()) i.push_back(unknown);
        }
        const Eigen::MatrixXd k = dense();
        const Eigen::MatrixXd inner = k(i, i), right = k(i, b);
        return k(b, b) - k(b, i) * inner.partialPivLu().solve(right);
    }

    int nx, ny;
    Symmetry symmetry;
    std::mt19937 random{7};
    FrontTree::Layout layout;
    std::vector<Eigen::MatrixXd> matrices;
    std::vector<char> changed;
};

/// Of tests of either kind.
inline std::string name_of_symmetry(const testing::TestParamInfo<Symmetry>& either) {
    return either.param == Symmetry::Symmetric ? "Symmetric" : "General";
}

}  // namespace stria::test
