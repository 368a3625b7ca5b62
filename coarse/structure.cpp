#include "coarse/structure.hpp"

#include <algorithm>

namespace stria::coarse {
namespace {

std::size_t at(int index) { return static_cast<std::size_t>(index); }

/// Elastic elements with tip functions are integrated densely; the others exactly with the fewest points.
IntegrationRule rule_for(const Scene& scene, int element, bool cut) {
    IntegrationRule rule{.mean_dilatation = scene.elastic.plane == PlaneState::Strain};
    if (ElementBasis(scene.enriched, element, cut).singular()) {
        rule.subcells = 2;
        rule.gauss = 6;
        rule.tip_points = 10;
    }
    return rule;
}

}  // namespace

Structure::Structure(const Scene& scene, std::vector<char> in_zone) : scene_(scene), in_zone_(std::move(in_zone)) {
    const EnrichedMesh& mesh = scene.enriched;
    const std::vector<int> piece = piece_of_elements(mesh);
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
        if (in_zone_[at(e)] != 0) continue;
        const CrackPiece* cut = piece[at(e)] >= 0 ? &mesh.pieces[at(piece[at(e)])] : nullptr;
        operators_.push_back(make_operator(mesh, e, cut, rule_for(scene, e, cut != nullptr)));
    }
    number_unknowns();
    condense();
}

