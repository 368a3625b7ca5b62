#include "coarse/structure.hpp"

#include <algorithm>
#include <numeric>

#include "common/linear/symmetric_assembly.hpp"
#include "common/stopwatch.hpp"
#include "common/substructure/nested_dissection.hpp"

namespace stria::coarse {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

IntegrationRule rule_for(const Scene& scene, int element, bool cut) {
    IntegrationRule rule = elastic_rule(scene.enriched, element, cut);
    rule.mean_dilatation = mean_dilatation(scene.input.material, scene.elastic);
    return rule;
}

template <class Operator, class Values>
Values elastic_force(const Operator& op, const Values& u, const MandelMatrix& elastic) {
    Values force = Values::Zero(u.size());
    for (std::size_t q = 0; q < op.points.size(); ++q) op.add_force(elastic * op.strain(u, q), q, force);
    return force;
}

}  // namespace

Structure::Structure(const Scene& scene, std::vector<char> in_zone)
    : scene_(scene), in_zone_(std::move(in_zone)),
      mean_dilatation_(mean_dilatation(scene.input.material, scene.elastic) != MeanDilatation::Nowhere) {
    make_enriched_operators();
    keep_plain_operators();
    number_unknowns();
    condense();
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
    if (std::ssize(in_zone_) > most) return;
    plain_place_.assign(in_zone_.size(), -1);
    for (int e = 0; e < static_cast<int>(in_zone_.size()); ++e) {
        if (in_zone_[at(e)] != 0 || !is_plain(scene_.enriched, e)) continue;
        plain_place_[at(e)] = static_cast<int>(plain_.size());
        plain_.push_back(plain_operator(scene_.enriched, e, mean_dilatation_));
    }
}

void Structure::number_unknowns() {
    const Stopwatch watch(seconds_.assembly);
    const EnrichedMesh& mesh = scene_.enriched;
    std::vector<char> coarse(at(mesh.unknowns), 0), fine = coarse, prescribed = coarse;
    for (const PrescribedUnknown& p : scene_.prescribed) prescribed[at(p.unknown)] = 1;
    for_each_coarse([&](int element, std::span<const int> unknowns) {
        for (const int unknown : unknowns) coarse[at(unknown)] = 1;
        if (std::ranges::any_of(unknowns, [&](int unknown) { return prescribed[at(unknown)] != 0; }))
            supported_.push_back(element);
    });
    const std::vector<int> piece = piece_of_elements(mesh);
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
        if (in_zone_[at(e)] == 0) continue;
        const ElementBasis basis(mesh, e, piece[at(e)] >= 0);
        for (const int unknown : basis.unknowns()) fine[at(unknown)] = 1;
    }
    leaf_index_.assign(at(mesh.unknowns), -1);
    for (int i = 0; i < mesh.unknowns; ++i) {
        if (fine[at(i)] != 0 && (coarse[at(i)] != 0 || prescribed[at(i)] != 0 || scene_.observed[at(i)] != 0))
            gamma_.push_back(i);
        else if (coarse[at(i)] != 0 && prescribed[at(i)] == 0) {
            leaf_index_[at(i)] = unknowns();
            leaf_unknowns_.push_back(i);
        }
    }
    for (int place = 0; place < static_cast<int>(gamma_.size()); ++place) {
        if (prescribed[at(gamma_[at(place)])] != 0) continue;
        free_places_.push_back(place);
        leaf_index_[at(gamma_[at(place)])] = unknowns();
        leaf_unknowns_.push_back(gamma_[at(place)]);
    }
}

/// Renumbers the leaf's unknowns, those of Gamma last; returns the elements' unknowns with their new numbers.
IndexLists Structure::order_elimination() {
    const Stopwatch watch(seconds_.ordering);
    const EnrichedMesh& mesh = scene_.enriched;
    IndexLists of_elements;
    std::vector<Vec2> centres;
    for_each_coarse([&](int element, std::span<const int> unknowns) {
        of_elements.append(unknowns);
        centres.push_back(Vec2::Zero());
        for (const int node : mesh.elements[at(element)]) centres.back() += mesh.nodes[at(node)] / 4.0;
    });
    of_elements.map([&](int unknown) { return leaf_index_[at(unknown)]; });
    const auto boundary = static_cast<int>(free_places_.size());
    std::vector<int> kept(at(boundary));
    std::iota(kept.begin(), kept.end(), unknowns() - boundary);
    const std::vector<int> order = nested_dissection(of_elements, centres, unknowns(), kept);

    const std::vector<int> before = std::move(leaf_unknowns_);
    std::vector<int> rank(before.size());
    leaf_unknowns_.clear();
    for (const int unknown : order) {
        rank[at(unknown)] = unknowns();
        leaf_index_[at(before[at(unknown)])] = unknowns();
        leaf_unknowns_.push_back(before[at(unknown)]);
    }
    of_elements.map([&](int unknown) { return unknown < 0 ? -1 : rank[at(unknown)]; });
    return of_elements;
}

SparseMatrix Structure::assemble() {
    const IndexLists of_elements = order_elimination();
    const Stopwatch watch(seconds_.assembly);
    const MandelMatrix elastic = scene_.elastic.stiffness();
    SparseMatrix lower = lower_pattern(of_elements, unknowns());
    std::size_t k = 0;
    for_each_operator([&](const auto& op) { add_to_lower(lower, of_elements[k++], op.stiffness(elastic)); });
    return lower;
}

