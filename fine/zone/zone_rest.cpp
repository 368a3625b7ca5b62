// Elements at rest: where nothing has flowed for a cycle the zone is a linear substructure about its stored plastic
// strain (docs/method.md, section 1). Its points stay where they were; whether one would flow is looked at early in an
// increment and where it may end.
#include <algorithm>

#include "common/stopwatch.hpp"

#include "common/index.hpp"
#include "fine/bulk/element_kernels.hpp"
#include "fine/zone/zone_system.hpp"

namespace stria::fine {

void Zone::count_quiet_half_cycles() {
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        const auto begin = flowed_.begin() + first_point_[e];
        const bool flowed = std::any_of(begin, begin + std::ssize(operators_[e].points), [](auto f) { return f != 0; });
        quiet_half_cycles_[e] = flowed ? 0 : quiet_half_cycles_[e] + 1;
    }
}

std::vector<char> Zone::quiet() const {
    constexpr int whole_cycle = 2;
    std::vector<char> quiet(operators_.size());
    for (std::size_t e = 0; e < quiet.size(); ++e)
        quiet[e] = !law_->flows() || quiet_half_cycles_[e] >= whole_cycle ? 1 : 0;
    return quiet;
}

void Zone::rest(const std::vector<char>& elements, const Eigen::VectorXd& displacement) {
    rest_u_ = displacement;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        if (elements[e] == 0) continue;
        course_[e] = Course::Resting;
        look_from(e, rest_u_);
        changed_[e] = was_plastic_[e] = 0;
        std::fill_n(yielding_.begin() + first_point_[e], operators_[e].points.size(), static_cast<unsigned char>(0));
    }
}

Eigen::VectorXd Zone::rest_load() const {
    Eigen::VectorXd load = Eigen::VectorXd::Zero(mesh_.unknowns);
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        if (!rests(e)) continue;
        const double* force = committed_forces_.data() + first_force_[e];
        for (const int unknown : operators_[e].unknowns) load[unknown] -= *force++;
    }
    return load;
}

std::vector<std::size_t> Zone::would_flow(const Eigen::VectorXd& u) {
    trial_u_ = u;  // what rests has followed since evaluate()
    const Eigen::VectorXd since_rest = u - rest_u_;
    std::vector<std::size_t> found;
    for (std::size_t e = 0; e < operators_.size(); ++e)
        if (rests(e) && flows_at(e, u, since_rest)) found.push_back(e);
    return found;
}

// The energy of what it has moved since it was looked at the last time proves most elements elastic. Of the others the
// law tells, as of any point, and how much is left until one flows.
bool Zone::flows_at(std::size_t e, const Eigen::VectorXd& u, const Eigen::VectorXd& since_rest) {
    const auto count = std::ssize(operators_[e].unknowns);
    const Eigen::VectorXd moved = gather(u, operators_[e].unknowns) -
                                  Eigen::Map<const Eigen::VectorXd>(looked_at_u_.data() + first_force_[e], count);
    double work = 0.0;
    with_kernel(operators_[e], [&](const auto& kernel) { work = kernel.work(elastic_stiffness_[e], moved); });
    if (bound_.proves(e, work)) return false;
    update_block(e, e + 1, since_rest);
    const auto begin = yielding_.begin() + first_point_[e], end = begin + std::ssize(operators_[e].points);
    const bool flows = std::any_of(begin, end, [](auto y) { return y != 0; });
    if (!flows) {
        bound_.set_margin(
            e, law_->elastic_margin(static_cast<int>(end - begin), points_, trial_.data() + first_point_[e]));
        look_from(e, u);
    }
    std::fill(begin, end, static_cast<unsigned char>(0));
    copy_state(e, committed_, trial_);
    return flows;
}

void Zone::look_from(std::size_t e, const Eigen::VectorXd& u) {
    const Eigen::VectorXd values = gather(u, operators_[e].unknowns);
    std::ranges::copy(values, looked_at_u_.begin() + first_force_[e]);
}

