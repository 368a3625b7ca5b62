#include "fine/zone.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "fine/element_kernels.hpp"

namespace stria::fine {

Zone::Zone(const EnrichedMesh& mesh, std::unique_ptr<MaterialLaw> law, const Elasticity& elastic,
           const IntegrationRule& rule)
    : mesh_(mesh), law_(std::move(law)), elastic_(elastic) {
    const std::vector<int> piece = piece_of_elements(mesh_);
    const MandelMatrix stiffness = elastic_.stiffness();
    const auto count = mesh_.elements.size();
    operators_.reserve(count);
    for (std::size_t e = 0; e < count; ++e) {
        const CrackPiece* cut = piece[e] >= 0 ? &mesh_.pieces[static_cast<std::size_t>(piece[e])] : nullptr;
        operators_.push_back(make_operator(mesh_, static_cast<int>(e), cut, rule));
        first_point_.push_back(points_);
        points_ += static_cast<int>(operators_.back().points.size());
        elastic_stiffness_.push_back(operators_.back().stiffness(stiffness));
    }
    const auto n = static_cast<std::size_t>(points_), components = static_cast<std::size_t>(law_->state_size());
    committed_.assign(components * n, 0.0);
    trial_ = committed_;
    strain_.assign(4 * n, 0.0);
    tangent_.assign(16 * n, 0.0);
    yielding_.assign(n, 0);
    flowed_.assign(n, 0);
    tangents_ = elastic_stiffness_;
    changed_.assign(count, 1);
    was_plastic_.assign(count, 0);
    committed_u_ = trial_u_ = force_ = force_scale_ = Eigen::VectorXd::Zero(mesh_.unknowns);
}

void Zone::start(const Zone* old, const Eigen::VectorXd& displacement) {
    committed_u_ = trial_u_ = displacement;
    std::map<int, std::size_t> known;
    if (old != nullptr) {
        for (std::size_t e = 0; e < old->mesh_.element_ids.size(); ++e) known[old->mesh_.element_ids[e]] = e;
    }
    const int components = law_->state_size();
    const auto put = [&](int component, int point, double value) {
        committed_[static_cast<std::size_t>(component * points_ + point)] = value;
    };
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        const ElementOperator& op = operators_[e];
        const auto found = known.find(mesh_.element_ids[e]);
        const Eigen::VectorXd u = gather(committed_u_, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const int point = first_point_[e] + static_cast<int>(q);
            if (found != known.end()) {
                const int source = old->first_point_[found->second] + static_cast<int>(q);
                for (int c = 0; c < components; ++c) put(c, point, old->committed(c, source));
                flowed_[static_cast<std::size_t>(point)] = old->flowed_[static_cast<std::size_t>(source)];
                half_cycle_ended_ = old->half_cycle_ended_;
            } else {
                const Mandel strain = op.strain(u, q), stress = elastic_.stiffness() * strain;
                for (int c = 0; c < 4; ++c) put(state::stress + c, point, stress[c]);
                put(state::work, point, 0.5 * stress.dot(strain));
            }
        }
    }
    trial_ = committed_;
}

void Zone::evaluate(const Eigen::VectorXd& u) {
    trial_u_ = u;
    const Eigen::VectorXd increment = u - committed_u_;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        with_kernel(operators_[e], [&](const auto& kernel) {
            kernel.write_strains(increment, strain_.data() + first_point_[e], points_);
        });
    }
    law_->update(points_, points_, strain_.data(), committed_.data(), trial_.data(), tangent_.data(), yielding_.data());
    force_.setZero();
    force_scale_.setZero();
    for (std::size_t e = 0; e < operators_.size(); ++e)
        with_kernel(operators_[e], [&](const auto& kernel) { evaluate_element(e, kernel); });
}

template <class Kernel> void Zone::evaluate_element(std::size_t e, const Kernel& kernel) {
    const ElementOperator& op = operators_[e];
    const int first = first_point_[e], count = static_cast<int>(op.points.size());
    const auto force =
        kernel.force(trial_.data() + static_cast<std::ptrdiff_t>(state::stress) * points_ + first, points_);
    for (std::size_t k = 0; k < op.unknowns.size(); ++k) {
        const double f = force.data()[k];
        force_[op.unknowns[k]] += f;
        force_scale_[op.unknowns[k]] += std::abs(f);
    }
    const auto yields = [&](int q) { return yielding_[static_cast<std::size_t>(first + q)] != 0; };
    bool plastic = false;
    for (int q = 0; q < count; ++q) plastic = plastic || yields(q);
    changed_[e] = static_cast<char>(plastic || was_plastic_[e] != 0);
    was_plastic_[e] = static_cast<char>(plastic);
    if (!plastic) {
        if (changed_[e] != 0) tangents_[e] = elastic_stiffness_[e];
        return;
    }
    // The elastic matrix plus what flow takes away at the points that yield.
    const MandelMatrix elastic = elastic_.stiffness();
    typename Kernel::Matrix K = elastic_stiffness_[e];
    for (int q = 0; q < count; ++q) {
        if (!yields(q)) continue;
        MandelMatrix D;
        for (int c = 0; c < 16; ++c) {
            const auto place = static_cast<std::size_t>(c) * static_cast<std::size_t>(points_);
            D(c / 4, c % 4) = tangent_[place + static_cast<std::size_t>(first + q)];
        }
        kernel.add_stiffness(D - elastic, static_cast<std::size_t>(q), K);
    }
    tangents_[e] = K;
}