void Structure::number_unknowns() {
    const EnrichedMesh& mesh = scene_.enriched;
    std::vector<char> coarse(at(mesh.unknowns), 0), fine = coarse, prescribed = coarse;
    for (const ElementOperator& op : operators_)
        for (const int unknown : op.unknowns) coarse[at(unknown)] = 1;
    const std::vector<int> piece = piece_of_elements(mesh);
    for (int e = 0; e < static_cast<int>(mesh.elements.size()); ++e) {
        if (in_zone_[at(e)] == 0) continue;
        const ElementBasis basis(mesh, e, piece[at(e)] >= 0);
        for (const int unknown : basis.unknowns()) fine[at(unknown)] = 1;
    }
    for (const PrescribedUnknown& p : scene_.prescribed) prescribed[at(p.unknown)] = 1;

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

void Structure::condense() {
    const MandelMatrix elastic = scene_.elastic.stiffness();
    Eigen::VectorXd imposed = Eigen::VectorXd::Zero(scene_.enriched.unknowns);
    for (const PrescribedUnknown& p : scene_.prescribed) imposed[p.unknown] = p.value;

    std::vector<Triplet> entries;
    Eigen::VectorXd load = Eigen::VectorXd::Zero(unknowns());
    for (int i = 0; i < unknowns(); ++i) load[i] = scene_.unit_force[leaf_unknowns_[at(i)]];
    for (const ElementOperator& op : operators_) {
        const Eigen::MatrixXd K = op.stiffness(elastic);
        const Eigen::VectorXd reaction = K * gather(imposed, op.unknowns);
        for (std::size_t i = 0; i < op.unknowns.size(); ++i) {
            const int row = leaf_index_[at(op.unknowns[i])];
            if (row < 0) continue;
            load[row] -= reaction[static_cast<Eigen::Index>(i)];
            for (std::size_t j = 0; j < op.unknowns.size(); ++j) {
                const int column = leaf_index_[at(op.unknowns[j])];
                if (column >= 0)
                    entries.emplace_back(row, column, K(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
            }
        }
    }
    SparseMatrix matrix(unknowns(), unknowns());
    matrix.setFromTriplets(entries.begin(), entries.end());
    std::vector<int> boundary;
    for (const int place : free_places_) boundary.push_back(leaf_index_[at(gamma_[at(place)])]);
    leaf_ = std::make_unique<SparseLeaf>(matrix, std::move(boundary));
    reduced_ = leaf_->reduce(load);
}

Eigen::VectorXd Structure::expand(const Eigen::VectorXd& gamma_displacement, double load_factor) const {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(scene_.enriched.unknowns);
    Eigen::VectorXd boundary(std::ssize(free_places_));
    for (std::size_t k = 0; k < free_places_.size(); ++k)
        boundary[static_cast<Eigen::Index>(k)] = gamma_displacement[free_places_[k]];
    const Eigen::VectorXd x =
        leaf_->expand({load_factor * reduced_.interior, load_factor * reduced_.boundary}, boundary);
    for (int i = 0; i < unknowns(); ++i) u[leaf_unknowns_[at(i)]] = x[i];
    for (const PrescribedUnknown& p : scene_.prescribed) u[p.unknown] = load_factor * p.value;
    return u;
}

std::vector<int> Structure::elements_beyond(double stress, const Eigen::VectorXd& u) const {
    const MandelMatrix elastic = scene_.elastic.stiffness();
    std::vector<int> found;
    for (const ElementOperator& op : operators_) {
        if (scene_.mesh.in_insert(op.element)) continue;
        const Eigen::VectorXd local = gather(u, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            if (von_mises(elastic * op.strain(local, q)) <= stress) continue;
            found.push_back(op.element);
            break;
        }
    }
    return found;
}

DomainIntegral Structure::ring_integral(const Tip& tip, const Eigen::VectorXd& q, const Eigen::VectorXd& u, bool want_J,
                                        bool want_K) const {
    const MandelMatrix elastic = scene_.elastic.stiffness();
    DomainIntegral sum;
    std::array<double, 4> corners{};
    for (const ElementOperator& op : operators_) {
        if (!ring_corners(scene_.enriched, op.element, q, corners)) continue;
        const Eigen::VectorXd local = gather(u, op.unknowns);
        const auto stress_and_work = [&](std::size_t p) {
            const Mandel strain = op.strain(local, p), stress = elastic * strain;
            return std::pair{stress, 0.5 * stress.dot(strain)};
        };
        sum +=
            integrate_ring(op, scene_.enriched, tip, corners, local, scene_.elastic, want_J, want_K, stress_and_work);
    }
    return sum;
}

Eigen::VectorXd Structure::forces_on_prescribed(const Eigen::VectorXd& u) const {
    std::vector<int> row(at(scene_.enriched.unknowns), -1);
    for (std::size_t k = 0; k < scene_.prescribed.size(); ++k)
        row[at(scene_.prescribed[k].unknown)] = static_cast<int>(k);
    const MandelMatrix elastic = scene_.elastic.stiffness();
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(std::ssize(scene_.prescribed));
    for (const ElementOperator& op : operators_) {
        if (std::ranges::none_of(op.unknowns, [&](int unknown) { return row[at(unknown)] >= 0; })) continue;
        const Eigen::VectorXd local = gather(u, op.unknowns);
        Eigen::VectorXd force = Eigen::VectorXd::Zero(local.size());
        for (std::size_t q = 0; q < op.points.size(); ++q) op.add_force(elastic * op.strain(local, q), q, force);
        for (std::size_t k = 0; k < op.unknowns.size(); ++k) {
            if (row[at(op.unknowns[k])] >= 0) forces[row[at(op.unknowns[k])]] += force[static_cast<Eigen::Index>(k)];
        }
    }
    return forces;
}

Eigen::VectorXd Structure::internal_force(const Eigen::VectorXd& u) const {
    const MandelMatrix elastic = scene_.elastic.stiffness();
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(scene_.enriched.unknowns);
    for (const ElementOperator& op : operators_) {
        const Eigen::VectorXd local = gather(u, op.unknowns);
        Eigen::VectorXd force = Eigen::VectorXd::Zero(local.size());
        for (std::size_t q = 0; q < op.points.size(); ++q) op.add_force(elastic * op.strain(local, q), q, force);
        for (std::size_t k = 0; k < op.unknowns.size(); ++k) sum[op.unknowns[k]] += force[static_cast<Eigen::Index>(k)];
    }
    return sum;
}

SparseMatrix Structure::stiffness() const {
    const MandelMatrix elastic = scene_.elastic.stiffness();
    std::vector<Triplet> entries;
    for (const ElementOperator& op : operators_) {
        const Eigen::MatrixXd K = op.stiffness(elastic);
        for (std::size_t i = 0; i < op.unknowns.size(); ++i) {
            for (std::size_t j = 0; j < op.unknowns.size(); ++j) {
                entries.emplace_back(op.unknowns[i], op.unknowns[j],
                                     K(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
            }
        }
    }
    SparseMatrix matrix(scene_.enriched.unknowns, scene_.enriched.unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
}

}  // namespace stria::coarse