void Zone::copy_state(std::size_t e, const std::vector<double>& from, std::vector<double>& to) const {
    for (int c = 0; c < law_->state_size(); ++c) {
        const auto begin = static_cast<std::ptrdiff_t>(c) * points_ + first_point_[e];
        std::copy_n(from.begin() + begin, operators_[e].points.size(), to.begin() + begin);
    }
}

void Zone::wake(const std::vector<char>& still) {
    const Eigen::VectorXd moved = committed_u_ - rest_u_;
    for (std::size_t e = 0; e < operators_.size(); ++e) {
        if (!rests(e) || (!still.empty() && still[e] != 0)) continue;
        update_block(e, e + 1, moved);
        copy_state(e, trial_, committed_);
        course_[e] = Course::Evaluated;
        find_forces(e);
        std::copy_n(trial_forces_.begin() + first_force_[e], operators_[e].unknowns.size(),
                    committed_forces_.begin() + first_force_[e]);
        measure_margin(e);
    }
}

// Of the element's unknowns; empty where it does not rest.
Eigen::VectorXd Zone::moved_since_rest(std::size_t e) const {
    if (!rests(e)) return {};
    return gather(committed_u_, operators_[e].unknowns) - gather(rest_u_, operators_[e].unknowns);
}

double Zone::energy_since_rest(std::size_t e) const {
    const Eigen::VectorXd moved = moved_since_rest(e);
    const Eigen::Map<const Eigen::VectorXd> force(committed_forces_.data() + first_force_[e], moved.size());
    return moved.dot(force + 0.5 * elastic_stiffness_[e] * moved);
}

Zone::PointState Zone::committed_state(std::size_t e, std::size_t q, const Eigen::VectorXd& moved) const {
    const int point = first_point_[e] + static_cast<int>(q);
    PointState state{committed_mandel(state::stress, point), law_->work(committed_.data() + point, points_)};
    if (moved.size() == 0) return state;
    const Mandel strain = operators_[e].strain(moved, q);
    const Mandel change = law_->elastic() * strain;
    state.work += (state.stress + 0.5 * change).dot(strain);
    state.stress += change;
    return state;
}

void ZoneSystem::add_response(const Eigen::VectorXd& load) {
    load_ += load;
    response_ = load;
}

std::vector<char> ZoneSystem::may_rest() const {
    std::vector<char> may = zone_->quiet();
    for (std::size_t e = 0; e < may.size(); ++e) {
        const ElementOperator& op = zone_->operators()[e];
        const auto bears_load = [&](int unknown) { return patch_.unit_load[unknown] != 0.0; };
        if (std::ranges::any_of(op.unknowns, bears_load)) may[e] = 0;
        for (std::size_t t = 0; t < patch_.ahead.size(); ++t)
            if (zone_->is_near(e, patch_.mesh.tips[t].position, patch_.ahead[t])) may[e] = 0;
    }
    return may;
}

void ZoneSystem::rest(const std::vector<char>& elements, const std::vector<char>& inside) {
    zone_->rest(elements, committed_.displacement);
    set_inside(inside);
}

std::vector<std::size_t> ZoneSystem::would_flow(const Eigen::VectorXd& displacement) {
    const Stopwatch watch(constitutive_s_);
    for (Eigen::Index i = 0; i < trial_.displacement.size(); ++i)
        if (inside_[at(i)] != 0) trial_.displacement[i] = displacement[i];
    return zone_->would_flow(trial_.displacement);
}

void ZoneSystem::wake(const std::vector<char>& still, const std::vector<char>& inside) {
    zone_->wake(still);
    set_inside(inside);
}

void ZoneSystem::set_inside(const std::vector<char>& inside) {
    inside_.assign(at(patch_.mesh.unknowns), 0);
    std::copy_n(inside.begin(), std::min(inside.size(), inside_.size()), inside_.begin());
    force_scale_at_rest_ = zone_->rest_load().lpNorm<Eigen::Infinity>();
}

}  // namespace stria::fine
