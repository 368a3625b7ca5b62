#include "fine/bulk/elastic_answers.hpp"

namespace stria::fine {

namespace {

/// What is at a point where it stands, and per motion.
ElasticPoint standing_point(const Bulk& bulk, EnergyDensity density, int e, std::size_t q) {
    const BulkElements& elements = bulk.elements();
    const PointHistory& history = bulk.history();
    const ElementKernel<4> kernel(elements.op(e));
    const Eigen::Matrix<double, 2, 4> stand = kernel.nodal(bulk.standing().displacement(e).data());
    const Mandel stress = history.stress(e, q);
    const Eigen::Matrix<double, 4, 6> strain = kernel.strain_matrix(q).rightCols<6>();
    return {.stress = stress,
            .work = density == EnergyDensity::StressWork ? history.work(e, q) : elements.elastic(e).energy(stress),
            .gradient = kernel.displacement_gradient(stand, q) + history.frozen_gradient(e, q),
            .functions = elements.op(e).gradients[q].bottomRows<3>(),
            .strain = strain,
            .stress_change = elements.elastic_stiffness(e) * strain};
}

}  // namespace

std::span<const ElasticResponse> ElasticAnswers::of(const Bulk& bulk, EnergyDensity density, const Vec2& along,
                                                    int element) {
    if (known_.empty() || density != density_ || along != along_) {
        known_.assign(at(bulk.elements().count()), {});
        density_ = density;
        along_ = along;
    }
    Known& known = known_[at(element)];
    const int stand = bulk.standing().times_moved(element);
    if (known.stand == stand) return known.points;
    known.stand = stand;
    known.points.clear();
    const std::vector<IntegrationPoint>& points = bulk.elements().op(element).points;
    known.points.reserve(points.size());
    for (std::size_t q = 0; q < points.size(); ++q, ++made_)
        known.points.emplace_back(standing_point(bulk, density, element, q), points[q].weight, along);
    return known.points;
}

}  // namespace stria::fine
