#include "fine/contact/face_operators.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <tuple>
#include <utility>

#include "common/case/case_questions.hpp"
#include "common/geometry/segment.hpp"

namespace stria::fine {
namespace {

constexpr int points_of_element = 4;       // Gauss points of an interface element
constexpr double rounding_of_gap = 1e-14;  // of the terms that it is the sum of

/// Arc length, of a crack with two tips: its middle, and by so little nearer to one end, the lower in x, then in y,
/// that of two crossings as far from the middle rounding does not choose.
double place_of_origin(const std::vector<Vec2>& points) {
    constexpr double aside = 1e-6;  // of the length
    const Vec2 &first = points.front(), &last = points.back();
    const bool ascends = std::pair(first.x(), first.y()) < std::pair(last.x(), last.y());
    return (ascends ? 0.5 - aside : 0.5 + aside) * length_of(points);
}

bool is_smooth(const ContactSection& contact, double s) {
    return !contact.smooth.empty() && s > contact.smooth[0] && s < contact.smooth[1];
}

}  // namespace

/// Each node's share of the cracks, branch by branch.
class FaceOperators::Shares {
public:
    Shares(const FaceOperators& faces, const EnrichedMesh& mesh) : faces_(faces) {
        for (const FaceStation& station : faces.stations_) {
            for (int k = 0; k < 4; ++k) {
                const int node = mesh.elements[at(station.element)][at(k)];
                for (const auto& [holder, part] : mesh.holders_of_jump(node)) {
                    Share& share = shares_[key(station, holder)];
                    share.length += part * station.weight * station.shape[k];
                    share.moment += part * station.weight * station.shape[k] * station.s;
                }
            }
        }
    }

    /// Adds the length of each node to the multipliers that act at its place.
    void weigh(Eigen::VectorXd& weight) const {
        for (const auto& [key, share] : shares_) {
            if (share.length <= 0.0) continue;
            for (const auto& [multiplier, value] : faces_.functions_at(std::get<0>(key), share.moment / share.length))
                if (multiplier >= 0) weight[multiplier] += value * share.length;
        }
    }

    /// Arc length at which the jump counts that a node makes at a station: the centroid of its share. Where the zone
    /// has the node no longer it is the station's.
    [[nodiscard]] double place(const FaceStation& station, int node) const {
        const auto share = shares_.find(key(station, node));
        return share != shares_.end() ? share->second.moment / share->second.length : station.s;
    }

private:
    struct Share {
        double length = 0.0, moment = 0.0;  // integrals of N_i and of N_i s
    };
    using Key = std::tuple<int, int, int>;  // crack, branch, node
    [[nodiscard]] Key key(const FaceStation& station, int node) const {
        return {station.crack, faces_.space_of(station.crack).space.branch(station.s), node};
    }

