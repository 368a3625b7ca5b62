#include "common/fracture/domain_integral.hpp"

#include <algorithm>

#include "common/fem/centre.hpp"
#include "common/index.hpp"

namespace stria {

RingSums::RingSums(const EnrichedMesh& mesh, const Tip& tip, const Elasticity& elastic, std::vector<Annulus> rings,
                   std::span<const int> among, bool with_inside)
    : mesh_(mesh), tip_(tip), elastic_(elastic), rings_(std::move(rings)), sums_(rings_.size()),
      of_places_(rings_.size()), auxiliary_(tip, elastic), weights_(mesh, tip, rings_, among, with_inside),
      known_(elements().size()) {}

bool RingSums::enter(int element) {
    place_ = next_place_;  // of most: they come in order
    if (place_ >= elements().size() || elements()[place_] != element) {
        const auto found = std::ranges::lower_bound(elements(), element);
        if (found == elements().end() || *found != element) return false;
        place_ = at(found - elements().begin());
    }
    next_place_ = place_ + 1;
    entered_ = weights_.of(place_);
    Known& known = known_[place_];
    points_are_known_ = std::exchange(known.points, true);
    if (!points_are_known_) {
        known.field = fields_.size();
        known.weighted = weighted_.size();
    }
    next_field_ = known.field;
    next_weighted_ = known.weighted;
    return true;
}

// Where the fields are known already nobody asks.
int RingSums::side_of(const IntegrationPoint& point) const {
    return point.side != 0 ? point.side : branch_side(mesh_, element());
}

void RingSums::look_at(const IntegrationPoint& point) {
    if (fields_.empty()) {
        constexpr std::size_t points = 4;  // of most elements
        fields_.reserve(points * elements().size());
        weighted_.reserve(points * weights_.entries());
    }
    fields_.push_back(auxiliary_.at(point.x, side_of(point)));
    const Eigen::Matrix<double, 4, 2> gradient = shape_q4(corners_of_element(mesh_, element()), point.xi).gradient;
    const Vec2 turn = turned(tip_.direction);
    std::array<Vec2, 3> back;
    std::ranges::transform(fields_.back(), back.begin(), [&](const AuxiliaryField& field) -> Vec2 {
        return {field.stress_xx * turn.x() + field.stress_xy * turn.y(),
                field.stress_xy * turn.x() + field.stress_yy * turn.y()};
    });
    for (const auto& [ring, q] : entered_) {
        const Vec2& weighted = weighted_.emplace_back(point.weight * (gradient.transpose() * q));
        const DomainIntegral of_place{.area = point.weight,
                                      .turned_I = back[0].dot(weighted),
                                      .turned_II = back[1].dot(weighted),
                                      .turned_T = back[2].dot(weighted)};
        sums_[ring] += of_place;
        of_places_[ring] += of_place;
    }
}

// energy_momentum() and its mutual part (MutualWeights), with what they have in common worked out once.
void RingSums::add(const IntegrationPoint& point, const Mandel& stress, const Eigen::Matrix2d& gradient, double work) {
    if (!points_are_known_) look_at(point);
    const Vec2 &along = tip_.direction, slope = gradient * along;
    const double xx = stress[0], yy = stress[1], xy = stress[3] / std::numbers::sqrt2;
    const auto traction = [&](const Vec2& of) { return Vec2(xx * of.x() + xy * of.y(), xy * of.x() + yy * of.y()); };
    const Vec2 own = traction(slope) - work * along;
    const double turn = point.weight * rotation(gradient);
    std::array<Vec2, 3> mutual;
    std::ranges::transform(fields_[next_field_++], mutual.begin(), [&](const AuxiliaryField& field) -> Vec2 {
        const Vec2 back(field.stress_xx * slope.x() + field.stress_xy * slope.y(),
                        field.stress_xy * slope.x() + field.stress_yy * slope.y());
        const double shared = xx * field.strain_xx + yy * field.strain_yy + xy * field.shear;
        return traction(field.slope) + back - shared * along;
    });
    for (const RingWeights::Entered& entered : entered_) {
        const Vec2& weighted = weighted_[next_weighted_++];
        sums_[entered.ring] += {.J = own.dot(weighted),
                                .interaction_I = mutual[0].dot(weighted),
                                .interaction_II = mutual[1].dot(weighted),
                                .interaction_T = mutual[2].dot(weighted),
                                .rotation = turn};
    }
}

void RingSums::begin_way_from(int stand) {
    Known& known = known_[place_];
    known.stand = stand;
    if (!known.share) {
        known.share = shares_.size();
        shares_.resize(shares_.size() + entered_.size());
    }
    std::ranges::fill(std::span(shares_).subspan(*known.share, entered_.size()), ElasticShare());
}

void RingSums::tell_way(const IntegrationPoint& point, const ElasticResponse& response) {
    if (!points_are_known_) look_at(point);
    const std::array<AuxiliaryField, 3>& fields = fields_[next_field_++];
    for (ElasticShare& share : std::span(shares_).subspan(*known_[place_].share, entered_.size()))
        share.add(response, weighted_[next_weighted_++], fields);
}

void RingSums::add_moved(const NodeMotion& motion) {
    const ElasticShare* share = &shares_[*known_[place_].share];
    for (const RingWeights::Entered& entered : entered_) sums_[entered.ring] += (share++)->at(motion);
}

void RingSums::add_initial(const IntegrationPoint& point, const Mandel& stress, const Mandel& slope) {
    const double own = elastic_.work(stress, slope);
    std::array<double, 3> mutual{};
    std::ranges::transform(fields_[next_field_ - 1], mutual.begin(), [&](const AuxiliaryField& field) {
        return Mandel(field.strain_xx, field.strain_yy, 0.0, field.shear / std::numbers::sqrt2).dot(slope);
    });
    const Eigen::Vector4d shape = shape_q4(corners_of_element(mesh_, element()), point.xi).value;
    for (const auto& [ring, q] : entered_) {
        const double weight = -point.weight * shape.dot(q);
        sums_[ring] += {.J = weight * own,
                        .interaction_I = weight * mutual[0],
                        .interaction_II = weight * mutual[1],
                        .interaction_T = weight * mutual[2]};
    }
}

void RingSums::add_mismatch(const IntegrationPoint& point, const Mandel& mismatch) {
    if (mismatch.isZero(0.0)) return;
    const ShapeQ4 shape = shape_q4(corners_of_element(mesh_, element()), point.xi);
    const std::array<Mandel, 3> slopes = auxiliary_.stress_slopes(point.x, side_of(point));
    const std::array<AuxiliaryField, 3>& fields = fields_[next_field_ - 1];
    for (const auto& [ring, q] : entered_) {
        const double here = shape.value.dot(q), ahead = tip_.direction.dot(shape.gradient.transpose() * q);
        const auto share = [&](std::size_t mode) {
            return point.weight * mismatch.dot(weighted_slope(fields[mode], slopes[mode], here, ahead));
        };
        sums_[ring] += {.interaction_I = share(0), .interaction_II = share(1), .interaction_T = share(2)};
    }
}

// With the tractions +-T on the faces, -(T . u_,1) q of both adds up to -T . d(jump)/dx_1 q (J), and likewise with the
// auxiliary jump (interaction). That of the point force is constant: it adds nothing. Auxiliary jumps begin where the
// faces end, which may be half an element off the tip: by their r^(-1/2) tractions near there count at a distance from
// it and not from the tip. The bulk's part, of rings about both, tells them apart by next to nothing.
void RingSums::add_faces(const FaceStation& station, const FaceLoad& load) {
    const double forward = station.tangent.dot(tip_.direction);
    Tip end = tip_;
    end.position = tip_.end_of_faces();
    const auto auxiliary_slopes = [&](int mode) {
        const Eigen::Matrix2d jump = williams_field(mode, end, station.x, 1, elastic_).gradient -
                                     williams_field(mode, end, station.x, -1, elastic_).gradient;
        const Vec2 slope = jump * tip_.direction;
        return std::pair(station.normal.dot(slope), station.tangent.dot(slope));
    };
    const double opening = load.opening_slope * forward, slip = load.slip_slope * forward;
    const auto [opening_I, slip_I] = auxiliary_slopes(1);
    const auto [opening_II, slip_II] = auxiliary_slopes(2);
    for (std::size_t ring = 0; ring < rings_.size(); ++ring) {
        const double q = corner_weights(mesh_, station.element, tip_, rings_[ring]).dot(station.shape);
        const double push = station.weight * load.pressure * q, drag = station.weight * load.shear * q;
        const double pressed_I = -push * opening_I, pressed_II = -push * opening_II;
        sums_[ring] += {.J = -push * opening + drag * slip,
                        .interaction_I = pressed_I + drag * slip_I,
                        .interaction_II = pressed_II + drag * slip_II,
                        .wake_I = load.in_wake ? pressed_I : 0.0,
                        .wake_II = load.in_wake ? pressed_II : 0.0};
    }
}

}  // namespace stria
