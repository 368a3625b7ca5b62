// A grid of biquadratic elements whose edges follow a bent crack, with nodes of their own on either face. It shares
// nothing with the program: with conforming/pressed_plate.hpp it is the reference of bent cracks in contact.
#pragma once

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace stria::test::conforming {

using Vec = Eigen::Vector2d;

/// A crack with x ascending, from the left side of a plate or inside.
struct Polyline {
    std::vector<Vec> points;

    [[nodiscard]] std::size_t segments() const { return points.size() - 1; }
    [[nodiscard]] bool at_edge() const { return points.front().x() == 0.0; }
    [[nodiscard]] double length(std::size_t segment) const { return (points[segment + 1] - points[segment]).norm(); }
    [[nodiscard]] Vec tangent(std::size_t segment) const {
        return (points[segment + 1] - points[segment]) / length(segment);
    }
    /// To the left of the tangent, from minus to plus.
    [[nodiscard]] Vec normal(std::size_t segment) const { return {-tangent(segment).y(), tangent(segment).x()}; }
    [[nodiscard]] std::size_t segment_at(double x) const {
        std::size_t k = 0;
        while (k + 1 < segments() && x > points[k + 1].x()) ++k;
        return k;
    }
    /// Height and arc length above x; level beyond the ends.
    [[nodiscard]] double height(double x) const {
        const double inside = std::clamp(x, points.front().x(), points.back().x());
        const Vec &a = points[segment_at(inside)], &b = points[segment_at(inside) + 1];
        return a.y() + (b.y() - a.y()) * (inside - a.x()) / (b.x() - a.x());
    }
    [[nodiscard]] double arc_length(double x) const {
        double s = 0.0;
        for (std::size_t k = 0; k < segment_at(x); ++k) s += length(k);
        return s + (Vec(x, height(x)) - points[segment_at(x)]).norm();
    }
};

/// Elements at tips and bends, mm, how they grow with the distance, and the largest, mm.
struct Sizes {
    double smallest = 0.0, growth = 0.0, largest = 0.0;
    [[nodiscard]] double at(double distance) const { return std::min(largest, smallest + growth * distance); }
};

/// Lines from the last one to `end`, close to one another towards ends that are sharp.
inline void add_lines(std::vector<double>& lines, double end, bool sharp_start, bool sharp_end, const Sizes& sizes) {
    const double start = lines.back();
    const auto size = [&](double x) {
        return std::min(sharp_start ? sizes.at(x - start) : sizes.largest,
                        sharp_end ? sizes.at(end - x) : sizes.largest);
    };
    std::vector<double> x{start}, count{0.0};  // of elements up to x
    while (x.back() < end) {
        const double step = std::min(0.02 * size(x.back()), end - x.back());
        count.push_back(count.back() + step / size(x.back() + 0.5 * step));
        x.push_back(end - x.back() <= step ? end : x.back() + step);
    }
    const int elements = std::max(1, static_cast<int>(std::ceil(count.back())));
    std::size_t k = 1;
    for (int e = 1; e < elements; ++e) {
        const double wanted = count.back() * e / elements;
        while (count[k] < wanted) ++k;
        lines.push_back(x[k - 1] + (x[k] - x[k - 1]) * (wanted - count[k - 1]) / (count[k] - count[k - 1]));
    }
    lines.push_back(end);
}

/// Of a plate from (0, 0) to (width, height). Nodes are counted row by row, corners, midpoints and centres alike.
class CrackedGrid {
public:
    CrackedGrid(double width, double height, Polyline crack, const Sizes& sizes)
        : crack_(std::move(crack)), height_(height) {
        columns_ = {0.0};
        for (const Vec& x : crack_.points)
            if (x.x() > 0.0) add_lines(columns_, x.x(), columns_.size() > 1, true, sizes);
        add_lines(columns_, width, true, false, sizes);
        std::vector<double> away{0.0};
        add_lines(away, height / 2.0, true, false, sizes);
        for (std::size_t k = away.size() - 1; k > 0; --k) rows_.push_back(-2.0 * away[k] / height);
        for (const double distance : away) rows_.push_back(2.0 * distance / height);
        crack_row_ = static_cast<int>(away.size()) - 1;
        add_twins();
    }

    [[nodiscard]] const Polyline& crack() const { return crack_; }
    [[nodiscard]] int elements_across() const { return static_cast<int>(columns_.size()) - 1; }
    [[nodiscard]] int elements_up() const { return static_cast<int>(rows_.size()) - 1; }
    [[nodiscard]] int nodes_across() const { return 2 * elements_across() + 1; }
    [[nodiscard]] int nodes() const {
        return nodes_across() * (2 * elements_up() + 1) + static_cast<int>(twins_.size());
    }

    [[nodiscard]] Vec place(int i, int j) const {
        const int i1 = (i + 1) / 2, j1 = (j + 1) / 2;
        return 0.25 * (corner(i / 2, j / 2) + corner(i1, j / 2) + corner(i / 2, j1) + corner(i1, j1));
    }
    /// `above`: of the nodes on the crack that of its plus side.
    [[nodiscard]] int node(int i, int j, bool above) const {
        const bool on_crack =
            j == 2 * crack_row_ && above && i >= first_twin_ && i < first_twin_ + static_cast<int>(twins_.size());
        return on_crack ? twins_[std::size_t(i - first_twin_)] : j * nodes_across() + i;
    }
    /// Row by row.
    [[nodiscard]] std::array<int, 9> nodes_of(int i, int j) const {
        std::array<int, 9> found{};
        for (int k = 0; k < 9; ++k) found[std::size_t(k)] = node(2 * i + k % 3, 2 * j + k / 3, j >= crack_row_);
        return found;
    }
    [[nodiscard]] std::array<Vec, 9> places_of(int i, int j) const {
        std::array<Vec, 9> found;
        for (int k = 0; k < 9; ++k) found[std::size_t(k)] = place(2 * i + k % 3, 2 * j + k / 3);
        return found;
    }

    /// Two nodes at one place of the crack, with its arc length.
    struct Pair {
        int plus, minus;
        double x, s;
    };
    [[nodiscard]] std::vector<Pair> pairs() const {
        std::vector<Pair> found;
        for (int k = 0; k < static_cast<int>(twins_.size()); ++k) {
            const int i = first_twin_ + k;
            const double x = place(i, 2 * crack_row_).x();
            found.push_back({node(i, 2 * crack_row_, true), node(i, 2 * crack_row_, false), x, crack_.arc_length(x)});
        }
        return found;
    }

private:
    [[nodiscard]] Vec corner(int i, int j) const {
        const double x = columns_[std::size_t(i)], way = rows_[std::size_t(j)], on_crack = crack_.height(x);
        return {x, on_crack + way * (way < 0.0 ? on_crack : height_ - on_crack)};
    }
    /// On all of the crack but its tips.
    void add_twins() {
        const double first = crack_.points.front().x(), last = crack_.points.back().x();
        const auto line = [&](double x) {
            return 2 * static_cast<int>(std::ranges::find(columns_, x) - columns_.begin());
        };
        first_twin_ = line(first) + (crack_.at_edge() ? 0 : 1);
        const int single = nodes_across() * (2 * elements_up() + 1);
        for (int i = first_twin_; i < line(last); ++i) twins_.push_back(single + i - first_twin_);
    }

    Polyline crack_;
    double height_;
    std::vector<double> columns_, rows_;  // rows: from -1 at the foot through 0 on the crack to 1 at the top
    int crack_row_ = 0, first_twin_ = 0;
    std::vector<int> twins_;
};

}  // namespace stria::test::conforming
