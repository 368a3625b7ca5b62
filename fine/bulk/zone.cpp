#include "fine/bulk/zone.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "common/integration/moment_fit.hpp"

#include "common/index.hpp"
#include "fine/bulk/element_kernels.hpp"

namespace stria::fine {

Zone::Zone(const EnrichedMesh& mesh, std::unique_ptr<MaterialLaw> law, const Elasticity& elastic,
           const IntegrationRule& rule, const Zone* old, const Eigen::VectorXd& displacement)
    : Zone(mesh, std::move(law), elastic, rule, displacement, [&](std::size_t e, const CrackPiece* cut) {
          return old != nullptr ? points_kept(e, cut, *old) : std::nullopt;
      }) {
    if (old != nullptr) counts_ = old->counts_;
    start(old);
    settle();
}

Zone::Zone(const EnrichedMesh& mesh, std::unique_ptr<MaterialLaw> law, const Elasticity& elastic,
           const IntegrationRule& rule, const Eigen::VectorXd& displacement, const KnownPoints& known)
    : mesh_(mesh), law_(std::move(law)), elastic_(elastic), piece_(piece_of_elements(mesh_)),
      bound_(elastic.shear_modulus()) {
    for (std::size_t e = 0; e < mesh_.element_ids.size(); ++e) element_of_id_[mesh_.element_ids[e]] = e;
    make_operators(rule, known);
    const auto n = at(points_), components = at(law_->state_size());
    committed_.assign(components * n, 0.0);
    strain_.assign(4 * n, 0.0);
    tangent_.assign(law_->flows() ? 16 * n : 0, 0.0);
    yielding_.assign(n, 0);
    flowed_.assign(n, 0);
    tangents_ = elastic_stiffness_;
    changed_.assign(operators_.size(), 1);
    course_.assign(operators_.size(), Course::Proven);  // no force is known yet
    quiet_half_cycles_.assign(operators_.size(), 0);
    looked_at_u_.assign(trial_forces_.size(), 0.0);
    was_plastic_.assign(operators_.size(), 0);
    force_ = force_scale_ = Eigen::VectorXd::Zero(mesh_.unknowns);
    committed_u_ = trial_u_ = rest_u_ = displacement;
    increment_ = Eigen::VectorXd::Zero(mesh_.unknowns);
}

void Zone::make_operators(const IntegrationRule& rule, const KnownPoints& known) {
    const MandelMatrix stiffness = elastic_.stiffness();
    operators_.reserve(mesh_.elements.size());
    for (std::size_t e = 0; e < mesh_.elements.size(); ++e) {
        const int element = static_cast<int>(e);
        const CrackPiece* cut = piece_[e] >= 0 ? &mesh_.pieces[at(piece_[e])] : nullptr;
        if (auto points = known(e, cut))
            operators_.push_back(make_operator(mesh_, element, cut, rule, std::move(*points)));
        else
            operators_.push_back(make_operator(mesh_, element, cut, rule));
        first_point_.push_back(points_);
        points_ += static_cast<int>(operators_.back().points.size());
        elastic_stiffness_.push_back(operators_.back().stiffness(stiffness));
        bound_.add_element(operators_.back());
        first_force_.push_back(static_cast<int>(trial_forces_.size()));
        trial_forces_.resize(trial_forces_.size() + operators_.back().unknowns.size());
    }
}

// While a tip stands in the element nothing jumps there yet, and the weights stay.
std::optional<std::vector<IntegrationPoint>> Zone::points_kept(std::size_t element, const CrackPiece* cut,
                                                               const Zone& old) const {
    const auto found = old.element_of_id_.find(mesh_.element_ids[element]);
    if (found == old.element_of_id_.end()) return std::nullopt;
    std::vector<IntegrationPoint> points = old.operators_[found->second].points;
    const int old_piece = old.piece_[found->second];
    if (cut == nullptr || (old_piece >= 0 && old.mesh_.pieces[at(old_piece)].points == cut->points)) return points;
    const std::array<Vec2, 4> corners = ElementBasis(mesh_, static_cast<int>(element), true).corners();
    const CutElement sides = cut_element(corners, *cut);
    if (sides.tips.empty())
        fit_weights(sides, corners, points);
    else
        for (IntegrationPoint& point : points) point.side = sides.side_of(point.x);
    return points;
}

void Zone::start(const Zone* old) {
    if (old != nullptr) half_cycle_ended_ = old->half_cycle_ended_;
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
        double* state = committed_.data() + first_point_[e];
        for (std::size_t q = 0; q < op.points.size(); ++q) law_->begin(op.strain(u, q), state++, points_);
    }
    trial_ = committed_;
}

