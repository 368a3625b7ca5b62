#include "fine/bulk/bulk_elements.hpp"

#include <algorithm>
#include <utility>

#include "common/enrichment/same_functions.hpp"
#include "common/error.hpp"
#include "common/fem/centre.hpp"
#include "common/integration/moment_fit.hpp"
#include "common/integration/zone_rule.hpp"

namespace stria::fine {

namespace {

bool same_tie(const EnrichedMesh& mesh, int node, const EnrichedMesh& other, int other_node) {
    const TiedNode *a = mesh.tie(node), *b = other.tie(other_node);
    if (a == nullptr || b == nullptr) return a == b;
    const auto same_end = [&](int end, int other_end) {
        return mesh.node_ids[at(end)] == other.node_ids[at(other_end)] &&
               same_functions_at(end, mesh, other_end, other);
    };
    return a->side == b->side && a->jump_tied == b->jump_tied && std::ranges::equal(a->ends, b->ends, same_end);
}

}  // namespace

BulkElements::BulkElements(const EnrichedMesh& mesh, const Materials& materials, const IntegrationRule& rule,
                           BulkElements* old)
    : BulkElements(
          mesh, materials, rule,
          [&](int e, const CrackPiece* cut) {
              return old != nullptr && materials.may_yield() ? old->points_kept(mesh, e, cut) : std::nullopt;
          },
          old) {}

BulkElements::BulkElements(const EnrichedMesh& mesh, const Materials& materials, const IntegrationRule& rule,
                           const KnownPoints& known, BulkElements* old)
    : mesh_(mesh), materials_(materials), piece_(piece_of_elements(mesh_)), was_(mesh_.elements.size(), -1) {
    require(std::ranges::is_sorted(mesh_.element_ids), "the elements of a zone are in the order of their ids");
    operators_.reserve(mesh_.elements.size());
    stiffness_.reserve(mesh_.elements.size());
    const std::vector<int> now = old != nullptr ? same_unknowns(old->mesh_, mesh_) : std::vector<int>();
    for (int e = 0; e < std::ssize(mesh_.elements); ++e) {
        if (const auto same = old != nullptr ? old->find(mesh_, e) : std::nullopt;
            same && old->stays(*this, e, *same)) {
            take_over(*old, *same, e, now);
            continue;
        }
        const CrackPiece* cut = cut_of(e);
        IntegrationRule own = rule;
        own.mean_dilatation = mean_dilatation(materials_.section(mesh_.material_of(e)), elastic(e));
        if (auto points = known(e, cut)) {
            operators_.push_back(make_operator(mesh_, e, cut, own, std::move(*points)));
        } else {
            if (cut == nullptr && !lies_on_way_of_a_tip(mesh_, e) && !ElementBasis(mesh_, e, false).singular())
                own.subcells = rule.far_subcells.value_or(rule.subcells);
            operators_.push_back(make_operator(mesh_, e, cut, own));
        }
        stiffness_.push_back(operators_.back().stiffness(elastic_stiffness(e)));
    }
}

// The same functions come in the same order.
void BulkElements::take_over(BulkElements& old, int own, int element, std::span<const int> now) {
    ElementOperator& op = operators_.emplace_back(std::move(old.operators_[at(own)]));
    op.element = element;
    for (int& unknown : op.unknowns) unknown = now[at(unknown)];
    stiffness_.push_back(std::move(old.stiffness_[at(own)]));
    was_[at(element)] = own;
}

UnknownSet BulkElements::changed_unknowns() const {
    UnknownSet changed(mesh_.unknowns);
    for (int e = 0; e < count(); ++e)
        if (!has_stayed(e))
            for (const int unknown : op(e).unknowns) changed.insert(unknown);
    return changed;
}

const CrackPiece* BulkElements::cut_of(int element) const { return mesh_.piece(piece_[at(element)]); }

bool BulkElements::stays(const BulkElements& later, int element, int own) const {
    const CrackPiece *before = cut_of(own), *now = later.cut_of(element);
    const bool same_cut = before != nullptr && now != nullptr ? before->points == now->points : before == now;
    if (!same_cut || mesh_.element_side[at(own)] != later.mesh_.element_side[at(element)] ||
        branch_side(mesh_, own) != branch_side(later.mesh_, element))
        return false;
    const auto same = [&](int old_node, int node) {
        return same_functions_at(old_node, mesh_, node, later.mesh_) && same_tie(mesh_, old_node, later.mesh_, node);
    };
    return std::ranges::equal(mesh_.elements[at(own)], later.mesh_.elements[at(element)], same);
}

std::optional<int> BulkElements::find(const EnrichedMesh& later, int element) const {
    const int id = later.element_ids[at(element)];
    const auto found = std::ranges::lower_bound(mesh_.element_ids, id);
    if (found == mesh_.element_ids.end() || *found != id) return std::nullopt;
    const auto own = static_cast<int>(found - mesh_.element_ids.begin());
    for (std::size_t k = 0; k < 4; ++k) {
        const int node = mesh_.elements[at(own)][k], later_node = later.elements[at(element)][k];
        if (mesh_.node_ids[at(node)] != later.node_ids[at(later_node)]) return std::nullopt;
    }
    return own;
}

// While a tip stands in the element nothing jumps there yet, and the weights stay.
std::optional<std::vector<IntegrationPoint>> BulkElements::points_kept(const EnrichedMesh& later, int element,
                                                                       const CrackPiece* cut) const {
    const std::optional<int> own = find(later, element);
    if (!own) return std::nullopt;
    std::vector<IntegrationPoint> points = op(*own).points;
    const CrackPiece* const old_cut = cut_of(*own);
    if (cut == nullptr || (old_cut != nullptr && old_cut->points == cut->points)) return points;
    const std::array<Vec2, 4> corners = ElementBasis(later, element, true).corners();
    const CutElement sides = cut_element(corners, *cut);
    if (sides.tips.empty())
        fit_weights(sides, corners, points);
    else
        for (IntegrationPoint& point : points) point.side = sides.side_of(point.x);
    return points;
}

bool BulkElements::is_near(int element, const Vec2& place, double radius) const {
    return (op(element).points.front().x - place).norm() <= radius + 2.0 * diagonal(mesh_, element);
}

}  // namespace stria::fine
