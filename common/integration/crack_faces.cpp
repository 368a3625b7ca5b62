#include "common/integration/crack_faces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/crack/crack_crossings.hpp"
#include "common/enrichment/element_basis.hpp"
#include "common/fem/centre.hpp"
#include "common/fem/quadrature.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"
#include "common/integration/cut_element.hpp"
#include "common/regula_falsi.hpp"

namespace stria {
namespace {

/// The functions of an element on either side of a crack: room that serves station after station.
struct Traces {
    BasisValues plus, minus;
};

FaceStation make_station(const ElementBasis& basis, const CrackPiece& piece, const Vec2& x, const Vec2& tangent,
                         double s, double weight, Traces& traces) {
    auto& [plus, minus] = traces;
    FaceStation station;
    station.crack = piece.crack;
    station.element = piece.element;
    station.s = s;
    station.weight = weight;
    station.x = x;
    station.tangent = tangent;
    station.normal = {-tangent.y(), tangent.x()};
    const Vec2 xi = map_to_parent(basis.corners(), x);
    station.shape = shape_values(xi);
    basis.evaluate(xi, x, 1, plus);
    basis.evaluate(xi, x, -1, minus);
    station.terms.reserve(at(basis.functions()) / 2);  // half of the functions of most elements jump
    for (int f = 0; f < basis.functions(); ++f) {
        const double value = plus.value[f] - minus.value[f];
        const double slope = (plus.gradient.row(f) - minus.gradient.row(f)).dot(tangent);
        if (std::abs(value) > 1e-14) station.terms.push_back({basis.unknowns()[at(2 * f)], value, slope});
    }
    return station;
}

/// An arc length and the length that it stands for.
struct Place {
    double s, weight;
};

std::vector<Place> gauss_places(double first, double last, int gauss) {
    std::vector<Place> places;
    for (const LinePoint& point : gauss_line(gauss))
        places.push_back({first + 0.5 * (1.0 + point.xi) * (last - first), 0.5 * point.weight * (last - first)});
    return places;
}

/// Gauss points of v = sqrt(|s - centre|): what is a polynomial in v, divided by v, is integrated exactly.
std::vector<Place> places_about(double centre, double first, double last, int gauss) {
    const double v_first = std::sqrt(std::abs(first - centre)), v_last = std::sqrt(std::abs(last - centre));
    const double sign = first + last > 2.0 * centre ? 1.0 : -1.0;
    std::vector<Place> places;
    for (const LinePoint& point : gauss_line(gauss)) {
        const double v = v_first + 0.5 * (1.0 + point.xi) * (v_last - v_first);
        places.push_back({centre + sign * v * v, point.weight * v * std::abs(v_last - v_first)});
    }
    return places;
}

/// A straight part of a crack, between two places, with their arc lengths.
struct Stretch {
    Vec2 from, to;
    double first, last;

