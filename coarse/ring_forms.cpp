#include "coarse/ring_forms.hpp"

#include "coarse/rings.hpp"
#include "coarse/structure.hpp"

namespace stria::coarse {
namespace {

/// Adds the adjoint of sigma = C eps(u), grad u at point q: what the weights of both make of each element value.
template <class Operator, class Values>
void add_adjoint(const Operator& op, std::size_t q, const MandelMatrix& elastic, const MutualWeights& weights,
                 Values& local) {
    op.add_force(elastic * weights.stress, q, local);
    const auto& gradients = op.gradients[q];
    local.reshaped(2, gradients.rows()) += op.points[q].weight * weights.gradient * gradients.transpose();
}

}  // namespace

RingSums RingForms::sums(const Structure& structure) const {
    const Scene& scene = structure.scene();
    return {scene.enriched, scene.enriched.tips[static_cast<std::size_t>(tip_)], scene.elastic, rings_};
}

RingForms::RingForms(const Structure& structure, int tip)
    : tip_(tip), rings_(rings_about(structure.scene(), tip)), entered_(structure.in_zone().size(), 0) {
    const Scene& scene = structure.scene();
    const Tip& about = scene.enriched.tips[static_cast<std::size_t>(tip)];
    const MandelMatrix elastic = scene.elastic.stiffness();
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    interaction_.assign(rings_.size(), {zero, zero, zero});
    RingSums geometry = sums(structure);
    structure.for_each_operator([&](int element) { return geometry.enter(element); },
                                [&](const auto& op) {
                                    entered_[static_cast<std::size_t>(op.element)] = 1;
                                    for (std::size_t q = 0; q < op.points.size(); ++q) {
                                        const std::array<TipField, 3> fields = geometry.auxiliary(op.points[q]);
                                        geometry.for_each_ring(op.points[q], [&](std::size_t ring, const Vec2& dq) {
                                            for (std::size_t mode = 0; mode < fields.size(); ++mode) {
                                                auto local = gather(zero, op.unknowns);
                                                add_adjoint(op, q, elastic, mutual_weights(about, fields[mode], dq),
                                                            local);
                                                interaction_[ring][mode](op.unknowns) += local;
                                            }
                                        });
                                    }
                                });
}

std::vector<DomainIntegral> RingForms::values(const Structure& structure, const Eigen::VectorXd& u) const {
    RingSums own = sums(structure);
    const MandelMatrix elastic = structure.scene().elastic.stiffness();
    const auto in_a_ring = [&](int element) {
        return entered_[static_cast<std::size_t>(element)] != 0 && own.enter(element);
    };
    structure.for_each_operator(in_a_ring, [&](const auto& op) {
        const auto local = gather(u, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const Mandel strain = op.strain(local, q), stress = elastic * strain;
            own.add_J(op.points[q], stress, op.displacement_gradient(local, q), 0.5 * stress.dot(strain));
        }
    });
    std::vector<DomainIntegral> result(own.values().begin(), own.values().end());
    for (std::size_t ring = 0; ring < result.size(); ++ring) {
        result[ring].interaction_I = interaction_[ring][0].dot(u);
        result[ring].interaction_II = interaction_[ring][1].dot(u);
        result[ring].interaction_T = interaction_[ring][2].dot(u);
    }
    return result;
}

}  // namespace stria::coarse
