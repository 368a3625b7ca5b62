// Subtrees that rest: each answers by its Schur complement, and what is inside follows.
#include <algorithm>
#include <utility>

#include "common/error.hpp"
#include "common/substructure/front_tree_parts.hpp"

namespace stria {

void FrontTree::rest(const ElementSet& may_rest) {
    Tree& tree = *tree_;
    require(tree.factored && at(may_rest.size()) == tree.elements,
            "front tree: factor() before rest(), a set of its elements");
    using Rest = Tree::Rest;
    tree.resting = ElementSet(tree.elements);
    tree.inside = UnknownSet(tree.plan.rank.size());
    std::vector<char> inside(tree.plan.rank.size(), 0);  // by rank
    for (std::size_t index = 0; index < tree.fronts.size(); ++index) {
        const AssemblyTree::Node& node = tree.plan.nodes[index];
        const auto rests = [&](int child) { return tree.rest[at(child)] != Rest::Awake; };
        const auto may = [&](int element) { return may_rest.contains(element); };
        const bool all =
            node.leaf() ? std::ranges::all_of(node.elements, may) : std::ranges::all_of(node.children, rests);
        tree.rest[index] = all ? Rest::Leaf : Rest::Awake;
        if (!all) continue;
        for (const int child : node.children)
            if (child >= 0) tree.rest[at(child)] = Rest::Inside;
        for (const int element : node.elements) tree.resting.insert(element);
        std::fill_n(inside.begin() + node.first_rank, node.eliminated, static_cast<char>(1));
    }
    for (std::size_t i = 0; i < inside.size(); ++i)
        if (inside[at(tree.plan.rank[i])] != 0) tree.inside.insert(i);
    for (std::size_t index = 0; index < tree.fronts.size(); ++index)
        if (tree.rest[index] != Rest::Leaf) tree.carried_by[index].known = false;
    tree.carried.setZero();
}

const ElementSet& FrontTree::resting() const { return tree_->resting; }
const UnknownSet& FrontTree::inside() const { return tree_->inside; }

// Leaf by leaf, so that one whose load is what it was has nothing to do.
void FrontTree::carry(const Eigen::VectorXd& load) {
    Tree& tree = *tree_;
    const Eigen::VectorXd before = std::exchange(tree.due, tree.by_rank(load));
    Eigen::VectorXd scratch = Eigen::VectorXd::Zero(load.size());
    tree.carried = tree.due;
    for (std::size_t index = 0; index < tree.fronts.size(); ++index) {
        if (tree.rest[index] != Tree::Rest::Leaf) continue;
        const auto [begin, count] = tree.inside_of(index);
        Tree::Carried& own = tree.carried_by[index];
        if (!own.known || tree.due.segment(begin, count) != before.segment(begin, count))
            tree.carry_through(index, scratch);
        tree.carried.segment(begin, count) = tree.carried_inside.segment(begin, count);
        subtract_at(-own.up, tree.plan.nodes[index].kept, tree.carried);
    }
}

Eigen::VectorXd FrontTree::response(const Eigen::VectorXd& move) const {
    const Tree& tree = *tree_;
    const Eigen::VectorXd x = tree.by_rank(move);
    Eigen::VectorXd load = tree.carried;
    for (std::size_t index = 0; index < tree.fronts.size(); ++index) {
        if (tree.rest[index] == Tree::Rest::Awake) continue;
        const AssemblyTree::Node& node = tree.plan.nodes[index];
        load.segment(node.first_rank, node.eliminated).setZero();
        if (tree.rest[index] != Tree::Rest::Leaf) continue;
        Eigen::VectorXd kept(std::ssize(node.kept));
        gather_at(x, node.kept, kept);
        subtract_at(tree.fronts[index].times_schur(kept), node.kept, load);
    }
    return tree.by_unknown(load);
}

Eigen::VectorXd FrontTree::follow(const Eigen::VectorXd& move) const {
    const Tree& tree = *tree_;
    Eigen::VectorXd x = tree.by_rank(move);
    for (std::size_t index = 0; index < tree.fronts.size(); ++index) {
        const AssemblyTree::Node& node = tree.plan.nodes[index];
        if (tree.rest[index] != Tree::Rest::Awake)
            x.segment(node.first_rank, node.eliminated) = tree.carried.segment(node.first_rank, node.eliminated);
    }
    tree.backward(x, false);
    return tree.by_unknown(x);
}

// `scratch`: zero, before and after.
void FrontTree::Tree::carry_through(std::size_t leaf, Eigen::VectorXd& scratch) {
    const auto [begin, count] = inside_of(leaf);
    const std::vector<int>& kept = plan.nodes[leaf].kept;
    Eigen::VectorXd buffer(widest);
    scratch.segment(begin, count) = due.segment(begin, count);
    for (std::size_t index = first_below[leaf]; index <= leaf; ++index, ++carried_through)
        forward(index, scratch, buffer);
    Carried& own = carried_by[leaf];
    own.known = true;
    own.up.resize(std::ssize(kept));
    gather_at(scratch, kept, own.up);
    carried_inside.segment(begin, count) = scratch.segment(begin, count);
    scratch.segment(begin, count).setZero();
    scatter_at(Eigen::VectorXd::Zero(own.up.size()), kept, scratch);
}

std::pair<Eigen::Index, Eigen::Index> FrontTree::Tree::inside_of(std::size_t index) const {
    const Eigen::Index begin = plan.nodes[first_below[index]].first_rank;
    return {begin, plan.nodes[index].first_rank + plan.nodes[index].eliminated - begin};
}

}  // namespace stria
