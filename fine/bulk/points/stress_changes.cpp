#include "fine/bulk/points/stress_changes.hpp"

#include <algorithm>
#include <cmath>

namespace stria::fine {

void StressChanges::add_element(const ElementOperator& op, const VonMisesForm& form) {
    add_record(op, form);
    for (Eigen::Index f = 0; f < std::ssize(op.unknowns) / 2; ++f)
        for (const Eigen::Index direction : {0, 1})
            for (std::size_t q = 0; q < op.points.size(); ++q) values_.push_back(op.gradients[q](f, direction));
}

void StressChanges::add_element_of(const StressChanges& other, int element, const ElementOperator& op) {
    const Record& record = other.records_[at(element)];
    add_record(op, record.form);
    const auto values = other.values_.begin() + record.first;
    std::copy_n(values, record.unknowns, values_.end() - record.unknowns);
    values_.insert(values_.end(), values + record.unknowns, values + record.unknowns * (1 + record.points));
}

void StressChanges::add_record(const ElementOperator& op, const VonMisesForm& form) {
    records_.push_back(
        {std::ssize(op.unknowns), std::ssize(op.points), std::ssize(unknowns_), std::ssize(values_), form});
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
double StressChanges::at_displacement(int element, const Eigen::VectorXd& u) const {
    const Record& record = records_[at(element)];
    if (record.unknowns == 8) return largest<8>(record, u);
    if (record.unknowns == 16) return largest<16>(record, u);
    return largest<Eigen::Dynamic>(record, u);
}

// In blocks of fixed size, which lie in registers.
template <int unknowns> double StressChanges::largest(const Record& record, const Eigen::VectorXd& u) const {
    constexpr Eigen::Index block = 4;
    Eigen::Matrix<double, unknowns, 1> moved(record.unknowns);
    for (Eigen::Index k = 0; k < moved.size(); ++k)
        moved[k] = u[unknowns_[at(record.first_unknown + k)]] - values_[at(record.first + k)];
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
