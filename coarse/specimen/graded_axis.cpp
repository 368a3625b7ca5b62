#include "coarse/specimen/graded_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

constexpr double max_cells = 1e6;

/// An anchor's wish is flat this far around it: then no cell that holds the anchor, centred or not, exceeds `size`.
double flat_reach(const AxisGrading& grading) { return grading.centred ? grading.size : 0.0; }

/// h(x) as wished by one grading.
double wish(const AxisGrading& grading, double x) {
    const double flat = flat_reach(grading);
    const double distance = std::max({0.0, grading.low - flat - x, x - grading.high - flat});
    if (distance < grading.radius) {
        return grading.size + (grading.outer_size - grading.size) * distance / grading.radius;
    }
    return grading.outer_size + grading.growth * (distance - grading.radius);
}

/// Cell length h(x) as a continuous piecewise linear function, with the exact integral of 1/h: the number of cells.
class CellLength {
public:
    CellLength(double length, double size, std::span<const AxisGrading> gradings)
        : length_(length), size_(size), gradings_(gradings) {
        const std::vector<double> kinks = kinks_of_wishes();
        for (std::size_t k = 0; k + 1 < kinks.size(); ++k) add_pieces(kinks[k], kinks[k + 1]);
        positions_.push_back(length_);
        cells_.push_back(0.0);
        for (std::size_t k = 1; k < positions_.size(); ++k) cells_.push_back(cells_.back() + cells_between(k - 1));
    }

    [[nodiscard]] double size_at(double x) const {
        double smallest = size_;
        for (const AxisGrading& grading : gradings_) smallest = std::min(smallest, wish(grading, x));
        return smallest;
    }

    /// Integral of 1/h from 0 to x.
    [[nodiscard]] double cells_before(double x) const {
        const auto above = std::upper_bound(positions_.begin() + 1, positions_.end() - 1, x);
        const auto piece = at(above - positions_.begin()) - 1;
        return cells_[piece] + cells_from_to(positions_[piece], x);
    }

    /// The x with cells_before(x) = cells.
    [[nodiscard]] double position_after(double cells) const {
        const auto above = std::upper_bound(cells_.begin() + 1, cells_.end() - 1, cells);
        const auto piece = at(above - cells_.begin()) - 1;
        const double from = positions_[piece], h = size_at(from), count = cells - cells_[piece];
        const double slope = (size_at(positions_[piece + 1]) - h) / (positions_[piece + 1] - from);
        const double stretch = slope * count;
        return from + h * count * (std::abs(stretch) < 1e-12 ? 1.0 : std::expm1(stretch) / stretch);
    }

private:
    [[nodiscard]] std::vector<double> kinks_of_wishes() const {
        std::vector<double> kinks{0.0, length_};
        for (const AxisGrading& grading : gradings_) {
            const double flat = flat_reach(grading);
            for (const double reach : {flat, flat + grading.radius}) {
                for (const double kink : {grading.low - reach, grading.high + reach}) {
                    if (0.0 < kink && kink < length_) kinks.push_back(kink);
                }
            }
        }
        std::sort(kinks.begin(), kinks.end());
        kinks.erase(std::unique(kinks.begin(), kinks.end()), kinks.end());
        return kinks;
    }

    /// Between kinks every wish is linear: the smallest changes hands only where two of them, or one and `size`, cross.
    void add_pieces(double from, double to) {
        std::vector<std::pair<double, double>> ends{{size_, size_}};
        for (const AxisGrading& grading : gradings_) ends.emplace_back(wish(grading, from), wish(grading, to));
        std::vector<double> starts{from};
        for (std::size_t i = 0; i < ends.size(); ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                const double before = ends[i].first - ends[j].first, after = ends[i].second - ends[j].second;
                if (before * after < 0.0) starts.push_back(from + (to - from) * before / (before - after));
            }
        }
        std::sort(starts.begin(), starts.end());
        starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
        positions_.insert(positions_.end(), starts.begin(), starts.end());
    }

    /// Integral of 1/h where h is linear: the length over the logarithmic mean of its ends.
    [[nodiscard]] double cells_from_to(double from, double to) const {
        const double h = size_at(from), change = (size_at(to) - h) / h;
        return (to - from) / h * (std::abs(change) < 1e-12 ? 1.0 : std::log1p(change) / change);
    }

    [[nodiscard]] double cells_between(std::size_t piece) const {
        return cells_from_to(positions_[piece], positions_[piece + 1]);
    }

    double length_;
    double size_;
    std::span<const AxisGrading> gradings_;
    std::vector<double> positions_;  // between two of them h is linear
    std::vector<double> cells_;      // before each position
};

