#include "common/fracture/elastic_share.hpp"

#include "common/fracture/energy_momentum.hpp"

namespace stria {

ElasticResponse::ElasticResponse(const ElasticPoint& point, double area, const Vec2& along)
    : along_(along), slope_(point.gradient * along), stress_(point.stress), work_(point.work),
      functions_(point.functions * along), xx_(point.stress_change.row(0)), yy_(point.stress_change.row(1)),
      xy_(point.stress_change.row(3) / std::numbers::sqrt2), strained_(point.strain.transpose() * point.stress),
      turn_(area * rotation(point.gradient)) {
    double* energy = energy_.data();
    for (Eigen::Index i = 0; i < 6; ++i) {
        for (Eigen::Index j = 0; j < i; ++j) *energy++ = point.strain.col(i).dot(point.stress_change.col(j));
        *energy++ = 0.5 * point.strain.col(i).dot(point.stress_change.col(i));
    }
    for (Eigen::Index k = 0; k < 3; ++k)
        turns_.segment<2>(2 * k) = 0.5 * area * Vec2(-point.functions(k, 1), point.functions(k, 0));
}

void ElasticShare::add(const ElasticResponse& point, const Vec2& dq, std::span<const AuxiliaryField, 3> fields) {
    add_momentum(point, dq);
    const Mandel& stress = point.stress_;
    for (std::size_t mode = 0; mode < fields.size(); ++mode) {
        const MutualWeights weights(fields[mode], point.along_, dq);
        auto& [standing, slope] = interactions_[mode];
        standing += weights.xx * stress[0] + weights.yy * stress[1] + weights.xy * stress[3] / std::numbers::sqrt2 +
                    weights.slope.dot(point.slope_);
        slope += weights.xx * point.xx_ + weights.yy * point.yy_ + weights.xy * point.xy_;
        for (Eigen::Index k = 0; k < 3; ++k) slope.segment<2>(2 * k) += point.functions_[k] * weights.slope;
    }
    rotation_.standing += point.turn_;
    rotation_.slope += point.turns_;
}

// energy_momentum() where stress and slope are those without motion and what each motion adds, by degrees.
void ElasticShare::add_momentum(const ElasticResponse& point, const Vec2& dq) {
    const double ahead = point.along_.dot(dq);
    const Vec2 own = in_plane(point.stress_) * dq;
    const std::array<NodeMotion, 2> traction{dq.x() * point.xx_ + dq.y() * point.xy_,
                                             dq.x() * point.xy_ + dq.y() * point.yy_};
    J_.standing += own.dot(point.slope_) - point.work_ * ahead;
    J_.slope += point.slope_.x() * traction[0] + point.slope_.y() * traction[1] - ahead * point.strained_;
    for (Eigen::Index k = 0; k < 3; ++k) J_.slope.segment<2>(2 * k) += point.functions_[k] * own;
    // The traction of motion i on the slope of motion j.
    const auto second = [&](Eigen::Index i, Eigen::Index j) {
        return traction[static_cast<std::size_t>(j % 2)][i] * point.functions_[j / 2];
    };
    std::size_t pair = 0;
    for (Eigen::Index i = 0; i < 6; ++i) {
        for (Eigen::Index j = 0; j < i; ++j, ++pair)
            curvature_[pair] += second(i, j) + second(j, i) - ahead * point.energy_[pair];
        curvature_[pair] += second(i, i) - ahead * point.energy_[pair];
        ++pair;
    }
}

DomainIntegral ElasticShare::at(const NodeMotion& motion) const {
    double bent = 0.0;
    const double* term = curvature_.data();
    for (Eigen::Index i = 0; i < 6; ++i) {
        double sum = 0.0;
        for (Eigen::Index j = 0; j <= i; ++j) sum += *term++ * motion[j];
        bent += sum * motion[i];
    }
    return {.J = J_.at(motion) + bent,
            .interaction_I = interactions_[0].at(motion),
            .interaction_II = interactions_[1].at(motion),
            .interaction_T = interactions_[2].at(motion),
            .rotation = rotation_.at(motion)};
}

}  // namespace stria
