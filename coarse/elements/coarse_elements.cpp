#include "coarse/elements/coarse_elements.hpp"

#include "coarse/elements/elastic_force.hpp"
#include "common/index_lists.hpp"
#include "common/linear/symmetric_assembly.hpp"

namespace stria::coarse {
namespace {

IntegrationRule rule_for(const Scene& scene, int element, bool cut) {
    IntegrationRule rule = elastic_rule(scene.enriched, element, cut);
    rule.mean_dilatation = scene.mean_dilatation(element);
    return rule;
}

}  // namespace

CoarseElements::CoarseElements(const Scene& scene, ElementSet in_zone, const StillElements& still)
    : scene_(&scene), in_zone_(std::move(in_zone)) {
    const auto is_in = [](const ElementSet& set, int element) { return set.size() > 0 && set.contains(element); };
    for (int e = 0; e < in_zone_.size(); ++e) {
        if (in_zone_.contains(e) || is_in(still.far, e)) continue;
        near_.push_back(e);
        if (!is_in(still.middle, e)) core_.push_back(e);
    }
    make_enriched_operators();
    keep_plain_operators();
    find_supported();
    if (scene.initial_stress().any()) integrate_initial_stress();
}

void CoarseElements::make_enriched_operators() {
    const EnrichedMesh& mesh = scene_->enriched;
    const std::vector<int> piece = piece_of_elements(mesh);
    for (const int e : core_) {
        if (is_plain(mesh, e)) continue;
        const CrackPiece* cut = piece[at(e)] >= 0 ? &mesh.pieces[at(piece[at(e)])] : nullptr;
        enriched_.push_back(make_operator(mesh, e, cut, rule_for(*scene_, e, cut != nullptr)));
    }
}

// The stresses and ring integrals of each increment visit them: kept they save a tenth of a cycle, as long as they
// stay in the cache.
void CoarseElements::keep_plain_operators() {
    constexpr int most = 20'000;  // elements: 12 MB
    if (std::ssize(near_) > most) return;
    plain_place_.assign(at(in_zone_.size()), -1);
    for (const int e : near_) {
        if (!is_plain(scene_->enriched, e)) continue;
        plain_place_[at(e)] = static_cast<int>(plain_.size());
        plain_.push_back(plain_operator(*scene_, e));
    }
}

void CoarseElements::find_supported() {
    const EnrichedMesh& mesh = scene_->enriched;
    UnknownSet prescribed(mesh.unknowns);
    for (const PrescribedUnknown& p : scene_->prescribed) prescribed.insert(p.unknown);
    const auto is_held = [&](int unknown) { return prescribed.contains(unknown); };
    auto enriched = enriched_.begin();
    for (int e = 0; e < in_zone_.size(); ++e) {
        if (in_zone_.contains(e)) continue;
        const bool plain = enriched == enriched_.end() || enriched->element != e;
        if (plain ? std::ranges::any_of(plain_unknowns(mesh, e), is_held)
                  : std::ranges::any_of((enriched++)->unknowns, is_held))
            supported_.push_back(e);
    }
}

void CoarseElements::integrate_initial_stress() {
    initial_.load = Eigen::VectorXd::Zero(scene_->enriched.unknowns);
    for_each([&](const auto& op) {
        auto force = gather(initial_.load, op.unknowns);
        force.setZero();
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const Mandel stress = scene_->initial_stress(op.element, op.points[q].x);
            op.add_force(stress, q, force);
            initial_.energy += op.points[q].weight * scene_->elastic(op.element).energy(stress);
        }
        for (std::size_t k = 0; k < op.unknowns.size(); ++k)
            initial_.load[op.unknowns[k]] -= force[static_cast<Eigen::Index>(k)];
    });
}

Eigen::VectorXd CoarseElements::internal_force(const Eigen::VectorXd& u) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(scene_->enriched.unknowns);
    for_each([&](const auto& op) {
        const auto force = elastic_force(op, gather(u, op.unknowns), scene_->stiffness(op.element));
        for (std::size_t k = 0; k < op.unknowns.size(); ++k) sum[op.unknowns[k]] += force[static_cast<Eigen::Index>(k)];
    });
    return sum;
}

SparseMatrix CoarseElements::stiffness() const {
    IndexLists of_elements;
    for_each_unknowns([&](int, std::span<const int> unknowns) { of_elements.append(unknowns); });
    SparseMatrix lower = lower_pattern(of_elements, scene_->enriched.unknowns);
    for_each([&](const auto& op) { add_to_lower(lower, op.unknowns, op.stiffness(scene_->stiffness(op.element))); });
    return lower.selfadjointView<Eigen::Lower>();
}

}  // namespace stria::coarse
