// What a FrontTree consists of, for those who factor it and those who let parts of it rest.
#pragma once

#include <utility>
#include <vector>

#include "common/index.hpp"
#include "common/substructure/assembly_tree.hpp"
#include "common/substructure/front.hpp"
#include "common/substructure/front_tree.hpp"

namespace stria {

struct FrontTree::Tree {
    enum class Rest : char { Awake, Leaf, Inside };

    explicit Tree(const Layout& layout);

    [[nodiscard]] Symmetry symmetry_below(const AssemblyTree::Node& node, const MatrixOfElement& matrix_of) const;
    void refactor(std::size_t index, const MatrixOfElement& matrix_of);
    /// Through one front, through those that are awake, or those that are not; vectors by rank.
    void forward(std::size_t index, Eigen::VectorXd& y, Eigen::VectorXd& buffer) const;
    void backward(Eigen::VectorXd& x, bool awake) const;
    void carry_through(std::size_t leaf, Eigen::VectorXd& scratch);
    /// Of the unknowns inside a subtree: where they begin by rank, and how many there are.
    [[nodiscard]] std::pair<Eigen::Index, Eigen::Index> inside_of(std::size_t index) const;
    [[noreturn]] void fail(const AssemblyTree::Node& node, int place) const;
    /// Numbers of all unknowns, turned into those by rank and back.
    [[nodiscard]] Eigen::VectorXd by_rank(const Eigen::VectorXd& by_unknown) const;
    [[nodiscard]] Eigen::VectorXd by_unknown(const Eigen::VectorXd& by_rank) const;

    std::size_t elements;
    AssemblyTree plan;
    std::vector<Front> fronts;
    std::vector<char> dirty;
    std::vector<Rest> rest;                // per node
    std::vector<std::size_t> first_below;  // per node: children come before parents, a subtree is a run of nodes
    ElementSet resting;
    UnknownSet inside;
    /// What a leaf at rest has made of the load inside it.
    struct Carried {
        bool known = false;
        Eigen::VectorXd up;  // onto what it keeps
    };
    std::vector<Carried> carried_by;               // per node
    Eigen::VectorXd carried, due, carried_inside;  // by rank: all together; the load as given; of leaves that are known
    bool factored = false, mirrored = false;
    long refactored = 0, refactored_general = 0, carried_through = 0;
    int widest = 0;  // most unknowns that a front keeps
};

// Loops, where an indexed view of Eigen would copy its indices.

inline void gather_at(const Eigen::VectorXd& all, const std::vector<int>& places, Eigen::Ref<Eigen::VectorXd> some) {
    for (Eigen::Index k = 0; k < some.size(); ++k) some[k] = all[places[at(k)]];
}

inline void scatter_at(const Eigen::Ref<const Eigen::VectorXd>& some, const std::vector<int>& places,
                       Eigen::VectorXd& all) {
    for (Eigen::Index k = 0; k < some.size(); ++k) all[places[at(k)]] = some[k];
}

inline void subtract_at(const Eigen::VectorXd& some, const std::vector<int>& places, Eigen::VectorXd& all) {
    for (Eigen::Index k = 0; k < some.size(); ++k) all[places[at(k)]] -= some[k];
}

}  // namespace stria
