#include "fine/contact/contact_interface.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "common/index.hpp"

namespace stria::fine {
namespace {

constexpr int points_of_element = 4;  // Gauss points of an interface element

}  // namespace

ContactInterface::ContactInterface(const EnrichedMesh& mesh, const std::vector<int>& boundary,
                                   const std::vector<CrackSection>& cracks, int subcells, double stiffness,
                                   const FrozenTips& frozen) {
    int count = 0;
    for (int crack = 0; crack < static_cast<int>(cracks.size()); ++crack) {
        const CrackSection& section = cracks[at(crack)];
        if (!section.contact) continue;
        spaces_.push_back({crack, section.notch, count, MultiplierSpace(mesh, boundary, crack, section.notch)});
        const MultiplierSpace& space = spaces_.back().space;
        count += space.size();
        for (const double s : space.nodes()) keys_.push_back({crack, s, face_station_at(mesh, crack, s).x});
        for (FaceStation& station : face_stations(mesh, crack, subcells, points_of_element)) {
            if (station.s < section.notch) continue;
            station.fixed_jump = frozen.jump(crack, station.x);
            stations_.push_back(std::move(station));
        }
    }
    B_.resize(count, mesh.unknowns);
    weight_ = augmentation_ = fixed_gap_ = Eigen::VectorXd::Zero(count);
    status_.assign(at(count), 0);
    committed_status_ = status_;
    assemble(mesh, stiffness);
    find_closing();
}

void ContactInterface::assemble(const EnrichedMesh& mesh, double stiffness) {
    // A node's share of the crack, branch by branch: integral of N_i and its centroid.
    struct Share {
        double length = 0.0, moment = 0.0;
    };
    std::map<std::tuple<int, int, int>, Share> shares;  // (crack, branch, node)
    const auto branch_of = [&](const FaceStation& station) { return space_of(station.crack)->space.branch(station.s); };
    for (const FaceStation& station : stations_) {
        for (int k = 0; k < 4; ++k) {
            const int node = mesh.elements[at(station.element)][at(k)];
            for (const auto& [holder, part] : mesh.holders_of_jump(node)) {
                Share& share = shares[{station.crack, branch_of(station), holder}];
                share.length += part * station.weight * station.shape[k];
                share.moment += part * station.weight * station.shape[k] * station.s;
            }
        }
    }
    for (const auto& [key, share] : shares) {
        if (share.length <= 0.0) continue;
        for (const auto& [multiplier, value] : functions_at(std::get<0>(key), share.moment / share.length)) {
            if (multiplier >= 0) weight_[multiplier] += value * share.length;
        }
    }
    std::vector<int> node_of(at(mesh.unknowns));
    for (const auto& [node, term, unknown] : mesh.own_unknowns()) node_of[at(unknown)] = node;
    std::vector<Triplet> entries;
    for (const FaceStation& station : stations_) {
        for (const FaceStation::Term& term : station.terms) {
            const Share& share = shares.at({station.crack, branch_of(station), node_of[at(term.unknown)]});
            for (const auto& [multiplier, value] : functions_at(station.crack, share.moment / share.length)) {
                if (multiplier < 0) continue;
                for (int c = 0; c < 2; ++c) {
                    const double push = station.weight * value * term.value * station.normal[c];
                    if (push != 0.0) entries.emplace_back(multiplier, term.unknown + c, push);
                }
            }
        }
    }
    B_.setFromTriplets(entries.begin(), entries.end());
    for (const FaceStation& station : stations_) {
        for (const auto& [multiplier, value] : functions_at(station.crack, station.s))
            if (multiplier >= 0)
                fixed_gap_[multiplier] += station.weight * value * station.fixed_jump.dot(station.normal);
    }
    for (int k = 0; k < multipliers(); ++k) augmentation_[k] = 0.1 * stiffness / weight_[k];
}

const ContactInterface::CrackSpace* ContactInterface::space_of(int crack) const {
    const auto found = std::ranges::find(spaces_, crack, &CrackSpace::crack);
    return found != spaces_.end() ? &*found : nullptr;
}

std::array<MultiplierSpace::Value, 2> ContactInterface::functions_at(int crack, double s) const {
    const CrackSpace* entry = space_of(crack);
    auto values = entry->space.acting_at(s);
    for (auto& value : values)
        if (value.multiplier >= 0) value.multiplier += entry->first_multiplier;
    return values;
}

void ContactInterface::find_closing() {
    closing_ = (B_.cwiseAbs() * Eigen::VectorXd::Ones(B_.cols())).cwiseQuotient(weight_);
    std::set<int> jumping;
    for (Eigen::Index k = 0; k < B_.rows(); ++k)
        for (SparseRows::InnerIterator it(B_, k); it; ++it) jumping.insert(static_cast<int>(it.col()));
    jump_unknowns_.assign(jumping.begin(), jumping.end());
}

double ContactInterface::gap_of(Eigen::Index k, const Eigen::VectorXd& u) const {
    return (B_.row(k).dot(u) + fixed_gap_[k]) / weight_[k];
}

Eigen::VectorXd ContactInterface::gaps(const Eigen::VectorXd& u) const {
    return (B_ * u + fixed_gap_).cwiseQuotient(weight_);
}

Eigen::VectorXd ContactInterface::gaps_that_matter(const Eigen::VectorXd& u, const Eigen::VectorXd& pressure,
                                                   coupling::WorkCounts& work) const {
    if (multipliers() == 0) return {};
    const double moved =
        (1.0 + 1e-9) * (gather(u, jump_unknowns_) - settled_jumps_).cwiseAbs().maxCoeff();  // rounding included
    Eigen::VectorXd gap = settled_gap_ - moved * closing_;
    for (Eigen::Index k = 0; k < gap.size(); ++k) {
        const bool surely_open = status_[at(k)] == 0 && pressure[k] <= 0.0 && gap[k] > 0.0;
        ++(surely_open ? work.gaps_proven_open : work.gaps_evaluated);
        if (!surely_open) gap[k] = gap_of(k, u);
    }
    return gap;
}

void ContactInterface::add_force(const Eigen::VectorXd& pressure, Eigen::VectorXd& force) const {
    force -= B_.transpose() * pressure;
}

void ContactInterface::begin_increment() {
    status_ = committed_status_;
    visited_.clear();
    one_at_a_time_ = false;
}

void ContactInterface::commit(const Eigen::VectorXd& u) {
    committed_status_ = status_;
    settle(u);
}

void ContactInterface::settle(const Eigen::VectorXd& u) {
    settled_jumps_ = gather(u, jump_unknowns_);
    settled_gap_ = gaps(u);
}

std::int64_t ContactInterface::interface_elements() const {
    return (std::ssize(stations_) + points_of_element - 1) / points_of_element;
}

void ContactInterface::choose_statuses(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) {
    std::vector<std::int8_t> next(status_.size());
    int worst = -1;
    double largest = 0.0;
    changes_ = 0;
    for (int k = 0; k < multipliers(); ++k) {
        const auto i = at(k);
        next[i] = UnilateralContact::closed(pressure[k], gap[k], augmentation_[k]) ? 1 : 0;
        if (next[i] == status_[i]) continue;
        ++changes_;
        const double violation = std::abs(UnilateralContact::augmented(pressure[k], gap[k], augmentation_[k]));
        if (violation >= largest) {
            largest = violation;
            worst = k;
        }
    }
    if (changes_ == 0) return;
    one_at_a_time_ = one_at_a_time_ || visited_.contains(next);
    visited_.insert(next);
    if (one_at_a_time_) {
        next = status_;
        next[at(worst)] = static_cast<std::int8_t>(1 - next[at(worst)]);
        changes_ = 1;
    }
    status_ = std::move(next);
}

double ContactInterface::residual(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) const {
    double largest = 0.0;
    for (int k = 0; k < multipliers(); ++k) {
        largest = std::max(largest,
                           weight_[k] * std::abs(UnilateralContact::residual(pressure[k], gap[k], augmentation_[k])));
    }
    return largest;
}

Eigen::VectorXd ContactInterface::right_hand_side(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) const {
    Eigen::VectorXd right = weight_.cwiseProduct(pressure).cwiseQuotient(augmentation_);
    for (Eigen::Index k = 0; k < right.size(); ++k)
        if (status_[at(k)] != 0) right[k] = weight_[k] * gap[k];
    return right;
}

double ContactInterface::reach_behind(const Tip& tip) const {
    double reach = -1.0;
    for (std::size_t k = 0; k < keys_.size(); ++k)
        if (status_[k] != 0 && keys_[k].crack == tip.crack) reach = std::max(reach, std::abs(tip.s - keys_[k].s));
    return reach;
}

double ContactInterface::pressure_at(const FaceStation& station, const Eigen::VectorXd& pressure) const {
    double sum = 0.0;
    for (const auto& [multiplier, value] : functions_at(station.crack, station.s))
        if (multiplier >= 0) sum += value * pressure[multiplier];
    return std::max(sum, 0.0);
}

}  // namespace stria::fine
