#include "common/substructure/subtrees_at_rest.hpp"

#include <algorithm>

#include "common/index.hpp"
#include "common/substructure/front_passes.hpp"

namespace stria {

SubtreesAtRest::SubtreesAtRest(const AssemblyTree& plan, std::size_t elements)
    : plan_(plan), rest_(plan.nodes.size(), Rest::Awake), elements_(elements), inside_(plan.rank.size()),
      carried_by_(plan.nodes.size()), carried_(Eigen::VectorXd::Zero(std::ssize(plan.rank))), outside_(carried_),
      due_(carried_), known_inside_(carried_), scratch_(carried_) {
    for (const AssemblyTree::Node& node : plan.nodes)
        first_below_.push_back(node.leaf() ? first_below_.size() : first_below_[at(node.children[0])]);
}

void SubtreesAtRest::rest(const ElementSet& may_rest) {
    elements_ = ElementSet(elements_.size());
    inside_ = UnknownSet(inside_.size());
    std::vector<char> inside(plan_.rank.size(), 0);  // by rank
    for (std::size_t index = 0; index < rest_.size(); ++index) {
        const AssemblyTree::Node& node = plan_.nodes[index];
        const auto rests = [&](int child) { return !is_awake(at(child)); };
        const auto may = [&](int element) { return may_rest.contains(element); };
        const bool all =
            node.leaf() ? std::ranges::all_of(node.elements, may) : std::ranges::all_of(node.children, rests);
        rest_[index] = all ? Rest::Top : Rest::Awake;
        if (!all) continue;
        for (const int child : node.children)
            if (child >= 0) rest_[at(child)] = Rest::Inside;
        for (const int element : node.elements) elements_.insert(element);
        std::fill_n(inside.begin() + node.first_rank, node.eliminated, static_cast<char>(1));
    }
    for (std::size_t i = 0; i < inside.size(); ++i)
        if (inside[at(plan_.rank[i])] != 0) inside_.insert(i);
    tops_.clear();
    for (std::size_t index = 0; index < rest_.size(); ++index) {
        if (rest_[index] == Rest::Top)
            tops_.push_back(index);
        else
            forget(index);
    }
    carried_.setZero();
    outside_.setZero();
}

// Subtree by subtree, so that one whose load is what it was has nothing to do.
void SubtreesAtRest::carry(Eigen::VectorXd load, std::span<const Front> fronts) {
    std::swap(due_, load);  // now that of before
    carried_ = due_;
    for (const std::size_t top : tops_) {
        const auto [begin, count] = inside_of(top);
        if (!carried_by_[top].known || due_.segment(begin, count) != load.segment(begin, count))
            carry_through(top, fronts);
        carried_.segment(begin, count) = known_inside_.segment(begin, count);
        add_at(plan_.nodes[top].kept, carried_by_[top].up, carried_);
    }
    outside_ = carried_;
    for (const std::size_t top : tops_) {
        const auto [begin, count] = inside_of(top);
        outside_.segment(begin, count).setZero();
    }
}

void SubtreesAtRest::carry_through(std::size_t top, std::span<const Front> fronts) {
    const auto [begin, count] = inside_of(top);
    const std::vector<int>& kept = plan_.nodes[top].kept;
    Eigen::VectorXd buffer(plan_.widest);
    scratch_.segment(begin, count) = due_.segment(begin, count);
    for (std::size_t index = first_below_[top]; index <= top; ++index, ++carried_through_)
        forward(plan_.nodes[index], fronts[index], scratch_, buffer);
    Carried& own = carried_by_[top];
    own.known = true;
    own.up.resize(std::ssize(kept));
    gather_at(kept, scratch_, own.up);
    known_inside_.segment(begin, count) = scratch_.segment(begin, count);
    scratch_.segment(begin, count).setZero();
    scatter_at(kept, Eigen::VectorXd::Zero(own.up.size()), scratch_);
}

Eigen::VectorXd SubtreesAtRest::response(const Eigen::VectorXd& move, std::span<const Front> fronts) const {
    Eigen::VectorXd load = outside_, moved(plan_.widest), forces(plan_.widest);
    for (const std::size_t top : tops_) {
        const std::vector<int>& kept = plan_.nodes[top].kept;
        auto move_of = moved.head(std::ssize(kept)), forces_of = forces.head(std::ssize(kept));
        gather_at(kept, move, move_of);
        fronts[top].minus_schur(move_of, forces_of);
        add_at(kept, forces_of, load);
    }
    return load;
}

Eigen::VectorXd SubtreesAtRest::follow(Eigen::VectorXd move, std::span<const Front> fronts) const {
    Eigen::VectorXd buffer(plan_.widest);
    for (std::size_t index = rest_.size(); index-- > 0;) {
        if (is_awake(index)) continue;
        const AssemblyTree::Node& node = plan_.nodes[index];
        move.segment(node.first_rank, node.eliminated) = carried_.segment(node.first_rank, node.eliminated);
        backward(node, fronts[index], move, buffer);
    }
    return move;
}

std::pair<Eigen::Index, Eigen::Index> SubtreesAtRest::inside_of(std::size_t node) const {
    const Eigen::Index begin = plan_.nodes[first_below_[node]].first_rank;
    return {begin, plan_.nodes[node].first_rank + plan_.nodes[node].eliminated - begin};
}

}  // namespace stria
