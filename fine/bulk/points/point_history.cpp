#include "fine/bulk/points/point_history.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/error.hpp"
#include "fine/bulk/points/element_kernels.hpp"

namespace stria::fine {

PointHistory::PointHistory(MaterialLaws laws, SharedList<int> material, const std::vector<ElementOperator>& operators)
    : laws_(std::move(laws)), material_(std::move(material)) {
    for (const auto& law : laws_) {
        state_size_ = std::max(state_size_, law->state_size());
        can_yield_ = can_yield_ || law->can_yield();
    }
    for (const ElementOperator& op : operators) first_.push_back(points() + static_cast<int>(op.points.size()));
    const auto n = at(points());
    committed_.assign(at(state_size_) * n, 0.0);
    trial_ = committed_;
    strain_.assign(4 * n, 0.0);
    tangent_.assign(can_yield_ ? 16 * n : 0, 0.0);
    yielding_.assign(n, 0);
    flow_.assign(n, 0.0);
}

void PointHistory::update(std::span<const ElementOperator> operators, int begin, int end,
                          const Eigen::VectorXd& increment) {
    for (int e = begin; e < end; ++e)
        with_kernel(operators[at(e)], [&](const auto& kernel) {
            kernel.write_strains(kernel.gather(increment), &strain_[place(0, e, 0)], points());
        });
    return_points(begin, end);
}

void PointHistory::update(const ElementOperator& op, int e, const Eigen::VectorXd& increment) {
    with_kernel(op, [&](const auto& kernel) {
        kernel.write_strains(kernel.nodal(increment.data()), &strain_[place(0, e, 0)], points());
    });
    return_points(e, e + 1);
}

void PointHistory::update(const ElementOperator& op, int e, const Eigen::VectorXd& elastic_way,
                          const Eigen::VectorXd& increment) {
    std::vector<double> before;
    for (int c = 0; c < state_size_; ++c)
        before.insert(before.end(), &committed_[place(c, e, 0)], &committed_[place(c, e, 0)] + points(e));
    const auto restore = [&] {
        for (int c = 0; c < state_size_; ++c)
            std::copy_n(&before[at(c * points(e))], points(e), &committed_[place(c, e, 0)]);
    };
    update(op, e, elastic_way);
    commit(e, e + 1);
    try {
        update(op, e, increment);
    } catch (...) {
        restore();
        throw;
    }
    restore();
}

double PointHistory::elastic_margin_behind(const ElementOperator& op, int e, const Eigen::VectorXd& way,
                                           const MandelMatrix& elastic) {
    double told = 0.0;  // what is no number among the changes stays in it
    rollback(e);
    with_kernel(op, [&](const auto& kernel) {
        const auto nodal = kernel.nodal(way.data());
        for (std::size_t q = 0; q < at(points(e)); ++q) {
            const Mandel change = elastic * kernel.strain(nodal, q);
            for (int c = 0; c < 4; ++c) trial_[place(state::stress + c, e, q)] += change[c];
            told += change.sum();
        }
    });
    const double margin = law(e).elastic_margin(points(e), points(), &trial_[place(0, e, 0)]);
    rollback(e);
    if (!std::isfinite(told) || margin == -std::numeric_limits<double>::infinity())
        throw NumericalFailure("the stress of an element at rest is not finite");
    return margin;
}

// The strains are written.
void PointHistory::return_points(int begin, int end) {
    if (begin == end) return;
    for (int first = begin, last = begin; first < end; first = last) {
        while (last < end && material_of(last) == material_of(first)) ++last;
        const auto from = place(0, first, 0);
        const int count = first_[at(last)] - first_[at(first)];
        law(first).update(count, points(), &strain_[from], &committed_[from], &trial_[from],
                          can_yield_ ? &tangent_[from] : nullptr, &yielding_[from]);
    }
    evaluated_ += first_[at(end)] - first_[at(begin)];
}

void PointHistory::commit(bool reversal, const ElementSet& without_trial) {
    if (half_cycle_ended_) std::ranges::fill(flow_, 0.0);
    const auto p = at(state::accumulated) * at(points());
    for_each_run(without_trial, false, [&](int begin, int end) {
        for (auto q = at(first_[at(begin)]); q < at(first_[at(end)]); ++q)
            if (yielding_[q] != 0) flow_[q] += trial_[p + q] - committed_[p + q];
        commit(begin, end);
    });
    half_cycle_ended_ = reversal;
}

void PointHistory::copy(int begin, int end, const std::vector<double>& from, std::vector<double>& to) const {
    for (int c = 0; c < state_size_; ++c) {
        const auto first = static_cast<std::ptrdiff_t>(place(c, begin, 0));
        std::copy_n(from.begin() + first, first_[at(end)] - first_[at(begin)], to.begin() + first);
    }
}

Mandel PointHistory::plastic_strain(int e, std::size_t q) const {
    return can_yield_ ? tensor(committed_, state::plastic_strain, e, q) : Mandel(Mandel::Zero());
}

MandelMatrix PointHistory::tangent(int e, std::size_t q) const {
    MandelMatrix D;
    for (int c = 0; c < 16; ++c) D(c / 4, c % 4) = tangent_[place(c, e, q)];
    return D;
}

bool PointHistory::yields(int e) const {
    return std::ranges::any_of(std::span(&yielding_[place(0, e, 0)], at(points(e))), [](auto y) { return y != 0; });
}

void PointHistory::set_elastic(int e) {
    std::fill_n(&yielding_[place(0, e, 0)], points(e), static_cast<unsigned char>(0));
}

int PointHistory::yielding_points(int e) const {
    return static_cast<int>(
        std::ranges::count_if(std::span(&yielding_[place(0, e, 0)], at(points(e))), [](auto y) { return y != 0; }));
}

double PointHistory::largest_plastic_increment(int e) const {
    double largest = 0.0;
    for (std::size_t q = 0; q < at(points(e)); ++q) {
        const std::size_t accumulated = place(state::accumulated, e, q);
        if (yields(e, q)) largest = std::max(largest, trial_[accumulated] - committed_[accumulated]);
    }
    return largest;
}

bool PointHistory::is_plastic(int e) const {
    return std::ranges::any_of(std::span(&flow_[place(0, e, 0)], at(points(e))), [](double p) { return p > 0.0; });
}

void PointHistory::take(int begin, int end, const PointHistory& other, int from) {
    const auto count = first_[at(end)] - first_[at(begin)];
    for (int c = 0; c < std::min(state_size_, other.state_size_); ++c)
        std::copy_n(&other.committed_[other.place(c, from, 0)], count, &committed_[place(c, begin, 0)]);
    std::copy_n(&other.flow_[other.place(0, from, 0)], count, &flow_[place(0, begin, 0)]);
    if (!other.has_frozen_gradients()) return;
    begin_frozen_gradients();
    std::copy_n(&other.frozen_gradient_[other.place(0, from, 0)], count, &frozen_gradient_[place(0, begin, 0)]);
}

void PointHistory::add_share(int e, std::size_t q, double share, const PointHistory& other, int from,
                             std::size_t from_q) {
    for (int c = 0; c < state_size_; ++c) committed_[place(c, e, q)] += share * other.committed(c, from, from_q);
    flow_[place(0, e, q)] += share * other.flow(from, from_q);
}

Eigen::Matrix2d PointHistory::frozen_gradient(int e, std::size_t q) const {
    return frozen_gradient_.empty() ? Eigen::Matrix2d::Zero().eval() : frozen_gradient_[place(0, e, q)];
}

void PointHistory::freeze_gradient(int e, std::size_t q, const Eigen::Matrix2d& gradient) {
    begin_frozen_gradients();
    frozen_gradient_[place(0, e, q)] = gradient;
}

void PointHistory::begin_frozen_gradients() {
    if (frozen_gradient_.empty()) frozen_gradient_.assign(at(points()), Eigen::Matrix2d::Zero());
}

}  // namespace stria::fine