    [[nodiscard]] double length() const { return last - first; }
    [[nodiscard]] double distance(const Vec2& x) const { return distance_to_segment(x, from, to); }
    [[nodiscard]] bool leads_to(const Tip& tip) const {
        const Vec2 d = to - from, to_tip = tip.position - from;
        const double nearest = std::min(std::abs(tip.s - first), std::abs(tip.s - last));
        return std::abs(cross(d, to_tip)) <= 1e-9 * d.norm() * to_tip.norm() &&
               std::abs(distance(tip.position) - nearest) <= 1e-9 * (length() + nearest);
    }
};

/// Of functions of sqrt(r) on the way straight to a tip, exactly. Beside a bend r is no arc length, and the rule is
/// repeated on parts that are no longer than their distance to the tip; nearer than `shortest` they do next to no work.
void add_places(const Tip& tip, const Stretch& part, double shortest, int gauss, std::vector<Place>& places) {
    if (!part.leads_to(tip) && part.length() > std::max(shortest, part.distance(tip.position))) {
        const Vec2 middle = 0.5 * (part.from + part.to);
        const double s = 0.5 * (part.first + part.last);
        add_places(tip, {part.from, middle, part.first, s}, shortest, gauss, places);
        add_places(tip, {middle, part.to, s, part.last}, shortest, gauss, places);
        return;
    }
    const std::vector<Place> own = part.leads_to(tip) ? places_about(tip.s, part.first, part.last, gauss)
                                                      : gauss_places(part.first, part.last, gauss);
    places.insert(places.end(), own.begin(), own.end());
}

/// Of the tips whose functions act in a piece's element, that of the same crack nearest to an arc length; else null.
const Tip* tip_with_functions_on(const EnrichedMesh& mesh, const CrackPiece& piece, double s) {
    const Tip* nearest = nullptr;
    for (const int node : mesh.elements[at(piece.element)]) {
        for (const Term& term : mesh.terms[at(node)]) {
            if (term.kind != Term::Kind::Tip && term.kind != Term::Kind::Gathered) continue;
            const Tip& tip = mesh.tip_of(term);
            if (tip.crack != piece.crack) continue;
            if (nearest == nullptr || std::abs(tip.s - s) < std::abs(nearest->s - s)) nearest = &tip;
        }
    }
    return nearest;
}

FaceStation nowhere(int crack, double s) {
    FaceStation station;
    station.crack = crack;
    station.s = s;
    return station;
}

/// The arc lengths that a mesh holds of a tip's crack, and which way they lead from the tip: +1 or -1.
struct Held {
    double first = 1e300, last = -1e300;
    double direction = 1.0;