    const FaceOperators& faces_;
    std::map<Key, Share> shares_;
};

FaceOperators::FaceOperators(const EnrichedMesh& mesh, const std::vector<int>& boundary,
                             const std::vector<CrackSection>& cracks, int subcells, const FrozenTips& frozen) {
    int count = 0;
    for (int crack = 0; crack < static_cast<int>(cracks.size()); ++crack) {
        const CrackSection& section = cracks[at(crack)];
        const Notch notch = notch_of(section, mesh.grown_at_start_of(crack));
        for (FaceStation& station : face_stations(mesh, crack, subcells, points_of_element)) {
            station.fixed_jump = frozen.jump(crack, station.x);
            const bool meets = may_touch(section) && !notch.holds(station.s);
            (meets ? stations_ : free_stations_).push_back(std::move(station));
        }
        if (!may_touch(section)) continue;
        spaces_.push_back({crack, count, space_on(mesh, boundary, crack, section)});
        const MultiplierSpace& space = spaces_.back().space;
        count += space.size();
        for (int k = 0; k < space.size(); ++k) {
            const double s = space.nodes()[at(k)];
            keys_.push_back({crack, s, face_station_at(mesh, crack, s).x});
            middle_.push_back(space.middle(k));
        }
    }
    std::ranges::transform(stations_, std::back_inserter(acting_),
                           [&](const FaceStation& station) { return functions_at(station); });
    B_.resize(count, mesh.unknowns);
    T_.resize(count, mesh.unknowns);
    weight_ = friction_ = fixed_gap_ = fixed_slip_ = Eigen::VectorXd::Zero(count);
    number_shears(cracks);
    const Shares shares(*this, mesh);
    shares.weigh(weight_);
    assemble(mesh, shares);
    add_frozen(mesh, shares, frozen);
    keep_open_without_faces();
}

MultiplierSpace FaceOperators::space_on(const EnrichedMesh& mesh, const std::vector<int>& boundary, int crack,
                                        const CrackSection& section) const {
    if (section.contact->multipliers == MultiplierKind::Stable) {
        const double mouth = mesh.mouths[at(crack)], grown = mesh.grown_at_start_of(crack);
        const double origin = std::isnan(mouth) ? grown + place_of_origin(section.points) : mouth;
        return MultiplierSpace(mesh, boundary, crack, notch_of(section, grown), origin);
    }
    std::vector<double> points;
    for (const FaceStation& station : stations_)
        if (station.crack == crack) points.push_back(station.s);
    std::ranges::sort(points);
    return MultiplierSpace(points);
}

void FaceOperators::number_shears(const std::vector<CrackSection>& cracks) {
    shear_of_.assign(at(multipliers()), -1);
    for (int k = 0; k < multipliers(); ++k) friction_[k] = cracks[at(keys_[at(k)].crack)].contact->friction;
    if (std::ranges::any_of(cracks, [](const auto& crack) { return crack.contact && !crack.contact->smooth.empty(); }))
        friction_.array() *= rough_shares(cracks).array();
    for (int k = 0; k < multipliers(); ++k) {
        if (friction_[k] == 0.0) continue;
        shear_of_[at(k)] = tractions();
        with_shear_.push_back(k);
    }
}

Eigen::VectorXd FaceOperators::rough_shares(const std::vector<CrackSection>& cracks) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(multipliers()), smooth = all;  // mm
    for (const FaceStation& station : stations_) {
        for (const auto& [multiplier, value] : functions_at(station)) {
            if (multiplier < 0) continue;
            all[multiplier] += station.weight * value;
            if (is_smooth(*cracks[at(station.crack)].contact, station.s)) smooth[multiplier] += station.weight * value;
        }
    }
    return 1.0 - (all.array() > 0.0).select(smooth.cwiseQuotient(all), 0.0).array().max(0.0).min(1.0);
}

void FaceOperators::assemble(const EnrichedMesh& mesh, const Shares& shares) {
    std::vector<int> node_of(at(mesh.unknowns));
    for (const auto& [node, term, unknown] : mesh.own_unknowns()) node_of[at(unknown)] = node;
    std::vector<Triplet> entries, entries_T;
    for (const FaceStation& station : stations_) {
        for (const FaceStation::Term& term : station.terms) {
            const double place = shares.place(station, node_of[at(term.unknown)]);
            for (const auto& [multiplier, value] : functions_at(station.crack, place)) {
                if (multiplier < 0) continue;
                for (int c = 0; c < 2; ++c) {
                    const double push = station.weight * value * term.value * station.normal[c];
                    if (push != 0.0) entries.emplace_back(multiplier, term.unknown + c, push);
                    const double pull = station.weight * value * term.value * station.tangent[c];
                    if (pull != 0.0 && shear_of(multiplier) >= 0)
                        entries_T.emplace_back(multiplier, term.unknown + c, pull);
                }
            }
        }
    }
    B_.setFromTriplets(entries.begin(), entries.end());
    T_.setFromTriplets(entries_T.begin(), entries_T.end());
}

void FaceOperators::add_frozen(const EnrichedMesh& mesh, const Shares& shares, const FrozenTips& frozen) {
    const auto index_of = [&](int node_id) {
        const auto found = std::ranges::lower_bound(mesh.node_ids, node_id);
        const bool is_there = found != mesh.node_ids.end() && *found == node_id;
        return is_there ? static_cast<int>(found - mesh.node_ids.begin()) : -1;
    };
    for (const FaceStation& station : stations_) {
        for (const auto& [node_id, jump, slope] : frozen.shares_of_jump(station.crack, station.x)) {
            for (const auto& [multiplier, value] :
                 functions_at(station.crack, shares.place(station, index_of(node_id)))) {
                if (multiplier < 0) continue;
                fixed_gap_[multiplier] += station.weight * value * jump.dot(station.normal);
                fixed_slip_[multiplier] += station.weight * value * jump.dot(station.tangent);
            }
        }
    }
}

