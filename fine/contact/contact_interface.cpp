#include "fine/contact/contact_interface.hpp"

#include <algorithm>
#include <cmath>

namespace stria::fine {

ContactInterface::ContactInterface(const EnrichedMesh& mesh, const std::vector<CrackSection>& cracks, int subcells, double stiffness) {
    int count = 0;
    for (int crack = 0; crack < static_cast<int>(cracks.size()); ++crack) {
        const CrackSection& section = cracks[static_cast<std::size_t>(crack)];
        if (!section.contact) continue;
        spaces_.push_back({crack, section.notch, count, MultiplierSpace(mesh, crack, section.notch)});
        const MultiplierSpace& space = spaces_.back().space;
        count += space.size();
        for (const double s : space.nodes()) keys_.push_back({crack, s});
        for (FaceStation& station : face_stations(mesh, crack, subcells, 4)) {
            if (station.s >= section.notch) stations_.push_back(std::move(station));
        }
    }
    std::set<int> jumping;
    for (const FaceStation& station : stations_) {
        for (const FaceStation::Term& term : station.terms) jumping.insert({term.unknown, term.unknown + 1});
    }
    jump_unknowns_.assign(jumping.begin(), jumping.end());

    B_ = Eigen::MatrixXd::Zero(count, std::ssize(jump_unknowns_));
    weight_ = augmentation_ = Eigen::VectorXd::Zero(count);
    const auto column = [&](int unknown) { return std::ranges::lower_bound(jump_unknowns_, unknown) - jump_unknowns_.begin(); };
    for (const FaceStation& station : stations_) {
        for (const auto& [multiplier, value] : functions_at(station)) {
            if (multiplier < 0) continue;
            weight_[multiplier] += station.weight * value;
            for (const FaceStation::Term& term : station.terms) {
                for (int c = 0; c < 2; ++c) {
                    B_(multiplier, column(term.unknown + c)) += station.weight * value * term.value * station.normal[c];
                }
            }
        }
    }
    for (const CrackSpace& entry : spaces_) {
        for (int k = 0; k < entry.space.size(); ++k) {
            augmentation_[entry.first_multiplier + k] = 0.1 * stiffness / entry.space.chords()[static_cast<std::size_t>(k)];
        }
    }
    status_.assign(static_cast<std::size_t>(count), 0);
}

std::array<MultiplierSpace::Value, 2> ContactInterface::functions_at(const FaceStation& station) const {
    for (const CrackSpace& entry : spaces_) {
        if (entry.crack != station.crack) continue;
        auto values = entry.space.at(station.s);
        for (auto& value : values) if (value.multiplier >= 0) value.multiplier += entry.first_multiplier;
        return values;
    }
    return {MultiplierSpace::Value{-1, 0.0}, MultiplierSpace::Value{-1, 0.0}};
}

Eigen::VectorXd ContactInterface::gaps(const Eigen::VectorXd& u) const {
    return (B_ * gather(u, jump_unknowns_)).cwiseQuotient(weight_);
}

void ContactInterface::add_force(const Eigen::VectorXd& pressure, Eigen::VectorXd& force) const {
    const Eigen::VectorXd push = B_.transpose() * pressure;
    for (std::size_t j = 0; j < jump_unknowns_.size(); ++j) force[jump_unknowns_[j]] -= push[static_cast<Eigen::Index>(j)];
}

void ContactInterface::begin_increment() {
    visited_.clear();
    one_at_a_time_ = false;
}

void ContactInterface::choose_statuses(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) {
    std::vector<std::int8_t> next(status_.size());
    int worst = -1;
    double largest = 0.0;
    changes_ = 0;
    for (int k = 0; k < multipliers(); ++k) {
        const auto i = static_cast<std::size_t>(k);
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
        next[static_cast<std::size_t>(worst)] = static_cast<std::int8_t>(1 - next[static_cast<std::size_t>(worst)]);
        changes_ = 1;
    }
    status_ = std::move(next);
}

double ContactInterface::residual(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) const {
    double largest = 0.0;
    for (int k = 0; k < multipliers(); ++k) {
        largest = std::max(largest, weight_[k] * std::abs(UnilateralContact::residual(pressure[k], gap[k], augmentation_[k])));
    }
    return largest;
}

ContactInterface::Rows ContactInterface::rows(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) const {
    Rows result{Eigen::MatrixXd::Zero(B_.rows(), B_.cols()), Eigen::VectorXd::Zero(multipliers()), Eigen::VectorXd::Zero(multipliers())};
    for (int k = 0; k < multipliers(); ++k) {
        if (status_[static_cast<std::size_t>(k)] != 0) {
            result.jump.row(k) = -B_.row(k);
            result.right_hand_side[k] = weight_[k] * gap[k];
        } else {
            const double d = weight_[k] / augmentation_[k];
            result.diagonal[k] = -d;
            result.right_hand_side[k] = d * pressure[k];
        }
    }
    return result;
}

double ContactInterface::pressure_at(const FaceStation& station, const Eigen::VectorXd& pressure) const {
    double sum = 0.0;
    for (const auto& [multiplier, value] : functions_at(station)) if (multiplier >= 0) sum += value * pressure[multiplier];
    return sum;
}

}  // namespace stria::fine