    Held(const EnrichedMesh& mesh, const Tip& tip) {
        for (const CrackPiece& piece : mesh.pieces) {
            if (piece.crack != tip.crack) continue;
            first = std::min(first, piece.s.front());
            last = std::max(last, piece.s.back());
        }
        if (std::abs(tip.s - last) < std::abs(tip.s - first)) direction = -1.0;
    }
};

/// Stations at the places that a rule puts between the ends of each interface element.
template <class Rule>
std::vector<FaceStation> stations_of(const EnrichedMesh& mesh, int crack, int subcells, const Rule& places_between) {
    std::vector<FaceStation> stations;
    Traces traces;
    for (const CrackPiece& piece : mesh.pieces) {
        if (piece.crack != crack) continue;
        // Both traces along an edge come from the functions of one of its elements: it counts as cut.
        const ElementBasis basis(mesh, piece.element, true);
        const InterfacePoints ends = interface_elements(basis.corners(), piece, subcells);
        for (std::size_t k = 0; k + 1 < ends.points.size(); ++k) {
            const Vec2 d = ends.points[k + 1] - ends.points[k];
            const double length = ends.s[k + 1] - ends.s[k];
            for (const auto& [s, weight] :
                 places_between(piece, Stretch{ends.points[k], ends.points[k + 1], ends.s[k], ends.s[k + 1]})) {
                const Vec2 x = ends.points[k] + (s - ends.s[k]) / length * d;
                stations.push_back(make_station(basis, piece, x, d.normalized(), s, weight, traces));
            }
        }
    }
    return stations;
}

}  // namespace

Vec2 FaceStation::jump(const Eigen::VectorXd& u) const {
    Vec2 sum = fixed_jump;
    for (const Term& term : terms) sum += term.value * u.segment<2>(term.unknown);
    return sum;
}

double FaceStation::slope(const Eigen::VectorXd& u, const Vec2& direction) const {
    double sum = 0.0;
    for (const Term& term : terms) sum += term.slope * u.segment<2>(term.unknown).dot(direction);
    return sum;
}

std::vector<FaceStation> face_stations(const EnrichedMesh& mesh, int crack, int subcells, int gauss) {
    constexpr double shortest = 1e-3;  // of the element: sqrt(r) does 3e-5 of its work there
    return stations_of(mesh, crack, subcells, [&](const CrackPiece& piece, const Stretch& part) {
        const Tip* tip = tip_with_functions_on(mesh, piece, 0.5 * (part.first + part.last));
        if (tip == nullptr) return gauss_places(part.first, part.last, gauss);
        std::vector<Place> places;
        add_places(*tip, part, shortest * diagonal(mesh, piece.element), gauss, places);
        return places;
    });
}

std::vector<FaceStation> face_stations_about(const EnrichedMesh& mesh, const Tip& tip, int subcells, int gauss) {
    return stations_of(mesh, tip.crack, subcells, [&](const CrackPiece&, const Stretch& part) {
        return places_about(tip.s, part.first, part.last, gauss);
    });
}

FaceStation face_station_at(const EnrichedMesh& mesh, int crack, double s) {
    for (const CrackPiece& piece : mesh.pieces) {
        if (piece.crack != crack || s < piece.s.front() || s > piece.s.back()) continue;
        const auto after = std::ranges::upper_bound(piece.s, s);
        const auto k = at(std::clamp<std::ptrdiff_t>(after - piece.s.begin(), 1, std::ssize(piece.s) - 1));
        const Vec2 d = piece.points[k] - piece.points[k - 1];
        const double t = (s - piece.s[k - 1]) / (piece.s[k] - piece.s[k - 1]);
        Traces traces;
        return make_station(ElementBasis(mesh, piece.element, true), piece, piece.points[k - 1] + t * d, d.normalized(),
                            s, 0.0, traces);
    }
    return nowhere(crack, s);
}

FaceStation face_station_at_mouth(const EnrichedMesh& mesh, int crack) {
    const double s = mesh.mouths[at(crack)];
    return std::isnan(s) ? nowhere(crack, s) : face_station_at(mesh, crack, s);
}

FaceStation face_station_behind(const EnrichedMesh& mesh, const Tip& tip, double distance) {
    if (distance <= 0.0) return nowhere(tip.crack, tip.s);
    return face_station_at(mesh, tip.crack, tip.s + Held(mesh, tip).direction * distance);
}

std::optional<double> arc_length_at(const EnrichedMesh& mesh, int crack, const Vec2& x) {
    for (const CrackPiece& piece : mesh.pieces) {
        if (piece.crack != crack) continue;
        const double beside = snap_fraction * diagonal(mesh, piece.element);
        for (std::size_t k = 0; k + 1 < piece.points.size(); ++k) {
            const Vec2 d = piece.points[k + 1] - piece.points[k], to_x = x - piece.points[k];
            const double t = to_x.dot(d) / d.squaredNorm();
            if (t < -1e-9 || t > 1.0 + 1e-9 || (to_x - t * d).norm() > beside) continue;
            return piece.s[k] + std::clamp(t, 0.0, 1.0) * (piece.s[k + 1] - piece.s[k]);
        }
    }
    return std::nullopt;
}

double opening_at_intercept(const EnrichedMesh& mesh, const Tip& tip, const Eigen::VectorXd& u) {
    return opening_at_intercept(mesh, tip, [&](const FaceStation& station) { return station.opening(u); });
}

double opening_at_intercept(const EnrichedMesh& mesh, const Tip& tip,
                            const std::function<double(const FaceStation&)>& opening) {
    const Held held(mesh, tip);
    if (held.first > held.last) return -1.0;
    const double reach = held.last - held.first;
    const auto excess = [&](double r) {
        const FaceStation station = face_station_at(mesh, tip.crack, tip.s + held.direction * r);
        return opening(station) - 2.0 * r;
    };
    // The opening starts like r^p, above 2 r; walk outwards geometrically to the first change of sign.
    double inner = 1e-9 * reach, at_inner = excess(inner);
    if (at_inner <= 0.0) return 0.0;
    double outer = 1.5 * inner, at_outer = excess(outer);
    while (at_outer > 0.0) {
        inner = std::exchange(outer, 1.5 * outer);
        if (outer >= reach) return -1.0;
        at_inner = std::exchange(at_outer, excess(outer));
    }
    RegulaFalsi root;  // of what is left of the excess, in parts of the way between the two
    constexpr int most = 60;
    for (int k = 0; k < most; ++k) {
        const double from = root.guess();
        root.narrow(k == 0 ? at_outer / at_inner : excess(inner + from * (outer - inner)) / at_inner);
        if (std::abs(root.guess() - from) < 1e-15) break;
    }
    return 2.0 * (inner + root.guess() * (outer - inner));
}

}  // namespace stria
