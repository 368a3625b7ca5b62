#include "fine/bulk/points/stress_changes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace stria::fine {

namespace {

constexpr Eigen::Index four_functions = 8;  // unknowns

/// A von Mises stress is a convex function of the strain, and that is linear in the place within a parallelogram. Where
/// its points stand in a rectangle of rows no other one changes more than all four at the corners.
std::vector<std::size_t> points_that_tell(const ElementOperator& op, const std::array<Vec2, 4>& corners) {
    constexpr double rounding = 1e-12;
    std::vector<std::size_t> all(op.points.size()), outermost;
    std::iota(all.begin(), all.end(), std::size_t{0});
    const Vec2 warp = corners[0] - corners[1] + corners[2] - corners[3];
    const double size = (corners[2] - corners[0]).norm();
    if (std::ssize(op.unknowns) != four_functions || warp.norm() > rounding * size) return all;
    Vec2 least = op.points.front().xi, most = least;
    for (const IntegrationPoint& point : op.points) {
        least = least.cwiseMin(point.xi);
        most = most.cwiseMax(point.xi);
    }
    const auto ends = [&](double x, Eigen::Index axis) { return std::min(x - least[axis], most[axis] - x) < rounding; };
    for (const std::size_t q : all)
        if (ends(op.points[q].xi.x(), 0) && ends(op.points[q].xi.y(), 1)) outermost.push_back(q);
    return outermost.size() == 4 ? outermost : all;
}

/// Of a motion of four nodes, less that of their mean, which strains nothing.
double centred_square(const Eigen::Matrix<double, four_functions, 1>& moved) {
    const auto of_node = [&](Eigen::Index k) { return moved.segment<2>(2 * k); };
    const Vec2 mean = 0.25 * ((of_node(0) + of_node(1)) + (of_node(2) + of_node(3)));
    Vec2 squares = Vec2::Zero();
    for (Eigen::Index k = 0; k < 4; ++k) squares += (of_node(k) - mean).cwiseAbs2();
    return squares.sum();
}

}  // namespace

void StressChanges::add_element(const ElementOperator& op, const std::array<Vec2, 4>& corners,
                                const VonMisesForm& form) {
    const std::vector<std::size_t> points = points_that_tell(op, corners);
    double steepest = 0.0;  // the functions' gradients in the place of one of them
    for (const std::size_t q : points) steepest = std::max(steepest, op.gradients[q].squaredNorm());
    add_record(op, std::ssize(points), form, form.steepest() * steepest);
    for (Eigen::Index f = 0; f < std::ssize(op.unknowns) / 2; ++f)
        for (const Eigen::Index direction : {0, 1})
            for (const std::size_t q : points) values_.push_back(op.gradients[q](f, direction));
}

void StressChanges::add_element_of(const StressChanges& other, int element, const ElementOperator& op) {
    const Record& record = other.records_[at(element)];
    add_record(op, record.points, record.form, record.steepest);
    const auto values = other.values_.begin() + record.first;
    std::copy_n(values, record.unknowns, values_.end() - record.unknowns);
    values_.insert(values_.end(), values + record.unknowns, values + record.unknowns * (1 + record.points));
}

void StressChanges::add_record(const ElementOperator& op, Eigen::Index points, const VonMisesForm& form,
                               double steepest) {
    records_.push_back({std::ssize(op.unknowns), points, std::ssize(unknowns_), std::ssize(values_), form, steepest});
    unknowns_.insert(unknowns_.end(), op.unknowns.begin(), op.unknowns.end());
    values_.insert(values_.end(), op.unknowns.size(), 0.0);
}

void StressChanges::reserve(std::span<const ElementOperator> operators) {
    std::size_t unknowns = 0, values = 0;
    for (const ElementOperator& op : operators) {
        unknowns += op.unknowns.size();
        values += op.unknowns.size() * (1 + op.points.size());
    }
    records_.reserve(operators.size());
    unknowns_.reserve(unknowns);
    values_.reserve(values);
}

void StressChanges::look_at(int element, const Eigen::VectorXd& element_u) {
    std::ranges::copy(element_u, values_.begin() + records_[at(element)].first);
}

// Plain elements, and those of which every corner jumps, are most of all.
bool StressChanges::stay_below(int element, const Eigen::VectorXd& u, double limit) const {
    const Record& record = records_[at(element)];
    if (record.unknowns == four_functions) return stay_below<four_functions>(record, u, limit);
    if (record.unknowns == 2 * four_functions) return stay_below<2 * four_functions>(record, u, limit);
    return stay_below<Eigen::Dynamic>(record, u, limit);
}

// The size of the motion proves half of the elements of a wake.
template <int unknowns>
bool StressChanges::stay_below(const Record& record, const Eigen::VectorXd& u, double limit) const {
    Eigen::Matrix<double, unknowns, 1> moved(record.unknowns);
    const int* const unknown = &unknowns_[at(record.first_unknown)];
    const double* const looked_at = &values_[at(record.first)];
    for (Eigen::Index k = 0; k < moved.size(); ++k) moved[k] = u[unknown[k]] - looked_at[k];
    if constexpr (unknowns == four_functions)
        if (record.steepest * centred_square(moved) < limit) return true;
    return largest<unknowns>(record, moved) < limit;
}

// In blocks of fixed size, which lie in registers.
template <int unknowns>
double StressChanges::largest(const Record& record, const Eigen::Matrix<double, unknowns, 1>& moved) const {
    constexpr Eigen::Index block = 4;
    double largest = 0.0;
    // What is not a number stays: it proves nothing.
    const auto raise = [&](double value) { largest = std::isnan(largest) || value <= largest ? largest : value; };
    Eigen::Index q = 0;
    for (; q + block <= record.points; q += block) raise(largest_of<unknowns, block>(record, q, moved));
    for (; q < record.points; ++q) raise(largest_of<unknowns, 1>(record, q, moved));
    return largest;
}

template <int unknowns, int points>
double StressChanges::largest_of(const Record& record, Eigen::Index first,
                                 const Eigen::Matrix<double, unknowns, 1>& moved) const {
    using Values = Eigen::Array<double, points, 1>;
    const double* const start = &values_[at(record.first + moved.size() + first)];
    const auto gradients = [&](Eigen::Index k) { return Eigen::Map<const Values>(start + k * record.points); };
    Values xx = Values::Zero(), yy = xx, xy = xx;
    for (Eigen::Index k = 0; k < moved.size(); k += 2) {
        const double x = moved[k], y = moved[k + 1];
        xx += x * gradients(k);
        yy += y * gradients(k + 1);
        xy += x * gradients(k + 1) + y * gradients(k);
    }
    const VonMisesForm& form = record.form;
    return (form.normal * (xx * xx + yy * yy) + form.mixed * xx * yy + form.shear * xy * xy).maxCoeff();
}

}  // namespace stria::fine
