#include "coarse/elements/coarse_elements.hpp"

#include <set>

#include "coarse/elements/elastic_force.hpp"
#include "common/case/case_questions.hpp"
#include "common/error.hpp"
#include "common/index_lists.hpp"
#include "common/linear/symmetric_assembly.hpp"

namespace stria::coarse {
namespace {

/// Nodes that have some of these unknowns, and those that hang on them: an element that sees one has such a corner.
std::vector<int> nodes_about(const EnrichedMesh& mesh, const std::vector<PrescribedUnknown>& prescribed) {
    std::set<int> nodes;
    for (const PrescribedUnknown& p : prescribed) {
        const int node = mesh.node_of(p.unknown);
        require(node >= 0, "no support holds a function that many nodes share");
        nodes.insert(node);
    }
    std::vector<int> about(nodes.begin(), nodes.end());
    for (const TiedNode& tie : mesh.tied)  // their ends are not tied
        if (contains_any(nodes, tie.ends)) about.push_back(tie.node);
    return about;
}

}  // namespace

CoarseElements::CoarseElements(const Scene& scene, ElementSet in_zone, const StillElements& still)
    : all_(scene), in_zone_(std::move(in_zone)) {
    for (int e = 0; e < in_zone_.size(); ++e) {
        if (in_zone_.contains(e) || still.far.holds(e)) continue;
        near_.push_back(e);
        if (!still.middle.holds(e) && !still.behind.holds(e)) core_.push_back(e);
    }
    make_enriched_operators();
    keep_plain_operators();
    find_supported();
    if (scene.initial_stress().any()) integrate_initial_stress();
}

void CoarseElements::make_enriched_operators() {
    for (const int e : core_)
        if (!is_plain(scene().enriched, e)) enriched_.push_back(all_.enriched_operator(e));
}

// The stresses and ring integrals of each increment visit them: kept they save a tenth of a cycle, as long as they
// stay in the cache. A nominal solution beside a zone looks at its rings once.
void CoarseElements::keep_plain_operators() {
    constexpr int most = 20'000;  // elements: 12 MB
    if (std::ssize(near_) > most || (in_zone_.none() && needs_fine(scene().input))) return;
    plain_place_.assign(at(in_zone_.size()), -1);
    for (const int e : near_) {
        if (!is_plain(scene().enriched, e)) continue;
        plain_place_[at(e)] = static_cast<int>(plain_.size());
        plain_.push_back(plain_operator(scene(), e));
    }
}

void CoarseElements::find_supported() {
    const UnknownSet prescribed = prescribed_among(scene().enriched.unknowns, scene().prescribed);
    for (const int e : scene().mesh.elements_about(nodes_about(scene().enriched, scene().prescribed))) {
        if (in_zone_.contains(e)) continue;
        visit_unknowns(e, [&](int, std::span<const int> unknowns) {
            if (contains_any(prescribed, unknowns)) supported_.push_back(e);
        });
    }
}

void CoarseElements::integrate_initial_stress() {
    initial_.load = Eigen::VectorXd::Zero(scene().enriched.unknowns);
    for_each([&](const auto& op) {
        auto force = gather(initial_.load, op.unknowns);
        force.setZero();
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const Mandel stress = scene().initial_stress(op.element, op.points[q].x);
            op.add_force(stress, q, force);
            initial_.energy += op.points[q].weight * scene().elastic(op.element).energy(stress);
        }
        for (std::size_t k = 0; k < op.unknowns.size(); ++k)
            initial_.load[op.unknowns[k]] -= force[static_cast<Eigen::Index>(k)];
    });
}

Eigen::VectorXd CoarseElements::internal_force(const Eigen::VectorXd& u) const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(scene().enriched.unknowns);
    for_each([&](const auto& op) {
        const auto force = elastic_force(op, gather(u, op.unknowns), scene().stiffness(op.element));
        for (std::size_t k = 0; k < op.unknowns.size(); ++k) sum[op.unknowns[k]] += force[static_cast<Eigen::Index>(k)];
    });
    return sum;
}

SparseMatrix CoarseElements::stiffness() const {
    IndexLists of_elements;
    for_each_unknowns([&](int, std::span<const int> unknowns) { of_elements.append(unknowns); });
    SparseMatrix lower = lower_pattern(of_elements, scene().enriched.unknowns);
    for_each([&](const auto& op) { add_to_lower(lower, op.unknowns, op.stiffness(scene().stiffness(op.element))); });
    return lower.selfadjointView<Eigen::Lower>();
}

}  // namespace stria::coarse
