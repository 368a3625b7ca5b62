#include "fine/zone.hpp"

#include <algorithm>
#include <cmath>

#include "common/fem/moment_fit.hpp"

#include "fine/element_kernels.hpp"

namespace stria::fine {

Zone::Zone(const EnrichedMesh& mesh, std::unique_ptr<MaterialLaw> law, const Elasticity& elastic,
           const IntegrationRule& rule, const Zone* old, const Eigen::VectorXd& displacement)
    : mesh_(mesh), law_(std::move(law)), elastic_(elastic), piece_(piece_of_elements(mesh_)) {
    for (std::size_t e = 0; e < mesh_.element_ids.size(); ++e) element_of_id_[mesh_.element_ids[e]] = e;
    make_operators(rule, old);
    const auto n = static_cast<std::size_t>(points_), components = static_cast<std::size_t>(law_->state_size());
    committed_.assign(components * n, 0.0);
    strain_.assign(4 * n, 0.0);
    tangent_.assign(16 * n, 0.0);
    yielding_.assign(n, 0);
    flowed_.assign(n, 0);
    tangents_ = elastic_stiffness_;
    changed_.assign(operators_.size(), 1);
    was_plastic_.assign(operators_.size(), 0);
    force_ = force_scale_ = Eigen::VectorXd::Zero(mesh_.unknowns);
    committed_u_ = trial_u_ = displacement;
    start(old);
}

void Zone::make_operators(const IntegrationRule& rule, const Zone* old) {
    const MandelMatrix stiffness = elastic_.stiffness();
    operators_.reserve(mesh_.elements.size());
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
        const int element = static_cast<int>(e);
        const CrackPiece* cut = piece_[e] >= 0 ? &mesh_.pieces[static_cast<std::size_t>(piece_[e])] : nullptr;
        bool known = false;
        if (old != nullptr) {
            const auto found = old->element_of_id_.find(mesh_.element_ids[e]);
            known = found != old->element_of_id_.end();
            if (known) {
                const std::array<Vec2, 4> corners = ElementBasis(mesh_, element, cut != nullptr).corners();
                operators_.push_back(
                    make_operator(mesh_, element, cut, rule, points_kept(cut, *old, found->second, corners)));
            }
        }
        if (!known) operators_.push_back(make_operator(mesh_, element, cut, rule));
        first_point_.push_back(points_);
        points_ += static_cast<int>(operators_.back().points.size());
        elastic_stiffness_.push_back(operators_.back().stiffness(stiffness));
    }
}

// While a tip stands in the element nothing jumps there yet, and the weights stay.
std::vector<IntegrationPoint> Zone::points_kept(const CrackPiece* cut, const Zone& old, std::size_t old_element,
                                                const std::array<Vec2, 4>& corners) const {
    std::vector<IntegrationPoint> points = old.operators_[old_element].points;
    const int old_piece = old.piece_[old_element];
    if (cut == nullptr ||
        (old_piece >= 0 && old.mesh_.pieces[static_cast<std::size_t>(old_piece)].points == cut->points))
        return points;
    const CutElement sides = cut_element(corners, *cut);
    if (sides.tips.empty())
        fit_weights(sides, corners, points);
    else
        for (IntegrationPoint& point : points) point.side = sides.side_of(point.x);
    return points;
}

void Zone::start(const Zone* old) {
    if (old != nullptr) half_cycle_ended_ = old->half_cycle_ended_;
    const auto put = [&](int component, int point, double value) {
        committed_[static_cast<std::size_t>(component * points_ + point)] = value;
    };
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        if (old != nullptr) {
            const auto found = old->element_of_id_.find(mesh_.element_ids[e]);
            if (found != old->element_of_id_.end()) {
                take_state(*old, found->second, e);
                continue;
            }
        }
        const ElementOperator& op = operators_[e];
        const Eigen::VectorXd u = gather(committed_u_, op.unknowns);
        for (std::size_t q = 0; q < op.points.size(); ++q) {
            const int point = first_point_[e] + static_cast<int>(q);
            const Mandel strain = op.strain(u, q), stress = elastic_.stiffness() * strain;
            for (int c = 0; c < 4; ++c) put(state::stress + c, point, stress[c]);
            put(state::work, point, 0.5 * stress.dot(strain));
        }
    }
    trial_ = committed_;
}

// Old points come first and in their order; one that is new has the history of the nearest. What the functions no
// longer say of the displacement's gradient is kept beside them.
void Zone::take_state(const Zone& old, std::size_t old_element, std::size_t element) {
    const ElementOperator &before = old.operators_[old_element], &now = operators_[element];
    const Eigen::VectorXd old_u = gather(old.committed_u_, before.unknowns), u = gather(committed_u_, now.unknowns);
    for (std::size_t q = 0; q < now.points.size(); ++q) {
        std::size_t from = q;
        if (q >= before.points.size()) {
            const auto distance = [&](const IntegrationPoint& p) { return (p.x - now.points[q].x).squaredNorm(); };
            from =
                static_cast<std::size_t>(std::ranges::min_element(before.points, {}, distance) - before.points.begin());
        }
        const int source = old.first_point_[old_element] + static_cast<int>(from);
        const auto point = static_cast<std::size_t>(first_point_[element]) + q;
        for (int c = 0; c < law_->state_size(); ++c)
            committed_[static_cast<std::size_t>(c * points_) + point] = old.committed(c, source);
        flowed_[point] = old.flowed_[static_cast<std::size_t>(source)];
        const Eigen::Matrix2d rest = old.total_gradient(old_element, from, old_u) - now.displacement_gradient(u, q);
        if (frozen_gradient_.empty()) {
            if (rest.cwiseAbs().maxCoeff() < 1e-14) continue;
            frozen_gradient_.assign(static_cast<std::size_t>(points_), Eigen::Matrix2d::Zero());
        }
        frozen_gradient_[point] = rest;
    }
}

Eigen::Matrix2d Zone::total_gradient(std::size_t e, std::size_t q, const Eigen::VectorXd& element_u) const {
    Eigen::Matrix2d gradient = operators_[e].displacement_gradient(element_u, q);
    if (!frozen_gradient_.empty()) gradient += frozen_gradient_[static_cast<std::size_t>(first_point_[e]) + q];
    return gradient;
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
            rings.add(op.points[q], committed_mandel(state::stress, point), total_gradient(e, q, u),
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

double Zone::force_ahead(const Tip& tip, double radius) const {
    const Vec2 normal(-tip.direction.y(), tip.direction.x());
    double sum = 0.0;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        for (std::size_t q = 0; q < operators_[e].points.size(); ++q) {
            const IntegrationPoint& p = operators_[e].points[q];
            const Vec2 from_tip = p.x - tip.position;
            const double along = from_tip.dot(tip.direction);
            if (from_tip.norm() > radius || along < std::abs(from_tip.dot(normal))) continue;
            const auto point = static_cast<std::size_t>(first_point_[e]) + q;
            Mandel stress;
            for (std::size_t c = 0; c < 4; ++c)
                stress[static_cast<Eigen::Index>(c)] =
                    trial_[(static_cast<std::size_t>(state::stress) + c) * static_cast<std::size_t>(points_) + point];
            sum += p.weight * normal.dot(in_plane(stress) * normal);
        }
    }
    return sum;
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
