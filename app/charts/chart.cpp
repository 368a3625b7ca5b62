#include "app/charts/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include "app/charts/drawing.hpp"
#include "app/charts/scale.hpp"
#include "common/index.hpp"

namespace stria::charts {

namespace {

constexpr double plot_height = 220.0, bottom = top + plot_height;
constexpr std::size_t most_markers = 40;  // of a curve: more hide one another, and each is large in the file
constexpr int columns_wanted = 7, rows_wanted = 5;

constexpr std::array<const char*, 4> dashes = {"none", "7 3", "2 3", "8 3 2 3"};

/// The shape of the marker about a point; each curve has its own, as it has its own colour.
std::string marker_at(std::size_t curve, double x, double y, const std::string& title = "") {
    std::array<std::string, 4> shapes = {
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\"", x, y),
        fmt::format("<path d=\"M{:.1f} {:.1f}h6v6h-6z\"", x - 3, y - 3),
        fmt::format("<path d=\"M{:.1f} {:.1f}l4 7h-8z\"", x, y - 4),
        fmt::format("<path d=\"M{:.1f} {:.1f}l4 4l-4 4l-4 -4z\"", x, y - 4),
    };
    const std::string inner = title.empty() ? "" : "<title>" + escaped(title) + "</title>";
    return fmt::format("{} class=\"{}\" fill=\"currentColor\">{}</{}>\n", shapes[curve % 4], colour_class(curve), inner,
                       curve % 4 == 0 ? "circle" : "path");
}

struct Point {
    double x, y;
    std::size_t number;  // in its curve
};

std::vector<Point> shown_points(const LineChart& chart, const Curve& curve) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < std::min(curve.x.size(), curve.y.size()); ++k) {
        const Point point{curve.x[k], curve.y[k], k};
        const bool finite = std::isfinite(point.x) && std::isfinite(point.y);
        if (finite && (!chart.log_x || point.x > 0.0) && (!chart.log_y || point.y > 0.0)) points.push_back(point);
    }
    return points;
}

std::vector<const Curve*> all_curves(const LineChart& chart) {
    std::vector<const Curve*> all;
    for (const Curve& curve : chart.curves) all.push_back(&curve);
    for (const Frame& frame : chart.frames)
        for (const Curve& curve : frame.curves) all.push_back(&curve);
    return all;
}

/// Of all points that can be shown; its low end is above its high one where there is none.
Range range_of(const LineChart& chart, double Point::*coordinate) {
    Range range{INFINITY, -INFINITY};
    for (const Curve* curve : all_curves(chart)) {
        for (const Point& point : shown_points(chart, *curve)) {
            range.low = std::min(range.low, point.*coordinate);
            range.high = std::max(range.high, point.*coordinate);
        }
    }
    return range;
}

Scale make_scale(Range range, bool logarithmic, int wanted, Range pixels) {
    return {logarithmic ? log_ticks(range) : linear_ticks(range, wanted), logarithmic, pixels};
}

Scale word_scale(std::size_t words, Range pixels) {
    std::vector<double> ticks(words);
    std::iota(ticks.begin(), ticks.end(), 0.0);
    // Half a place of room on either side.
    const double place = (pixels.high - pixels.low) / static_cast<double>(std::max<std::size_t>(1, words));
    if (words == 1) ticks = {0.0, 1.0};
    const Range inner{pixels.low + 0.5 * place, words == 1 ? pixels.high : pixels.high - 0.5 * place};
    return {std::move(ticks), false, inner};
}

/// What the curves are drawn into, and whether they bear markers: all of them or none.
struct Plane {
    Scale x, y;
    bool markers;
};

bool have_few_points(const LineChart& chart) {
    return std::ranges::all_of(all_curves(chart), [](const Curve* curve) { return curve->x.size() <= most_markers; });
}

Plane plane_of(const LineChart& chart, Range columns, Range heights) {
    const Range pixels{left, width - right};
    if (chart.from_zero && !chart.log_y) heights = {std::min(0.0, heights.low), std::max(0.0, heights.high)};
    return {chart.words.empty() ? make_scale(columns, chart.log_x, columns_wanted, pixels)
                                : word_scale(chart.words.size(), pixels),
            make_scale(heights, chart.log_y, rows_wanted, {bottom, top}), have_few_points(chart)};
}

std::string axes_of(const LineChart& chart, const Plane& plane) {
    std::string text;
    const std::vector<std::string> heights = tick_labels(plane.y.ticks());
    for (std::size_t k = 0; k < heights.size(); ++k) {
        const double at = plane.y(plane.y.ticks()[k]);
        text += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"currentColor\"/>\n", left, at,
                            width - right);
        text += text_at(left - 6.0, at + 4.0, "end", heights[k]);
    }
    const std::vector<std::string> labels = chart.words.empty() ? tick_labels(plane.x.ticks()) : chart.words;
    for (std::size_t k = 0; k < labels.size(); ++k) {
        const double at = plane.x(plane.x.ticks()[k]);
        text += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"currentColor\"/>\n", at, top,
                            bottom);
        text += text_at(at, bottom + 15.0, "middle", labels[k]);
    }
    text += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}H{:.1f}\" stroke=\"currentColor\" fill=\"none\"/>\n", left, top,
                        bottom, width - right);
    return text + text_at(0.5 * (left + width - right), bottom + 33.0, "middle", chart.x_label);
}

