// How well conditioned the structure's equations are.
#pragma once

#include <Eigen/SparseCholesky>

#include "common/index.hpp"
#include "tests/support/elastic_scene.hpp"

namespace stria::test {

/// Of a symmetric matrix without the rows and columns that are held, every diagonal entry scaled to 1: largest over
/// smallest eigenvalue, by `iterations` power iterations (some percent too small: the largest eigenvalues lie close
/// together).
inline double condition_number(const SparseMatrix& whole, const UnknownSet& held, int iterations) {
    const Eigen::VectorXd scale = whole.diagonal().cwiseSqrt().cwiseInverse();
    std::vector<Triplet> entries;
    entries.reserve(at(whole.nonZeros()));
    for (int j = 0; j < whole.outerSize(); ++j) {
        for (SparseMatrix::InnerIterator entry(whole, j); entry; ++entry) {
            const auto i = static_cast<int>(entry.row());
            if (!held.contains(i) && !held.contains(j)) entries.emplace_back(i, j, entry.value() * scale[i] * scale[j]);
            if (i == j && held.contains(i)) entries.emplace_back(i, i, 1.0);
        }
    }
    SparseMatrix K(whole.rows(), whole.cols());
    K.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<SparseMatrix> factor(K);
    Eigen::VectorXd large = Eigen::VectorXd::Random(K.rows()), small = large;
    double largest = 0.0, smallest = 0.0;
    for (int k = 0; k < iterations; ++k) {
        large = K * large.normalized();
        small = factor.solve(small.normalized());
        largest = large.norm();
        smallest = 1.0 / small.norm();
    }
    return largest / smallest;
}

/// Of the free unknowns' stiffness.
inline double condition_number(const coarse::Structure& structure, int iterations = 60) {
    const coarse::Scene& scene = structure.scene();
    const UnknownSet held = coarse::prescribed_among(scene.enriched.unknowns, scene.prescribed);
    return condition_number(structure.elements().stiffness(), held, iterations);
}

}  // namespace stria::test
