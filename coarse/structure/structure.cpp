#include "coarse/structure/structure.hpp"

#include <algorithm>
#include <numeric>

#include "coarse/structure/elastic_force.hpp"
#include "coarse/structure/gamma.hpp"
#include "common/index.hpp"
#include "common/linear/symmetric_assembly.hpp"
#include "common/stopwatch.hpp"
#include "common/substructure/nested_dissection.hpp"

namespace stria::coarse {
namespace {

IntegrationRule rule_for(const Scene& scene, int element, bool cut) {
    IntegrationRule rule = elastic_rule(scene.enriched, element, cut);
    rule.mean_dilatation = mean_dilatation(scene.input.material, scene.elastic);
    return rule;
}

bool same_bits(const SparseMatrix& a, const SparseMatrix& b) {
    if (a.rows() != b.rows() || a.nonZeros() != b.nonZeros()) return false;
    return std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.rows() + 1, b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr()) &&
           std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr());
}

}  // namespace

Structure::Structure(const Scene& scene, std::vector<char> in_zone, const std::vector<char>& far,
                     StructureFactors known)
    : scene_(scene), in_zone_(std::move(in_zone)),
      mean_dilatation_(mean_dilatation(scene.input.material, scene.elastic) != MeanDilatation::Nowhere) {
    for (int e = 0; e < std::ssize(in_zone_); ++e)
        if (in_zone_[at(e)] == 0 && far[at(e)] == 0) near_elements_.push_back(e);
    make_far_body(far, known);
    make_enriched_operators();
    keep_plain_operators();
    number_unknowns();
    condense(known);
}

// A far body of other elements is forgotten first, lest two of them take twice the memory.
void Structure::make_far_body(const std::vector<char>& far, StructureFactors& known) {
    if (std::ranges::find(far, static_cast<char>(1)) == far.end()) return;
    if (known.far && known.far->far() != far) known = {};
    far_ = known.far ? known.far : std::make_shared<FarBody>(scene_, far, seconds_);
    rim_ = far_->rim(scene_.enriched);
}

void Structure::make_enriched_operators() {
    const Stopwatch watch(seconds_.assembly);
    const EnrichedMesh& mesh = scene_.enriched;
    const std::vector<int> piece = piece_of_elements(mesh);
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
        if (in_zone_[at(e)] != 0 || is_plain(mesh, e)) continue;
        const CrackPiece* cut = piece[at(e)] >= 0 ? &mesh.pieces[at(piece[at(e)])] : nullptr;
        enriched_.push_back(make_operator(mesh, e, cut, rule_for(scene_, e, cut != nullptr)));
    }
}

// The stresses and ring integrals of each increment visit them: kept they save a tenth of a cycle, as long as they
// stay in the cache.
void Structure::keep_plain_operators() {
    constexpr int most = 20'000;  // elements: 12 MB
    const Stopwatch watch(seconds_.assembly);
    if (std::ssize(near_elements_) > most) return;
    plain_place_.assign(in_zone_.size(), -1);
    for (const int e : near_elements_) {
        if (!is_plain(scene_.enriched, e)) continue;
        plain_place_[at(e)] = static_cast<int>(plain_.size());
        plain_.push_back(plain_operator(scene_.enriched, e, mean_dilatation_));
    }
}

void Structure::number_unknowns() {
    const Stopwatch watch(seconds_.assembly);
    const EnrichedMesh& mesh = scene_.enriched;
    std::vector<char> coarse(at(mesh.unknowns), 0), prescribed = coarse;
    for (const PrescribedUnknown& p : scene_.prescribed) prescribed[at(p.unknown)] = 1;
    for_each_coarse([&](int element, std::span<const int> unknowns) {
        for (const int unknown : unknowns) coarse[at(unknown)] = 1;
        if (std::ranges::any_of(unknowns, [&](int unknown) { return prescribed[at(unknown)] != 0; }))
            supported_.push_back(element);
    });
    gamma_ = gamma_of(scene_, in_zone_);
    for (const int unknown : gamma_) coarse[at(unknown)] = 0;
    leaf_index_.assign(at(mesh.unknowns), -1);
    const auto number = [&](int unknown) {
        leaf_index_[at(unknown)] = unknowns();
        leaf_unknowns_.push_back(unknown);
    };
    if (far_) std::ranges::for_each(far_->inner(mesh), number);
    far_count_ = unknowns();
    for (int i = 0; i < mesh.unknowns; ++i)
        if (coarse[at(i)] != 0 && prescribed[at(i)] == 0 && leaf_index_[at(i)] < 0) number(i);
    for (int place = 0; place < static_cast<int>(gamma_.size()); ++place) {
        if (prescribed[at(gamma_[at(place)])] != 0) continue;
        free_places_.push_back(place);
        number(gamma_[at(place)]);
    }
}