// Old points come first and in their order; one that is new has a mean history of those around it on its side. What
// the functions no longer say of the displacement's gradient is kept beside them.
void Zone::take_state(const Zone& old, std::size_t old_element, std::size_t element) {
    const ElementOperator &before = old.operators_[old_element], &now = operators_[element];
    quiet_half_cycles_[element] = old.quiet_half_cycles_[old_element];
    const Eigen::VectorXd old_u = gather(old.committed_u_, before.unknowns), u = gather(committed_u_, now.unknowns);
    for (std::size_t q = 0; q < now.points.size(); ++q) {
        const auto point = at(first_point_[element]) + q;
        Eigen::Matrix2d rest = -now.displacement_gradient(u, q);
        for (const auto& [from, share] : history_of(now.points, q, before.points)) {
            const int source = old.first_point_[old_element] + static_cast<int>(from);
            for (int c = 0; c < law_->state_size(); ++c)
                committed_[at(c * points_) + point] += share * old.committed(c, source);
            flowed_[point] = static_cast<unsigned char>(flowed_[point] | old.flowed_[at(source)]);
            rest += share * old.total_gradient(old_element, from, old_u);
        }
        if (frozen_gradient_.empty()) {
            if (rest.cwiseAbs().maxCoeff() < 1e-14) continue;
            frozen_gradient_.assign(at(points_), Eigen::Matrix2d::Zero());
        }
        frozen_gradient_[point] = rest;
    }
}

Eigen::Matrix2d Zone::total_gradient(std::size_t e, std::size_t q, const Eigen::VectorXd& element_u) const {
    Eigen::Matrix2d gradient = operators_[e].displacement_gradient(element_u, q);
    if (!frozen_gradient_.empty()) gradient += frozen_gradient_[at(first_point_[e]) + q];
    return gradient;
}

void Zone::evaluate(const Eigen::VectorXd& u) {
    trial_u_ = u;
    increment_ = u - committed_u_;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        if (rests(e)) continue;
        with_kernel(operators_[e], [&](const auto& kernel) {
            course_[e] = proves_elastic(e, kernel) ? Course::Proven : Course::Evaluated;
        });
    }
    update_points(Course::Evaluated);
    force_.setZero();
    force_scale_.setZero();
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        if (rests(e))
            counts_.points_at_rest += std::ssize(operators_[e].points);
        else
            with_kernel(operators_[e], [&](const auto& kernel) { evaluate_element(e, kernel); });
    }
}

template <class Kernel> bool Zone::proves_elastic(std::size_t e, const Kernel& kernel) {
    const auto elastic = kernel.elastic(elastic_stiffness_[e], increment_);
    if (!bound_.proves(e, elastic.work)) return false;
    for (std::size_t k = 0; k < operators_[e].unknowns.size(); ++k) {
        const std::size_t place = at(first_force_[e]) + k;
        trial_forces_[place] = committed_forces_[place] + elastic.force.data()[k];
    }
    return true;
}

// In as long blocks as there are.
void Zone::update_points(Course course) {
    for (std::size_t e = 0; e < operators_.size();) {
        const std::size_t begin = e;
        while (e < operators_.size() && course_[e] == course) ++e;
        update_block(begin, e, increment_);
        while (e < operators_.size() && course_[e] != course) ++e;
    }
}

void Zone::update_block(std::size_t begin, std::size_t end, const Eigen::VectorXd& increment) {
    if (begin == end) return;
    for (std::size_t e = begin; e < end; ++e)
        with_kernel(operators_[e], [&](const auto& kernel) {
            kernel.write_strains(increment, strain_.data() + first_point_[e], points_);
        });
    const int first = first_point_[begin], last = end < operators_.size() ? first_point_[end] : points_;
    law_->update(last - first, points_, strain_.data() + first, committed_.data() + first, trial_.data() + first,
                 law_->flows() ? tangent_.data() + first : nullptr, yielding_.data() + first);
    counts_.points_evaluated += last - first;
}

