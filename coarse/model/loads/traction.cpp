#include "coarse/model/loads/traction.hpp"

#include <algorithm>
#include <cmath>

#include "common/fem/quadrature.hpp"

namespace stria::coarse {
namespace {

constexpr int order_on_arc = 16;

/// The edge's direction towards growing x, or y where it stands upright.
Vec2 along(const Vec2& inward_normal) {
    const Vec2 tangent(inward_normal.y(), -inward_normal.x());
    const double leading = std::abs(tangent.x()) >= std::abs(tangent.y()) ? tangent.x() : tangent.y();
    return leading > 0.0 ? tangent : Vec2(-tangent);
}

void add_gauss(std::vector<EdgePoint>& points, const EdgeGeometry& edge, double from, double to, int order) {
    const double part = to - from;
    for (const LinePoint& point : gauss_line(order))
        points.push_back({from + 0.5 * (1.0 + point.xi) * part, 0.5 * point.weight * part * edge.length()});
}

std::vector<EdgePoint> points_under_hertz(const Traction& traction, const EdgeGeometry& edge, double from, double to) {
    const HertzPressure& hertz = *traction.hertz;
    const Vec2 direction = along(edge.inward_normal());
    const auto place = [&](double fraction) {  // -1 and 1: where it ends
        return ((edge.at(fraction) - traction.origin).dot(direction) - hertz.middle) / hertz.half_width;
    };
    const double start = place(from), end = place(to);
    const auto angle = [](double at) { return std::asin(std::clamp(at, -1.0, 1.0)); };
    const double first = angle(std::min(start, end)), last = angle(std::max(start, end));
    std::vector<EdgePoint> points;
    if (first == last) return points;
    for (const LinePoint& point : gauss_line(order_on_arc)) {
        const double psi = 0.5 * (first + last) + 0.5 * (last - first) * point.xi;
        const double fraction = from + (to - from) * (std::sin(psi) - start) / (end - start);
        points.push_back({fraction, 0.5 * point.weight * (last - first) * std::cos(psi) * hertz.half_width});
    }
    return points;
}

/// The cosine turns to zero at most once on an edge.
std::vector<EdgePoint> points_under_cosine(const Traction& traction, const EdgeGeometry& edge, double from, double to) {
    const CosinePressure& cosine = *traction.cosine;
    std::vector<double> breaks{from, to};
    if (cosine.centre) {
        const double start = (edge.from - *cosine.centre).dot(cosine.direction);
        const double end = (edge.to - *cosine.centre).dot(cosine.direction);
        const double zero = start / (start - end);
        if (zero > from && zero < to) breaks.insert(breaks.begin() + 1, zero);
    }
    std::vector<EdgePoint> points;
    for (std::size_t k = 0; k + 1 < breaks.size(); ++k) add_gauss(points, edge, breaks[k], breaks[k + 1], order_on_arc);
    return points;
}

}  // namespace

double HertzPressure::at(double place) const {
    const double share = (place - middle) / half_width;
    return std::abs(share) < 1.0 ? p0 * std::sqrt((1.0 - share) * (1.0 + share)) : 0.0;
}

Vec2 CosinePressure::at(const Vec2& x, const Vec2& inward_normal) const {
    Vec2 radial = inward_normal;
    if (centre) {
        radial = (x - *centre).normalized();
        if (radial.dot(inward_normal) < 0.0) radial = -radial;
    }
    return std::max(0.0, radial.dot(direction)) * radial;
}

Vec2 Traction::at(const Vec2& x, const Vec2& inward_normal) const {
    if (hertz) {
        const Vec2 direction = along(inward_normal);
        const double p = hertz->at((x - origin).dot(direction));
        return p * inward_normal + hertz->friction * p * direction;
    }
    if (cosine) return constant + gradient * (x - origin) + pressure * cosine->at(x, inward_normal);
    return constant + gradient * (x - origin) + pressure * inward_normal;
}

std::vector<EdgePoint> edge_points(const Traction& traction, const EdgeGeometry& edge, double from, double to,
                                   int order) {
    if (traction.hertz) return points_under_hertz(traction, edge, from, to);
    if (traction.cosine) return points_under_cosine(traction, edge, from, to);
    std::vector<EdgePoint> points;
    add_gauss(points, edge, from, to, order);
    return points;
}

}  // namespace stria::coarse
