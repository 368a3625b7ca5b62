#include "coarse/fracture/ring_forms.hpp"

#include "coarse/model/rings.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// Adds the adjoint of sigma = C eps(u), grad u at point q: what the weights of both make of each element value.
template <class Operator, class Values>
void add_adjoint(const Operator& op, std::size_t q, const MandelMatrix& elastic, const MutualWeights& weights,
                 Values& local) {
    op.add_force(elastic * weights.stress, q, local);
    const auto& gradients = op.gradients[q];
    const Eigen::Matrix2d weighted = op.points[q].weight * weights.gradient;
    local.reshaped(2, gradients.rows()) += weighted * gradients.transpose();
}

RingSums sums_about(const Scene& scene, int tip, const std::vector<Annulus>& rings, const std::vector<int>& among,
                    bool with_inside = false) {
    const Tip& about = scene.enriched.tips[at(tip)];
    return {scene.enriched, about, scene.elastic(about), rings, among, with_inside};
}

}  // namespace

RingForms::RingForms(const CoarseElements& elements, int tip, Asked asked)
    : tip_(tip), asked_(asked), rings_(rings_about(elements.scene(), tip)) {
    if (asked_ == Asked::InEachIncrement) weigh(elements);
}

void RingForms::weigh(const CoarseElements& elements) {
    RingSums geometry = sums_about(elements.scene(), tip_, rings_, elements.near());
    elements_ = geometry.elements();
    const std::vector<int> place = number_unknowns(elements);
    interactions_ = Eigen::MatrixXd::Zero(3 * std::ssize(rings_), std::ssize(unknowns_));
    elements.for_each(elements_, [&](const auto& op) {
        geometry.enter(op.element);
        add_element(op, geometry, elements.scene(), place);
    });
}

/// Of each unknown of the whole mesh its place in unknowns_, -1: none.
std::vector<int> RingForms::number_unknowns(const CoarseElements& elements) {
    UnknownSet seen(elements.scene().enriched.unknowns);
    elements.for_each_unknowns(elements_, [&](int, std::span<const int> unknowns) {
        for (const int unknown : unknowns) seen.insert(unknown);
    });
    unknowns_ = seen.members();
    std::vector<int> place(at(seen.size()), -1);
    for (std::size_t k = 0; k < unknowns_.size(); ++k) place[at(unknowns_[k])] = static_cast<int>(k);
    return place;
}

/// `geometry` has entered the element.
template <class Operator>
void RingForms::add_element(const Operator& op, const RingSums& geometry, const Scene& scene,
                            const std::vector<int>& place) {
    const Tip& about = scene.enriched.tips[at(tip_)];
    const MandelMatrix& elastic = scene.materials.stiffness(about.material);
    std::vector<int> entered;
    std::array<std::array<typename Operator::Values, 3>, most_rings> local;
    for (const IntegrationPoint& point : op.points) {
        const std::size_t q = at(&point - op.points.data());
        const std::array<TipField, 3> fields = geometry.auxiliary(point);
        std::size_t k = 0;
        geometry.for_each_ring(point, [&](std::size_t ring, const Vec2& dq) {
            weights_.emplace_back(point.weight * dq);
            if (q == 0) {
                entered.push_back(static_cast<int>(ring));
                local[k].fill(Operator::Values::Zero(std::ssize(op.unknowns)));
            }
            for (std::size_t mode = 0; mode < 3; ++mode)
                add_adjoint(op, q, elastic, mutual_weights(about, fields[mode], dq), local[k][mode]);
            ++k;
        });
    }
    entered_.append(entered);
    for (std::size_t i = 0; i < op.unknowns.size(); ++i) {
        auto sums = interactions_.col(place[at(op.unknowns[i])]);
        for (std::size_t k = 0; k < entered.size(); ++k)
            for (std::size_t mode = 0; mode < 3; ++mode)
                sums[3 * entered[k] + static_cast<Eigen::Index>(mode)] += local[k][mode][static_cast<Eigen::Index>(i)];
    }
}

std::vector<DomainIntegral> RingForms::values(const CoarseElements& elements, const Eigen::VectorXd& u) const {
    if (asked_ == Asked::Once) return summed_up(elements, u, false);
    const Scene& scene = elements.scene();
    const Tip& about = scene.enriched.tips[at(tip_)];
    const MandelMatrix& elastic = scene.materials.stiffness(about.material);
    std::vector<DomainIntegral> result(rings_.size());
    std::size_t element = 0;
    auto weight = weights_.begin();
    elements.for_each(elements_, [&](const auto& op) {
        const std::span<const int> entered = entered_[element++];
        const auto local = gather(u, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const Mandel strain = op.strain(local, q), stress = elastic * strain;
            const Vec2 own =
                energy_momentum(about, stress, op.displacement_gradient(local, q), 0.5 * stress.dot(strain));
            for (const int ring : entered) result[at(ring)].J += own.dot(*weight++);
        }
    });
    const Eigen::VectorXd sums = interactions_ * gather(u, unknowns_);
    for (std::size_t ring = 0; ring < result.size(); ++ring) {
        const auto first = static_cast<Eigen::Index>(3 * ring);
        result[ring].interaction_I = sums[first];
        result[ring].interaction_II = sums[first + 1];
        result[ring].interaction_T = sums[first + 2];
    }
    return result;
}

std::vector<DomainIntegral> RingForms::values_with_initial_stress(const CoarseElements& elements,
                                                                  const Eigen::VectorXd& u) const {
    return summed_up(elements, u, true);
}

std::vector<DomainIntegral> RingForms::summed_up(const CoarseElements& elements, const Eigen::VectorXd& u,
                                                 bool with_initial_stress) const {
    const Scene& scene = elements.scene();
    const Elasticity& elastic = scene.elastic(scene.enriched.tips[at(tip_)]);
    const MandelMatrix stiffness = elastic.stiffness();
    RingSums sums = sums_about(scene, tip_, rings_, elements.near(), with_initial_stress);
    elements.for_each(sums.elements(), [&](const auto& op) {
        sums.enter(op.element);
        const auto local = gather(u, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const Vec2& x = op.points[q].x;
            Mandel stress = stiffness * op.strain(local, q);
            if (with_initial_stress) stress += scene.initial_stress(op.element, x);
            sums.add(op.points[q], stress, op.displacement_gradient(local, q), elastic.energy(stress));
            if (with_initial_stress)
                sums.add_initial(op.points[q], stress,
                                 scene.initial_stress().slope(x, scene.mesh.material_of(op.element), sums.direction()));
        }
        sums.forget_points();
    });
    return {sums.values().begin(), sums.values().end()};
}

}  // namespace stria::coarse