/// Renumbers the leaf's near unknowns, those of the rim after the others, those of Gamma last; returns, numbered from
/// the first near one, the unknowns of the near elements and, as one more, of the rim.
IndexLists Structure::order_elimination() {
    const Stopwatch watch(seconds_.ordering);
    const EnrichedMesh& mesh = scene_.enriched;
    IndexLists of_elements;
    std::vector<Vec2> centres;
    for_each_near([&](int element, std::span<const int> unknowns) {
        of_elements.append(unknowns);
        centres.push_back(Vec2::Zero());
        for (const int node : mesh.elements[at(element)]) centres.back() += mesh.nodes[at(node)] / 4.0;
    });
    std::vector<char> late(centres.size(), 1);
    of_elements.append(rim_);
    centres.push_back(Vec2::Zero());
    late.push_back(0);  // what the far body shares with near elements is neither's own: it comes after both
    of_elements.map(
        [&](int unknown) { return leaf_index_[at(unknown)] < 0 ? -1 : leaf_index_[at(unknown)] - far_count_; });
    const int near = unknowns() - far_count_, boundary = static_cast<int>(free_places_.size());
    std::vector<int> kept(at(boundary));
    std::iota(kept.begin(), kept.end(), near - boundary);
    const std::vector<int> order = nested_dissection(of_elements, centres, near, kept, late);

    const std::vector<int> before(near_unknowns().begin(), near_unknowns().end());
    std::vector<int> rank(before.size());
    for (int k = 0; k < near; ++k) {
        const int unknown = before[at(order[at(k)])];
        rank[at(order[at(k)])] = k;
        leaf_index_[at(unknown)] = far_count_ + k;
        leaf_unknowns_[at(far_count_ + k)] = unknown;
    }
    of_elements.map([&](int unknown) { return unknown < 0 ? -1 : rank[at(unknown)]; });
    return of_elements;
}

/// Of the near elements, the far ones condensed onto the rim.
SparseMatrix Structure::assemble() {
    const IndexLists of_elements = order_elimination();
    const Stopwatch watch(seconds_.assembly);
    const MandelMatrix elastic = scene_.elastic.stiffness();
    SparseMatrix lower = lower_pattern(of_elements, unknowns() - far_count_);
    std::size_t k = 0;
    for_each_operator(near_elements_,
                      [&](const auto& op) { add_to_lower(lower, of_elements[k++], op.stiffness(elastic)); });
    if (far_) add_to_lower(lower, of_elements[k], far_->tangent());
    return lower;
}

void Structure::condense(const StructureFactors& known) {
    SparseMatrix lower = assemble();
    const Stopwatch watch(seconds_.factor);
    const int boundary = static_cast<int>(free_places_.size());
    if (known.near && known.near->boundary == boundary && same_bits(known.near->matrix, lower)) {
        near_factor_ = known.near;
    } else {
        auto leaf = std::make_shared<const SparseLeaf>(boundary, SparseMatrix(lower));
        near_factor_ = std::make_shared<NearFactor>(std::move(lower), boundary, std::move(leaf));
    }
    std::vector<int> rim;
    for (const int unknown : rim_) rim.push_back(leaf_index_[at(unknown)] - far_count_);
    leaf_ = std::make_unique<StackedLeaf>(far_, std::move(rim), near_factor_->leaf);
    condense_loads();
}

Eigen::VectorXd Structure::on_free_places(const Eigen::VectorXd& gamma_values) const {
    return gather(gamma_values, free_places_);
}

Eigen::VectorXd Structure::expand(const Eigen::VectorXd& gamma_displacement, double load_factor) const {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(scene_.enriched.unknowns);
    const Eigen::VectorXd x = leaf_->expand({load_factor * reduced_.interior, load_factor * reduced_.boundary},
                                            on_free_places(gamma_displacement));
    for (int i = 0; i < unknowns(); ++i) u[leaf_unknowns_[at(i)]] = x[i];
    for (const PrescribedUnknown& p : scene_.prescribed) u[p.unknown] = load_factor * p.value;
    return u;
}

const RingForms& Structure::rings(int tip) const {
    rings_.resize(scene_.enriched.tips.size());
    if (!rings_[at(tip)]) rings_[at(tip)] = std::make_unique<RingForms>(*this, tip);
    return *rings_[at(tip)];
}

void Structure::make_rings() const {
    for (int tip = 0; tip < std::ssize(scene_.enriched.tips); ++tip) (void)rings(tip);
}

Eigen::VectorXd Structure::internal_force(const Eigen::VectorXd& u) const {
    const MandelMatrix elastic = scene_.elastic.stiffness();
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(scene_.enriched.unknowns);
    for_each_operator([&](const auto& op) {
        const auto force = elastic_force(op, gather(u, op.unknowns), elastic);
        for (std::size_t k = 0; k < op.unknowns.size(); ++k) sum[op.unknowns[k]] += force[static_cast<Eigen::Index>(k)];
    });
    return sum;
}

SparseMatrix Structure::stiffness() const {
    const MandelMatrix elastic = scene_.elastic.stiffness();
    IndexLists of_elements;
    for_each_coarse([&](int, std::span<const int> unknowns) { of_elements.append(unknowns); });
    SparseMatrix lower = lower_pattern(of_elements, scene_.enriched.unknowns);
    for_each_operator([&](const auto& op) { add_to_lower(lower, op.unknowns, op.stiffness(elastic)); });
    return lower.selfadjointView<Eigen::Lower>();
}

}  // namespace stria::coarse
