#include "app/charts/chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numeric>

#include "app/charts/scale.hpp"
#include "common/index.hpp"

namespace stria::charts {

namespace {

// Pixels of the drawing's own; the page scales it.
constexpr double width = 460.0, plot_height = 220.0;
constexpr double left = 60.0, right = 14.0, top = 32.0, below = 44.0, legend_line = 17.0;
constexpr double bar_height = 16.0, bar_pitch = 24.0, bar_left = 150.0, letter = 6.2;

// Okabe and Ito: told apart with every kind of colour vision.
constexpr std::array<const char*, 7> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                "#e69f00", "#56b4e9", "#222222"};
constexpr std::array<const char*, 4> dashes = {"none", "7 3", "2 3", "8 3 2 3"};

std::string text_at(double x, double y, const char* anchor, const std::string& text, const std::string& more = "") {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                       escaped(text));
}

std::string marker_at(std::size_t curve, double x, double y) {
    const char* colour = colours[curve % colours.size()];
    switch (curve % 4) {
    case 0:
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\">", x, y, colour);
    case 1:
        return fmt::format("<path d=\"M{:.1f} {:.1f}h6v6h-6z\" fill=\"{}\">", x - 3, y - 3, colour);
    case 2:
        return fmt::format("<path d=\"M{:.1f} {:.1f}l4 7h-8z\" fill=\"{}\">", x, y - 4, colour);
    default:
        return fmt::format("<path d=\"M{:.1f} {:.1f}l4 4l-4 4l-4 -4z\" fill=\"{}\">", x, y - 4, colour);
    }
}

const char* end_of_marker(std::size_t curve) { return curve % 4 == 0 ? "</circle>\n" : "</path>\n"; }

std::string framed(const std::string& title, double height, const std::string& body) {
    return fmt::format("<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" xmlns=\"http://www.w3.org/2000/svg\" "
                       "font-family=\"sans-serif\" font-size=\"11\" fill=\"#222\">\n<title>{}</title>\n{}{}</svg>\n",
                       width, height, escaped(title),
                       text_at(left, 16.0, "start", title, " font-weight=\"bold\" font-size=\"12\""), body);
}

struct Point {
    double x, y;
};

std::vector<Point> shown_points(const LineChart& chart, const Curve& curve) {
    std::vector<Point> points;
    for (std::size_t k = 0; k < std::min(curve.x.size(), curve.y.size()); ++k) {
        const Point point{curve.x[k], curve.y[k]};
        const bool finite = std::isfinite(point.x) && std::isfinite(point.y);
        if (finite && (!chart.log_x || point.x > 0.0) && (!chart.log_y || point.y > 0.0)) points.push_back(point);
    }
    return points;
}

Range range_of(const std::vector<std::vector<Point>>& curves, double Point::*coordinate) {
    Range range{INFINITY, -INFINITY};
    for (const std::vector<Point>& points : curves) {
        for (const Point& point : points) {
            range.low = std::min(range.low, point.*coordinate);
            range.high = std::max(range.high, point.*coordinate);
        }
    }
    return range;
}

Scale make_scale(Range range, bool logarithmic, Range pixels) {
    return {logarithmic ? log_ticks(range) : linear_ticks(range, 5), logarithmic, pixels};
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

std::string frame_of(const LineChart& chart, const Scale& x, const Scale& y) {
    const double bottom = top + plot_height;
    std::string text;
    const std::vector<std::string> heights = tick_labels(y.ticks());
    for (std::size_t k = 0; k < heights.size(); ++k) {
        const double at = y(y.ticks()[k]);
        text += fmt::format("<path d=\"M{:.1f} {:.1f}H{:.1f}\" stroke=\"#ddd\"/>\n", left, at, width - right);
        text += text_at(left - 6.0, at + 4.0, "end", heights[k]);
    }
    const std::vector<std::string> labels = chart.words.empty() ? tick_labels(x.ticks()) : chart.words;
    for (std::size_t k = 0; k < labels.size(); ++k) {
        const double at = x(x.ticks()[k]);
        text += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"#ddd\"/>\n", at, top, bottom);
        text += text_at(at, bottom + 15.0, "middle", labels[k]);
    }
    text += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}H{:.1f}\" stroke=\"#222\" fill=\"none\"/>\n", left, top, bottom,
                        width - right);
    return text + text_at(0.5 * (left + width - right), bottom + 33.0, "middle", chart.x_label);
}

std::string line_through(std::size_t number, const std::vector<Point>& points, const Scale& x, const Scale& y) {
    std::vector<std::string> corners;
    for (const Point& point : points) corners.push_back(fmt::format("{:.1f},{:.1f}", x(point.x), y(point.y)));
    return fmt::format("<polyline points=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.6\" "
                       "stroke-dasharray=\"{}\"/>\n",
                       fmt::join(corners, " "), colours[number % colours.size()], dashes[number % dashes.size()]);
}