std::string dashed_stroke(std::size_t number) {
    return fmt::format("class=\"{}\" stroke=\"currentColor\" stroke-width=\"1.6\" stroke-dasharray=\"{}\"",
                       colour_class(number), dashes[number % dashes.size()]);
}

/// The line ends where a point is missing, and begins anew behind it; a point by itself is a dot.
std::string strokes_through(const std::vector<Point>& points, const Plane& plane) {
    std::string path;
    const auto follows = [&](std::size_t k) { return k > 0 && points[k].number == points[k - 1].number + 1; };
    for (std::size_t k = 0; k < points.size(); ++k) {
        path += fmt::format("{}{:.1f} {:.1f}", follows(k) ? 'L' : 'M', plane.x(points[k].x), plane.y(points[k].y));
        if (!follows(k) && (k + 1 == points.size() || !follows(k + 1))) path += "h1";
    }
    return path;
}

std::string line_through(const Curve& curve, std::size_t number, const std::vector<Point>& points, const Plane& plane) {
    const std::string path = strokes_through(points, plane);
    if (curve.filled)
        return fmt::format("<path d=\"{}z\" class=\"{}\" stroke=\"currentColor\" fill=\"currentColor\" "
                           "fill-opacity=\"0.25\"/>\n",
                           path, colour_class(number));
    return fmt::format("<path d=\"{}\" fill=\"none\" {}/>\n", path, dashed_stroke(number));
}

std::string markers_of(const Curve& curve, std::size_t number, const std::vector<Point>& points, const Plane& plane) {
    std::string text;
    for (const Point& point : points) {
        const std::string name = point.number < curve.points.size() ? curve.points[point.number] : "";
        std::string title = curve.name.empty() ? "" : curve.name + ": ";
        title += name.empty() ? "" : name + ": ";
        const double x = plane.x(point.x), y = plane.y(point.y);
        text += marker_at(number, x, y, title + fmt::format("{:.6g}, {:.6g}", point.x, point.y));
        // On the side where there is room.
        const bool to_the_left = x > 0.7 * width;
        if (!name.empty())
            text += text_at(to_the_left ? x - 7.0 : x + 7.0, y - 4.0, to_the_left ? "end" : "start", name,
                            " font-size=\"10\"");
    }
    return text;
}

/// Markers of a cloud, short in the file.
std::string dots_at(std::size_t number, const std::vector<Point>& points, const Plane& plane) {
    std::string strokes;
    for (const Point& point : points) strokes += fmt::format("M{:.1f} {:.1f}h0", plane.x(point.x), plane.y(point.y));
    return fmt::format("<path d=\"{}\" class=\"{}\" stroke=\"currentColor\" stroke-width=\"3.5\" "
                       "stroke-linecap=\"round\"/>\n",
                       strokes, colour_class(number));
}

std::string drawn(const LineChart& chart, const Curve& curve, std::size_t number, const Plane& plane) {
    const std::vector<Point> points = shown_points(chart, curve);
    std::string text;
    if (points.empty()) return text;
    if (curve.line && chart.words.empty()) text += line_through(curve, number, points, plane);
    if (!curve.markers || curve.filled) return text;
    if (plane.markers) return text + markers_of(curve, number, points, plane);
    return curve.line ? text : text + dots_at(number, points, plane);
}

std::string drawn(const LineChart& chart, std::size_t frame, const Plane& plane) {
    std::string text =
        fmt::format("<g class=\"frame{}\" data-k=\"{}\">\n", frame == chart.shown ? " shown" : "", frame);
    std::size_t number = chart.curves.size();
    for (const Curve& curve : chart.frames[frame].curves) text += drawn(chart, curve, number++, plane);
    return text + "</g>\n";
}

/// Curves that are always there and those of a frame, which have the same names in all frames.
std::vector<const Curve*> named_curves(const LineChart& chart) {
    std::vector<const Curve*> named = all_curves(chart);
    named.resize(chart.curves.size() + (chart.frames.empty() ? 0 : chart.frames.front().curves.size()));
    return named;
}

std::string legend_of(const LineChart& chart, const std::vector<const Curve*>& curves) {
    std::string text;
    double y = bottom + below + 8.0;
    for (std::size_t k = 0; k < curves.size(); ++k, y += legend_line) {
        if (chart.words.empty() && curves[k]->line)
            text += fmt::format("<path d=\"M{:.1f} {:.1f}h28\" {}/>\n", left, y, dashed_stroke(k));
        if (curves[k]->markers && (have_few_points(chart) || !curves[k]->line)) text += marker_at(k, left + 14.0, y);
        text += text_at(left + 36.0, y + 4.0, "start", curves[k]->name);
    }
    return text;
}

}  // namespace

std::string svg(const LineChart& chart) {
    const Range columns = range_of(chart, &Point::x), heights = range_of(chart, &Point::y);
    if (columns.low > columns.high) return "";
    const Plane plane = plane_of(chart, columns, heights);
    std::string body = axes_of(chart, plane);
    for (std::size_t k = 0; k < chart.curves.size(); ++k) body += drawn(chart, chart.curves[k], k, plane);
    for (std::size_t k = 0; k < chart.frames.size(); ++k) body += drawn(chart, k, plane);
    const std::vector<const Curve*> named = named_curves(chart);
    if (named.size() < 2) return framed(chart.title, bottom + below, body);
    body += legend_of(chart, named);
    return framed(chart.title, bottom + below + legend_line * static_cast<double>(named.size()) + 4.0, body);
}

}  // namespace stria::charts