// Between a notch or a bend and the tip there may be less of the crack than from one point of integration to the next.
void FaceOperators::keep_open_without_faces() {
    for (Eigen::Index k = 0; k < weight_.size(); ++k) {
        if (weight_[k] > 0.0) continue;
        weight_[k] = fixed_gap_[k] = 1.0;
    }
}

const FaceOperators::CrackSpace& FaceOperators::space_of(int crack) const {
    return *std::ranges::find(spaces_, crack, &CrackSpace::crack);
}

FaceOperators::Acting FaceOperators::functions_at(int crack, double s) const {
    const CrackSpace& entry = space_of(crack);
    auto values = entry.space.acting_at(s);
    for (auto& value : values)
        if (value.multiplier >= 0) value.multiplier += entry.first_multiplier;
    return values;
}

Eigen::VectorXd FaceOperators::gaps(const Eigen::VectorXd& u) const {
    Eigen::VectorXd gaps(multipliers());
    for (int k = 0; k < multipliers(); ++k) gaps[k] = gap(k, u);
    return gaps;
}

Eigen::VectorXd FaceOperators::slips(const Eigen::VectorXd& u) const {
    return (T_ * u + fixed_slip_).cwiseQuotient(weight_);
}

double FaceOperators::gap(int k, const Eigen::VectorXd& u) const {
    double sum = 0.0, size = std::abs(fixed_gap_[k]);
    for (SparseRows::InnerIterator it(B_, k); it; ++it) {
        sum += it.value() * u[it.col()];
        size += std::abs(it.value() * u[it.col()]);
    }
    sum += fixed_gap_[k];
    return std::abs(sum) > rounding_of_gap * size ? sum / weight_[k] : 0.0;
}

double FaceOperators::work_by_trapezoid(const End& from, const End& to) const {
    double sum = 0.0;
    for (int k = 0; k < multipliers(); ++k) {
        const double before = from.traction[k], after = to.traction[k];
        if (before > 0.0 && after <= 0.0) sum += 0.5 * weight_[k] * before * gap(k, to.u);
        if (before <= 0.0 && after > 0.0) sum -= 0.5 * weight_[k] * after * gap(k, from.u);
    }
    return sum;
}

double FaceOperators::slip(int k, const Eigen::VectorXd& u) const {
    return (T_.row(k).dot(u) + fixed_slip_[k]) / weight_[k];
}

void FaceOperators::add_force(const Eigen::VectorXd& traction, Eigen::VectorXd& force) const {
    force -= B_.transpose() * traction.head(multipliers());
    for (std::size_t j = 0; j < with_shear_.size(); ++j) {
        for (SparseRows::InnerIterator it(T_, with_shear_[j]); it; ++it)
            force[it.col()] += it.value() * traction[multipliers() + static_cast<Eigen::Index>(j)];
    }
}

std::vector<int> FaceOperators::acts_on(int k) const {
    std::vector<int> unknowns;
    for (SparseRows::InnerIterator it(B_, k); it; ++it) unknowns.push_back(static_cast<int>(it.col()));
    const auto normal = std::ssize(unknowns);
    for (SparseRows::InnerIterator it(T_, k); it; ++it)
        if (!std::binary_search(unknowns.begin(), unknowns.begin() + normal, static_cast<int>(it.col())))
            unknowns.push_back(static_cast<int>(it.col()));
    return unknowns;
}

std::vector<int> FaceOperators::places_in(const FaceOperators& others) const {
    const int count = others.multipliers();
    std::vector<int> places(keys_.size(), -1);
    int next = 0;
    for (std::size_t k = 0; k < keys_.size(); ++k) {
        for (int tried = 0; tried < count; ++tried) {
            const int other = (next + tried) % count;
            if (!others.keys_[at(other)].is_at(keys_[k].crack, keys_[k].x)) continue;
            places[k] = other;
            next = other + 1;
            break;
        }
    }
    return places;
}

std::int64_t FaceOperators::interface_elements() const {
    return (std::ssize(stations_) + points_of_element - 1) / points_of_element;
}

}  // namespace stria::fine