std::string markers_of(const Curve& curve, std::size_t number, const std::vector<Point>& points, const Scale& x,
                       const Scale& y) {
    std::string text;
    for (const Point& point : points) {
        text += marker_at(number, x(point.x), y(point.y));
        text += fmt::format("<title>{}{:.6g}, {:.6g}</title>", curve.name.empty() ? "" : escaped(curve.name) + ": ",
                            point.x, point.y);
        text += end_of_marker(number);
    }
    return text;
}

std::string legend_of(const LineChart& chart, double y) {
    std::string text;
    for (std::size_t k = 0; k < chart.curves.size(); ++k, y += legend_line) {
        if (chart.words.empty())
            text += fmt::format("<path d=\"M{:.1f} {:.1f}h28\" stroke=\"{}\" stroke-width=\"1.6\" "
                                "stroke-dasharray=\"{}\"/>\n",
                                left, y, colours[k % colours.size()], dashes[k % dashes.size()]);
        if (chart.curves[k].markers) text += marker_at(k, left + 14.0, y) + end_of_marker(k);
        text += text_at(left + 36.0, y + 4.0, "start", chart.curves[k].name);
    }
    return text;
}

/// One entry after the other, in as many lines as it takes; `y` ends at the last one.
std::string bar_legend(const BarChart& chart, double& y) {
    std::string text;
    double x = left;
    for (std::size_t k = 0; k < chart.parts.size(); ++k) {
        const double room = 30.0 + letter * static_cast<double>(chart.parts[k].size());
        if (x + room > width) {
            x = left;
            y += legend_line;
        }
        text += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"11\" height=\"11\" fill=\"{}\"/>\n", x, y - 9.0,
                            colours[k % colours.size()]);
        text += text_at(x + 15.0, y, "start", chart.parts[k]);
        x += room;
    }
    return text;
}

std::string drawn(const Bar& bar, const BarChart& chart, double y, const Scale& x) {
    const std::size_t room = static_cast<std::size_t>((bar_left - 10.0) / letter);
    const std::string name = bar.name.size() <= room ? bar.name : bar.name.substr(0, room - 3) + "...";
    std::string text = text_at(bar_left - 6.0, y + 12.0, "end", name);
    double sum = 0.0;
    for (std::size_t k = 0; k < bar.lengths.size(); ++k) {
        const double length = std::isfinite(bar.lengths[k]) ? std::max(0.0, bar.lengths[k]) : 0.0;
        text += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.0f}\" fill=\"{}\">"
                            "<title>{} {}: {:.4g}</title></rect>\n",
                            x(sum), y, x(sum + length) - x(sum), bar_height, colours[k % colours.size()],
                            escaped(bar.name), escaped(chart.parts[k]), length);
        sum += length;
    }
    return text;
}

}  // namespace

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

std::string svg(const LineChart& chart) {
    std::vector<std::vector<Point>> points;
    for (const Curve& curve : chart.curves) points.push_back(shown_points(chart, curve));
    if (std::ranges::all_of(points, [](const auto& of_curve) { return of_curve.empty(); })) return "";
    const Range columns{left, width - right};
    const Scale x = chart.words.empty() ? make_scale(range_of(points, &Point::x), chart.log_x, columns)
                                        : word_scale(chart.words.size(), columns);
    Range heights = range_of(points, &Point::y);
    if (chart.from_zero && !chart.log_y) heights = {std::min(0.0, heights.low), std::max(0.0, heights.high)};
    const Scale y = make_scale(heights, chart.log_y, {top + plot_height, top});
    std::string body = frame_of(chart, x, y);
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (chart.words.empty()) body += line_through(k, points[k], x, y);
        if (chart.curves[k].markers) body += markers_of(chart.curves[k], k, points[k], x, y);
    }
    const double bottom = top + plot_height + below;
    if (chart.curves.size() < 2) return framed(chart.title, bottom, body);
    body += legend_of(chart, bottom + 8.0);
    return framed(chart.title, bottom + legend_line * static_cast<double>(chart.curves.size()) + 4.0, body);
}

std::string svg(const BarChart& chart) {
    double longest = 0.0;
    for (const Bar& bar : chart.bars) {
        double sum = 0.0;
        for (const double length : bar.lengths) sum += std::isfinite(length) ? std::max(0.0, length) : 0.0;
        longest = std::max(longest, sum);
    }
    if (longest == 0.0) return "";
    const Scale x(linear_ticks({0.0, longest}, 5), false, {bar_left, width - right});
    double y = top + 4.0;
    std::string body = bar_legend(chart, y);
    const double first = y + 16.0, bottom = first + bar_pitch * static_cast<double>(chart.bars.size());
    const std::vector<std::string> labels = tick_labels(x.ticks());
    for (std::size_t k = 0; k < labels.size(); ++k) {
        const double at = x(x.ticks()[k]);
        body += fmt::format("<path d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"#ddd\"/>\n", at, first - 4.0, bottom);
        body += text_at(at, bottom + 15.0, "middle", labels[k]);
    }
    y = first;
    for (const Bar& bar : chart.bars) {
        body += drawn(bar, chart, y, x);
        y += bar_pitch;
    }
    body += text_at(0.5 * (bar_left + width - right), bottom + 33.0, "middle", chart.x_label);
    return framed(chart.title, bottom + below, body);
}

}  // namespace stria::charts