template <class Kernel> void Zone::evaluate_element(std::size_t e, const Kernel& kernel) {
    const ElementOperator& op = operators_[e];
    const int first = first_point_[e], count = static_cast<int>(op.points.size());
    double* element_force = trial_forces_.data() + first_force_[e];
    if (course_[e] == Course::Evaluated) {
        const auto force =
            kernel.force(trial_.data() + static_cast<std::ptrdiff_t>(state::stress) * points_ + first, points_);
        std::copy_n(force.data(), op.unknowns.size(), element_force);
    } else {
        std::fill_n(yielding_.begin() + first, count, static_cast<unsigned char>(0));
        counts_.points_proven_elastic += count;
    }
    for (std::size_t k = 0; k < op.unknowns.size(); ++k) {
        force_[op.unknowns[k]] += element_force[k];
        force_scale_[op.unknowns[k]] += std::abs(element_force[k]);
    }
    const auto yields = [&](int q) { return yielding_[at(first + q)] != 0; };
    bool plastic = false;
    for (int q = 0; q < count; ++q) plastic = plastic || yields(q);
    changed_[e] = static_cast<char>(plastic || was_plastic_[e] != 0);
    was_plastic_[e] = static_cast<char>(plastic);
    if (!plastic) {
        if (changed_[e] != 0) tangents_[e] = elastic_stiffness_[e];
        ++counts_.elastic_tangents_reused;
        return;
    }
    ++counts_.tangents_computed;
    // The elastic matrix plus what flow takes away at the points that yield.
    const MandelMatrix elastic = elastic_.stiffness();
    typename Kernel::Matrix K = elastic_stiffness_[e];
    for (int q = 0; q < count; ++q) {
        if (!yields(q)) continue;
        MandelMatrix D;
        for (int c = 0; c < 16; ++c) {
            const auto place = at(c) * at(points_);
            D(c / 4, c % 4) = tangent_[place + at(first + q)];
        }
        kernel.add_stiffness(D - elastic, at(q), K);
    }
    tangents_[e] = K;
}

void Zone::commit(bool reversal) {
    update_points(Course::Proven);
    committed_.swap(trial_);
    trial_ = committed_;
    committed_u_ = trial_u_;
    increment_.setZero();
    settle();
    if (half_cycle_ended_) std::ranges::fill(flowed_, static_cast<unsigned char>(0));
    for (std::size_t q = 0; q < flowed_.size(); ++q) flowed_[q] = static_cast<unsigned char>(flowed_[q] | yielding_[q]);
    half_cycle_ended_ = reversal;
    if (reversal) count_quiet_half_cycles();
}

void Zone::settle() {
    settle_forces();
    for (std::size_t e = 0; e < operators_.size(); ++e)
        if (!rests(e)) measure_margin(e);
}

void Zone::measure_margin(std::size_t e) {
    const int count = static_cast<int>(operators_[e].points.size());
    bound_.set_margin(e, law_->elastic_margin(count, points_, committed_.data() + first_point_[e]));
}

// Where the points were not looked at before the commit, the forces are now those of their stresses.
void Zone::settle_forces() {
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        if (course_[e] != Course::Proven) continue;
        course_[e] = Course::Evaluated;
        find_forces(e);
    }
    committed_forces_ = trial_forces_;
}

void Zone::find_forces(std::size_t e) {
    with_kernel(operators_[e], [&](const auto& kernel) {
        const auto force = kernel.force(
            committed_.data() + static_cast<std::ptrdiff_t>(state::stress) * points_ + first_point_[e], points_);
        std::copy_n(force.data(), operators_[e].unknowns.size(), trial_forces_.data() + first_force_[e]);
    });
}

Mandel Zone::trial_stress(std::size_t e, std::size_t q) const {
    const int point = first_point_[e] + static_cast<int>(q);
    if (course_[e] == Course::Proven)
        return committed_mandel(state::stress, point) +
               law_->elastic() * operators_[e].strain(gather(increment_, operators_[e].unknowns), q);
    Mandel stress;
    for (int c = 0; c < 4; ++c) stress[c] = trial_[at(state::stress + c) * at(points_) + at(point)];
    return stress;
}

Mandel Zone::committed_mandel(int component, int point) const {
    return {committed(component, point), committed(component + 1, point), committed(component + 2, point),
            committed(component + 3, point)};
}

}  // namespace stria::fine