void Zone::commit(bool reversal) {
    committed_.swap(trial_);
    trial_ = committed_;
    committed_u_ = trial_u_;
    if (half_cycle_ended_) std::ranges::fill(flowed_, static_cast<unsigned char>(0));
    for (std::size_t q = 0; q < flowed_.size(); ++q) flowed_[q] = static_cast<unsigned char>(flowed_[q] | yielding_[q]);
    half_cycle_ended_ = reversal;
}

Mandel Zone::committed_mandel(int component, int point) const {
    return {committed(component, point), committed(component + 1, point), committed(component + 2, point),
            committed(component + 3, point)};
}

std::vector<std::int32_t> Zone::yielding_points() const {
    std::vector<std::int32_t> count(operators_.size(), 0);
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        const auto begin = yielding_.begin() + first_point_[e];
        count[e] = static_cast<std::int32_t>(
            std::count_if(begin, begin + std::ssize(operators_[e].points), [](auto y) { return y != 0; }));
    }
    return count;
}

double Zone::largest_plastic_increment() const {
    double largest = 0.0;
    const auto offset = static_cast<std::size_t>(state::accumulated) * static_cast<std::size_t>(points_);
    for (std::size_t q = 0; q < static_cast<std::size_t>(points_); ++q) {
        largest = std::max(largest, trial_[offset + q] - committed_[offset + q]);
    }
    return largest;
}

double Zone::dissipation() const {
    double sum = 0.0;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        for (std::size_t q = 0; q < operators_[e].points.size(); ++q) {
            sum +=
                operators_[e].points[q].weight * committed(state::dissipation, first_point_[e] + static_cast<int>(q));
        }
    }
    return sum;
}

void Zone::add_to(RingSums& rings) const {
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        const ElementOperator& op = operators_[e];
        if (!rings.enter(static_cast<int>(e))) continue;
        const Eigen::VectorXd u = gather(committed_u_, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const int point = first_point_[e] + static_cast<int>(q);
            rings.add(op.points[q], committed_mandel(state::stress, point), op.displacement_gradient(u, q),
                      committed(state::work, point));
        }
    }
}

double Zone::plastic_reach(const Tip& tip) const {
    double largest = 0.0;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        for (std::size_t q = 0; q < operators_[e].points.size(); ++q) {
            if (committed(state::accumulated, first_point_[e] + static_cast<int>(q)) > 0.0)
                largest = std::max(largest, (operators_[e].points[q].x - tip.position).norm());
        }
    }
    return largest;
}

double Zone::plastic_extent(const Tip& tip, double half_angle) const {
    double largest = 0.0;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        for (std::size_t q = 0; q < operators_[e].points.size(); ++q) {
            if (flowed_[static_cast<std::size_t>(first_point_[e]) + q] == 0) continue;
            const TipPolar polar = tip_polar(tip, operators_[e].points[q].x, 0);
            if (std::abs(polar.theta) <= half_angle) largest = std::max(largest, polar.r);
        }
    }
    return largest;
}

void Zone::describe(coupling::ZoneState& out) const {
    out.displacement = committed_u_;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        for (std::size_t q = 0; q < operators_[e].points.size(); ++q) {
            const IntegrationPoint& p = operators_[e].points[q];
            const int point = first_point_[e] + static_cast<int>(q);
            out.element.push_back(static_cast<std::int32_t>(e));
            out.side.push_back(static_cast<std::int8_t>(p.side));
            out.x.push_back(p.x.x());
            out.y.push_back(p.x.y());
            out.weight.push_back(p.weight);
            for (int c = 0; c < 4; ++c) out.stress.push_back(committed(state::stress + c, point));
            for (int c = 0; c < 4; ++c) out.plastic_strain.push_back(committed(state::plastic_strain + c, point));
            out.accumulated.push_back(committed(state::accumulated, point));
        }
    }
}

}  // namespace stria::fine