/// A cell with a given middle; of length 0 it is a position that must be one.
struct CentralCell {
    double middle;
    double length;

    [[nodiscard]] bool is_line() const { return length == 0.0; }
};

/// Anchors that get a cell of their own and lines, from left to right, with the length h there.
std::vector<CentralCell> anchors_of(double length, const CellLength& h, std::span<const AxisGrading> gradings,
                                    std::span<const double> lines) {
    std::vector<double> middles;
    for (const AxisGrading& grading : gradings) {
        if (grading.centred) middles.push_back(0.5 * (grading.low + grading.high));
    }
    std::sort(middles.begin(), middles.end());
    std::vector<CentralCell> anchors;
    for (const double middle : middles) {
        const double cell = h.size_at(middle);
        const bool sliver = middle < 0.75 * cell || length - middle < 0.75 * cell ||
                            (!anchors.empty() && middle - anchors.back().middle < cell) ||
                            std::ranges::any_of(lines, [&](double x) { return std::abs(x - middle) < 0.75 * cell; });
        if (!sliver) anchors.push_back({middle, cell});
    }
    const double rounding = 1e-9 * length;
    for (const double line : lines)
        if (line > rounding && line < length - rounding) anchors.push_back({line, 0.0});
    std::ranges::sort(anchors, {}, &CentralCell::middle);
    return anchors;
}

/// Cells between two stops would be stretched to fit an integer: an anchor's cell shrinks like the smaller of its
/// sides.
void shrink_like_neighbours(std::vector<CentralCell>& anchors, double length, const CellLength& h) {
    constexpr double rounding = 1e-9;
    std::vector<double> shrink(anchors.size(), 1.0);
    for (std::size_t gap = 0; gap <= anchors.size(); ++gap) {
        const bool first = gap == 0, last = gap == anchors.size();
        const double from = first ? 0.0 : anchors[gap - 1].middle, to = last ? length : anchors[gap].middle;
        const double wished = h.cells_before(to) - h.cells_before(from);
        const double halves =
            0.5 * (first || anchors[gap - 1].is_line() ? 0 : 1) + 0.5 * (last || anchors[gap].is_line() ? 0 : 1);
        const double fitted = std::max(std::ceil(wished - halves - rounding), 1.0) + halves;
        if (!first) shrink[gap - 1] = std::min(shrink[gap - 1], wished / fitted);
        if (!last) shrink[gap] = std::min(shrink[gap], wished / fitted);
    }
    for (std::size_t k = 0; k < anchors.size(); ++k) anchors[k].length *= shrink[k];
}

/// Adds the positions after `from` up to `to`, an integer number of cells proportional to h.
void divide(double from, double to, const CellLength& h, bool to_nearest, std::vector<double>& positions) {
    constexpr double rounding = 1e-9;
    const double before = h.cells_before(from), wished = h.cells_before(to) - before;
    const double count = std::max(1.0, to_nearest ? std::round(wished) : std::ceil(wished - rounding));
    for (int k = 1; k < static_cast<int>(count); ++k) {
        positions.push_back(h.position_after(before + wished * k / count));
    }
    positions.push_back(to);
}

}  // namespace

std::vector<double> graded_axis(double length, double size, std::span<const AxisGrading> gradings,
                                std::span<const double> lines) {
    const CellLength h(length, size, gradings);
    if (h.cells_before(length) > max_cells) {
        throw CaseError(fmt::format("mesh.size: {:.3g} cells along one axis, at most {:.0e} are allowed",
                                    h.cells_before(length), max_cells));
    }
    std::vector<CentralCell> anchors = anchors_of(length, h, gradings, lines);
    shrink_like_neighbours(anchors, length, h);

    std::vector<double> positions{0.0};
    for (const CentralCell& anchor : anchors) {
        divide(positions.back(), anchor.middle - 0.5 * anchor.length, h, gradings.empty(), positions);
        if (!anchor.is_line()) positions.push_back(anchor.middle + 0.5 * anchor.length);
    }
    divide(positions.back(), length, h, gradings.empty(), positions);
    return positions;
}

}  // namespace stria::coarse
