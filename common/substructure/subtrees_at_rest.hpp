// Subtrees of a tree of fronts that rest: each answers by its Schur complement, and what is inside follows
// (docs/equations.md, rest).
#pragma once

#include <Eigen/Core>
#include <span>
#include <utility>
#include <vector>

#include "common/index_set.hpp"
#include "common/substructure/assembly_tree.hpp"
#include "common/substructure/front.hpp"

namespace stria {

/// Vectors are by rank. `fronts`: of all nodes of the tree.
class SubtreesAtRest {
public:
    /// `plan` must outlive it.
    SubtreesAtRest(const AssemblyTree& plan, std::size_t elements);

    /// Those whose elements may all rest do so, and no others.
    void rest(const ElementSet& may_rest);
    [[nodiscard]] const ElementSet& elements() const { return elements_; }
    [[nodiscard]] const UnknownSet& inside() const { return inside_; }  // by unknown
    [[nodiscard]] bool is_awake(std::size_t node) const { return rest_[node] == Rest::Awake; }

    /// A front has been factored anew.
    void forget(std::size_t node) { carried_by_[node].known = false; }

    /// As FrontTree has them.
    void carry(Eigen::VectorXd load, std::span<const Front> fronts);
    [[nodiscard]] Eigen::VectorXd response(const Eigen::VectorXd& move, std::span<const Front> fronts) const;
    [[nodiscard]] Eigen::VectorXd follow(Eigen::VectorXd move, std::span<const Front> fronts) const;

    /// Fronts through which a load was carried so far.
    [[nodiscard]] long carried() const { return carried_through_; }

private:
    enum class Rest : char { Awake, Top, Inside };
    void carry_through(std::size_t top, std::span<const Front> fronts);
    /// Of the unknowns inside a subtree: where they begin, and how many there are.
    [[nodiscard]] std::pair<Eigen::Index, Eigen::Index> inside_of(std::size_t node) const;

    const AssemblyTree& plan_;
    std::vector<Rest> rest_;                // per node
    std::vector<std::size_t> tops_;         // their nodes
    std::vector<std::size_t> first_below_;  // per node: children come before parents, a subtree is a run of nodes
    ElementSet elements_;
    UnknownSet inside_;
    /// What the top of a subtree has made of the load inside it.
    struct Carried {
        bool known = false;
        Eigen::VectorXd up;  // onto what it keeps
    };
    std::vector<Carried> carried_by_;    // per node
    Eigen::VectorXd carried_, outside_;  // all together; the same, zero inside
    Eigen::VectorXd due_;                // the load as it was given
    Eigen::VectorXd known_inside_;       // of the carried one, where it is known
    Eigen::VectorXd scratch_;            // zero, but for a moment
    long carried_through_ = 0;
};

}  // namespace stria