void Structure::condense() {
    SparseMatrix lower = assemble();
    const Stopwatch watch(seconds_.factor);
    leaf_ = std::make_unique<SparseLeaf>(static_cast<int>(free_places_.size()), std::move(lower));
    reduced_ = leaf_->reduce(unit_load_of_leaf());
    const Eigen::VectorXd of_unit_load = expand(Eigen::VectorXd::Zero(std::ssize(gamma_)), 1.0);
    condense_mean_displacement(of_unit_load);
    condense_energy(of_unit_load);
}

/// With what the imposed displacements do to it.
Eigen::VectorXd Structure::unit_load_of_leaf() const {
    const MandelMatrix elastic = scene_.elastic.stiffness();
    Eigen::VectorXd imposed = Eigen::VectorXd::Zero(scene_.enriched.unknowns);
    for (const PrescribedUnknown& p : scene_.prescribed) imposed[p.unknown] = p.value;
    Eigen::VectorXd load = gather(scene_.unit_force, leaf_unknowns_);
    for (const int element : supported_) {
        visit_operator(element, [&](const auto& op) {
            const auto reaction = (op.stiffness(elastic) * gather(imposed, op.unknowns)).eval();
            for (std::size_t i = 0; i < op.unknowns.size(); ++i) {
                const int row = leaf_index_[at(op.unknowns[i])];
                if (row >= 0) load[row] -= reaction[static_cast<Eigen::Index>(i)];
            }
        });
    }
    return load;
}

void Structure::condense_mean_displacement(const Eigen::VectorXd& of_unit_load) {
    mean_displacement_.weights = leaf_->reduce(gather(scene_.mean_displacement, leaf_unknowns_)).boundary;
    mean_displacement_.per_load_factor = scene_.mean_displacement.dot(of_unit_load);
}

// Of imposed displacements the reactions do the work; loads on the same unknowns do none of their own.
void Structure::condense_energy(const Eigen::VectorXd& of_unit_load) {
    Eigen::VectorXd force = scene_.unit_force;
    Eigen::VectorXd imposed(std::ssize(scene_.prescribed));
    for (std::size_t k = 0; k < scene_.prescribed.size(); ++k) {
        imposed[static_cast<Eigen::Index>(k)] = scene_.prescribed[k].value;
        force[scene_.prescribed[k].unknown] = 0.0;
    }
    load_displacement_.per_load_factor = force.dot(of_unit_load);
    unit_energy_ = load_displacement_.per_load_factor;
    load_displacement_.weights = reduced_.boundary;
    if (imposed.isZero(0.0)) return;
    load_displacement_.weights = leaf_->reduce(gather(force, leaf_unknowns_)).boundary;
    unit_energy_ += imposed.dot(forces_on_prescribed(of_unit_load));
}

// With the interior in equilibrium: u . K u = u_b . S u_b + 2 lambda m . u_b + lambda^2 e, where m, what imposed
// displacements pull at the free places u_b, is the reduced load less that of the forces alone.
double Structure::stored_energy(const Eigen::VectorXd& gamma_displacement, double load_factor) const {
    const Eigen::VectorXd u = on_free_places(gamma_displacement);
    const Eigen::VectorXd pull = load_displacement_.weights - reduced_.boundary;
    return 0.5 * (u.dot(tangent() * u) + load_factor * (2.0 * pull.dot(u) + load_factor * unit_energy_));
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

std::vector<int> Structure::elements_beyond(double stress, const Eigen::VectorXd& u) const {
    const MandelMatrix elastic = scene_.elastic.stiffness();
    std::vector<int> found;
    const auto may_yield = [&](int element) { return !scene_.mesh.in_insert(element); };
    for_each_operator(may_yield, [&](const auto& op) {
        const auto local = gather(u, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            if (von_mises(elastic * op.strain(local, q)) <= stress) continue;
            found.push_back(op.element);
            break;
        }
    });
    return found;
}

const RingForms& Structure::rings(int tip) const {
    rings_.resize(scene_.enriched.tips.size());
    if (!rings_[at(tip)]) rings_[at(tip)] = std::make_unique<RingForms>(*this, tip);
    return *rings_[at(tip)];
}

Eigen::VectorXd Structure::forces_on_prescribed(const Eigen::VectorXd& u) const {
    std::vector<int> row(at(scene_.enriched.unknowns), -1);
    for (std::size_t k = 0; k < scene_.prescribed.size(); ++k)
        row[at(scene_.prescribed[k].unknown)] = static_cast<int>(k);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(std::ssize(scene_.prescribed));
    for (const int element : supported_) {
        visit_operator(element, [&](const auto& op) {
            const auto force = elastic_force(op, gather(u, op.unknowns), scene_.elastic.stiffness());
            for (std::size_t k = 0; k < op.unknowns.size(); ++k) {
                const int own = row[at(op.unknowns[k])];
                if (own >= 0) forces[own] += force[static_cast<Eigen::Index>(k)];
            }
        });
    }
    return forces;
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
