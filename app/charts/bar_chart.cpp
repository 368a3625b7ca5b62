#include "app/charts/bar_chart.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/charts/drawing.hpp"
#include "app/charts/scale.hpp"

namespace stria::charts {

namespace {

constexpr double bar_height = 16.0, bar_pitch = 24.0, bar_left = 150.0;

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
        text += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"11\" height=\"11\" class=\"{}\" "
                            "fill=\"currentColor\"/>\n",
                            x, y - 9.0, colour_class(k));
        text += text_at(x + 15.0, y, "start", chart.parts[k]);
        x += room;
    }
    return text;
}

std::string bar_at(const Bar& bar, const BarChart& chart, double y, const Scale& x) {
    const std::size_t room = static_cast<std::size_t>((bar_left - 10.0) / letter);
    const std::string name = bar.name.size() <= room ? bar.name : bar.name.substr(0, room - 3) + "...";
    std::string text = text_at(bar_left - 6.0, y + 12.0, "end", name);
    double sum = 0.0;
    for (std::size_t k = 0; k < bar.lengths.size(); ++k) {
        const double length = std::isfinite(bar.lengths[k]) ? std::max(0.0, bar.lengths[k]) : 0.0;
        text += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.0f}\" class=\"{}\" "
                            "fill=\"currentColor\"><title>{} {}: {:.4g}</title></rect>\n",
                            x(sum), y, x(sum + length) - x(sum), bar_height, colour_class(k), escaped(bar.name),
                            escaped(chart.parts[k]), length);
        sum += length;
    }
    return text;
}

}  // namespace

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
    const double first = y + 16.0, floor = first + bar_pitch * static_cast<double>(chart.bars.size());
    const std::vector<std::string> labels = tick_labels(x.ticks());
    for (std::size_t k = 0; k < labels.size(); ++k) {
        const double at = x(x.ticks()[k]);
        body += fmt::format("<path class=\"grid\" d=\"M{:.1f} {:.1f}V{:.1f}\" stroke=\"currentColor\"/>\n", at,
                            first - 4.0, floor);
        body += text_at(at, floor + 15.0, "middle", labels[k]);
    }
    y = first;
    for (const Bar& bar : chart.bars) {
        body += bar_at(bar, chart, y, x);
        y += bar_pitch;
    }
    body += text_at(0.5 * (bar_left + width - right), floor + 33.0, "middle", chart.x_label);
    return framed(chart.title, floor + below, body);
}

}  // namespace stria::charts
