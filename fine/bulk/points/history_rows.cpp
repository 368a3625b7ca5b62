#include "fine/bulk/points/history_rows.hpp"

#include <algorithm>
#include <array>

#include "common/error.hpp"

namespace stria::fine {
namespace {

/// So many numbers, then the state of the law.
constexpr int leading = 12;

/// Calls visit(element, point there, its place among all points), in the order of the rows.
template <class Visit> void for_each_row(const std::vector<ElementOperator>& operators, const Visit& visit) {
    std::size_t row = 0;
    for (int e = 0; e < std::ssize(operators); ++e)
        for (std::size_t q = 0; q < operators[at(e)].points.size(); ++q) visit(e, q, row++);
}

}  // namespace

std::vector<IntegrationPoint> points_of(const coupling::ZoneSnapshot& snapshot, const coupling::ElementHistory& rows) {
    std::vector<IntegrationPoint> points;
    for (std::size_t q = 0; q < rows.rows; ++q) {
        const double* row = &snapshot.history.at((rows.first_row + q) * at(snapshot.columns));
        points.push_back({.x = {row[0], row[1]},
                          .xi = {row[2], row[3]},
                          .weight = row[4],
                          .side = static_cast<int>(row[5]),
                          .region = static_cast<int>(row[6])});
    }
    return points;
}

void read_rows(const coupling::ZoneSnapshot& snapshot, const std::vector<ElementOperator>& operators,
               PointHistory& history) {
    require(snapshot.history.size() == at(snapshot.columns) * at(history.points()) &&
                snapshot.columns == leading + history.state_size(),
            "a snapshot has the points of its zone and the states of its law");
    for_each_row(operators, [&](int e, std::size_t q, std::size_t place) {
        const double* row = &snapshot.history[place * at(snapshot.columns)];
        history.set_flow(e, q, row[7]);
        Eigen::Matrix2d frozen;
        frozen << row[8], row[9], row[10], row[11];
        if (!frozen.isZero(0.0)) history.freeze_gradient(e, q, frozen);
        for (int c = 0; c < history.state_size(); ++c) history.set_value(c, e, q, row[leading + c]);
    });
}

void write_rows(const std::vector<ElementOperator>& operators, const PointHistory& history,
                coupling::ZoneSnapshot& snapshot) {
    const std::size_t columns = at(leading + history.state_size());
    snapshot.columns = static_cast<std::int32_t>(columns);
    snapshot.history.resize(columns * at(history.points()));
    for_each_row(operators, [&](int e, std::size_t q, std::size_t place) {
        const IntegrationPoint& p = operators[at(e)].points[q];
        const Eigen::Matrix2d frozen = history.frozen_gradient(e, q);
        double* const row = &snapshot.history[place * columns];
        const std::array<double, leading> first{p.x.x(),
                                                p.x.y(),
                                                p.xi.x(),
                                                p.xi.y(),
                                                p.weight,
                                                static_cast<double>(p.side),
                                                static_cast<double>(p.region),
                                                history.flow(e, q),
                                                frozen(0, 0),
                                                frozen(0, 1),
                                                frozen(1, 0),
                                                frozen(1, 1)};
        double* to = std::ranges::copy(first, row).out;
        for (int c = 0; c < history.state_size(); ++c) *to++ = history.value(c, e, q);
    });
}

}  // namespace stria::fine
