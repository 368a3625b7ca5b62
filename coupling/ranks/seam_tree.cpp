#include "coupling/ranks/seam_tree.hpp"

#include <algorithm>
#include <utility>

#include "common/index.hpp"
#include "common/linear/lower_triangle.hpp"

namespace stria::coupling {
namespace {

Vec2 centre(const EnrichedMesh& zone, const std::vector<int>& elements) {
    Vec2 sum = Vec2::Zero();
    for (const int element : elements)
        for (const int node : zone.elements[at(element)]) sum += zone.nodes[at(node)] / 4.0;
    return sum / static_cast<double>(elements.size());
}

}  // namespace

SeamTree::SeamTree(const EnrichedMesh& zone, const std::vector<RankPart>& parts, const Seams& seams)
    : tangents_(parts.size()), changed_(parts.size(), 1) {
    FrontLayout layout;
    layout.unknowns = static_cast<int>(seams.kept.size());
    layout.boundary = seams.gamma;
    layout.leaf_elements = 2;  // two ranks meet in one front
    for (const RankPart& part : parts) {
        layout.element_unknowns.push_back(part.shared);
        layout.centres.push_back(centre(zone, part.elements));
    }
    tree_ = std::make_unique<FrontTree>(std::move(layout));
}

void SeamTree::set_tangent(std::size_t part, CondensedTangent tangent) {
    tangents_[part] = std::move(tangent);
    changed_[part] = 1;
}

// Lower triangles serve where all is symmetric and one front eliminates in the order of the parts: that of two.
void SeamTree::mirror_where_read() {
    const auto is_symmetric = [](const CondensedTangent& tangent) { return tangent.symmetry == Symmetry::Symmetric; };
    if (tangents_.size() <= 2 && std::ranges::all_of(tangents_, is_symmetric)) return;
    for (CondensedTangent& tangent : tangents_)
        if (is_symmetric(tangent)) mirror_lower(tangent.matrix);
}

bool SeamTree::factor() {
    if (std::ranges::none_of(changed_, [](char changed) { return changed != 0; })) return false;
    mirror_where_read();
    const auto tangent_of = [&](int part) {
        const auto& [matrix, symmetry] = tangents_[at(part)];
        return FrontTree::ElementMatrix{matrix, symmetry};
    };
    tree_->factor(tangent_of, changed_);
    std::ranges::fill(changed_, static_cast<char>(0));
    return true;
}

void SeamTree::reduce(const Eigen::VectorXd& load, const Eigen::VectorXd& unit_load) {
    load_ = tree_->reduce(load);
    if (unit_load.isZero(0.0))
        unit_load_ = {Eigen::VectorXd::Zero(load_.interior.size()), Eigen::VectorXd::Zero(load_.boundary.size())};
    else
        unit_load_ = tree_->reduce(unit_load);
}

Eigen::VectorXd SeamTree::follow(const Eigen::VectorXd& step, double load_step) const {
    return tree_->expand({load_.interior + load_step * unit_load_.interior, load_.boundary}, step);
}

}  // namespace stria::coupling
