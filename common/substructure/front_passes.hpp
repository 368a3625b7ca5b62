// What one front of a tree does in a solution, on vectors by rank.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/index.hpp"
#include "common/substructure/assembly_tree.hpp"
#include "common/substructure/front.hpp"

namespace stria {

// Loops, where an indexed view of Eigen would copy its indices.

inline void gather_at(const std::vector<int>& places, const Eigen::VectorXd& all, Eigen::Ref<Eigen::VectorXd> some) {
    for (Eigen::Index k = 0; k < some.size(); ++k) some[k] = all[places[at(k)]];
}

inline void scatter_at(const std::vector<int>& places, const Eigen::Ref<const Eigen::VectorXd>& some,
                       Eigen::VectorXd& all) {
    for (Eigen::Index k = 0; k < some.size(); ++k) all[places[at(k)]] = some[k];
}

inline void add_at(const std::vector<int>& places, const Eigen::Ref<const Eigen::VectorXd>& some,
                   Eigen::VectorXd& all) {
    for (Eigen::Index k = 0; k < some.size(); ++k) all[places[at(k)]] += some[k];
}

/// `buffer`: as long as the widest node keeps, or longer.
inline void forward(const AssemblyTree::Node& node, const Front& front, Eigen::VectorXd& y, Eigen::VectorXd& buffer) {
    auto kept = buffer.head(std::ssize(node.kept));
    gather_at(node.kept, y, kept);
    front.forward(y.segment(node.first_rank, node.eliminated), kept);
    scatter_at(node.kept, kept, y);
}

inline void backward(const AssemblyTree::Node& node, const Front& front, Eigen::VectorXd& x, Eigen::VectorXd& buffer) {
    auto kept = buffer.head(std::ssize(node.kept));
    gather_at(node.kept, x, kept);
    front.backward(x.segment(node.first_rank, node.eliminated), kept);
}

}  // namespace stria
