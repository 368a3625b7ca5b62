#include "app/report/fields/field_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

#include "app/report/fields/field_cells.hpp"
#include "app/report/fields/plan_view.hpp"
#include "coarse/fields/field_writer.hpp"
#include "common/index.hpp"

namespace stria::report {

namespace {

// Of the largest strain in the picture, and then rounded: what is below the first has hardly flowed.
constexpr std::array shares = {0.003, 0.03, 0.1, 0.3};
using Levels = std::array<double, shares.size()>;
constexpr double flowed = 1e-7;      // strain: less is rounding
constexpr double room = 0.15;        // about what has flowed, of its extent
constexpr double open_share = 0.04;  // of the picture's width: the largest displacement in it
constexpr std::size_t most_cells = 6000;

Window window_of(const FieldCells& field) {
    Window window;
    for (std::size_t cell = 0; cell < field.cells.size(); ++cell)
        if (field.strain[cell] > flowed)
            for (const int point : field.cells[cell]) window.enclose(field.points[at(point)]);
    window.square();
    window.widen(room * std::max(window.x.high - window.x.low, window.y.high - window.y.low));
    return window;
}

std::vector<std::size_t> cells_in(const FieldCells& field, const Window& window) {
    std::vector<std::size_t> shown;
    for (std::size_t cell = 0; cell < field.cells.size(); ++cell)
        if (std::ranges::any_of(field.cells[cell], [&](int point) { return window.holds(field.points[at(point)]); }))
            shown.push_back(cell);
    if (shown.size() > most_cells) std::erase_if(shown, [&](std::size_t cell) { return field.strain[cell] <= flowed; });
    return shown;
}

/// 1, 2 or 5 times a power of ten, no more than the value.
double rounded_down(double value) { return charts::log_ticks({value, value}).front(); }

/// Displacement of a picture: less its mean, so large that the crack is seen open.
struct Warp {
    FieldPoint mean{0.0, 0.0};
    double scale = 0.0;
};

Warp warp_of(const FieldCells& field, const std::vector<std::size_t>& shown, double width) {
    Warp warp;
    double count = 0.0, largest = 0.0;
    const auto for_points = [&](auto act) {
        for (const std::size_t cell : shown)
            for (const int point : field.cells[cell]) act(field.displacement[at(point)]);
    };
    for_points([&](FieldPoint u) {
        warp.mean = {warp.mean.x + u.x, warp.mean.y + u.y};
        ++count;
    });
    warp.mean = {warp.mean.x / count, warp.mean.y / count};
    for_points([&](FieldPoint u) { largest = std::fmax(largest, std::hypot(u.x - warp.mean.x, u.y - warp.mean.y)); });
    const double wanted = open_share * width / largest;
    if (std::isfinite(wanted)) warp.scale = rounded_down(wanted);
    return warp;
}

Levels levels_of(const FieldCells& field, const std::vector<std::size_t>& shown) {
    double largest = flowed;
    for (const std::size_t cell : shown) largest = std::max(largest, field.strain[cell]);
    Levels levels;
    std::ranges::transform(shares, levels.begin(), [&](double share) { return rounded_down(share * largest); });
    return levels;
}

/// The class of a strain: 0 has not flowed.
std::size_t class_of(double strain, const Levels& levels) {
    if (strain <= flowed) return 0;
    return 1 + at(std::ranges::count_if(levels, [&](double level) { return strain > level; }));
}

std::string outline(const FieldCells& field, std::size_t cell, const Warp& warp, const Plan& plan) {
    std::string text;
    for (const int point : field.cells[cell]) {
        const FieldPoint place = field.points[at(point)], u = field.displacement[at(point)];
        text +=
            fmt::format("{}{:.1f} {:.1f}", text.empty() ? "M" : "L", plan.x(place.x + warp.scale * (u.x - warp.mean.x)),
                        plan.y(place.y + warp.scale * (u.y - warp.mean.y)));
    }
    return text + "z";
}

std::string legend_of(const Levels& levels, double y) {
    std::string text;
    double x = charts::left;
    for (std::size_t number = 1; number <= levels.size() + 1; ++number) {
        text += fmt::format("<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"14\" height=\"11\" class=\"l{}\" "
                            "fill=\"currentColor\"/>\n",
                            x, y - 9.0, number);
        const std::string name =
            number == 1 ? fmt::format("< {:g}", levels[0]) : fmt::format("> {:g}", levels[number - 2]);
        text += charts::text_at(x + 18.0, y, "start", name);
        x += 78.0;
    }
    return text;
}

/// The cells of each level as one path, in a frame that cuts off what sticks out of the window.
std::string paths(const FieldCells& field, const std::vector<std::size_t>& shown, const Warp& warp,
                  const Levels& levels, const Plan& plan) {
    std::array<std::string, shares.size() + 2> outlines;
    for (const std::size_t cell : shown)
        outlines[class_of(field.strain[cell], levels)] += outline(field, cell, warp, plan);
    const double top = plan.top(), tall = plan.bottom() - top;
    std::string text = fmt::format("<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" "
                                   "viewBox=\"{0:.1f} {1:.1f} {2:.1f} {3:.1f}\">\n",
                                   charts::left, top, picture_width, tall);
    for (std::size_t number = 0; number < outlines.size(); ++number)
        if (!outlines[number].empty())
            text += fmt::format("<path class=\"l{0}\" d=\"{1}\" fill=\"currentColor\" stroke=\"currentColor\" "
                                "stroke-width=\"0.3\"/>\n",
                                number, outlines[number]);
    return text + "</svg>\n";
}

std::string picture(const FieldCells& field) {
    Window window = window_of(field);
    if (window.x.low > window.x.high) return "";
    const Plan plan = plan_of(window);
    const std::vector<std::size_t> shown = cells_in(field, window);
    const Warp warp = warp_of(field, shown, window.x.high - window.x.low);
    const Levels levels = levels_of(field, shown);
    std::string body = paths(field, shown, warp, levels, plan);
    body += axis_below(plan) + legend_of(levels, plan.bottom() + 52.0);
    const std::string title =
        fmt::format("Cycle {}, load factor {:.4g}, displacement x {:g}", field.cycle, field.load_factor, warp.scale);
    return charts::framed(title, plan.bottom() + 62.0, body);
}

}  // namespace

charts::Figure field_picture(const RunRecord& run) {
    charts::Figure figure{.title = "Plastic zone and wake",
                          .sentence = "Accumulated plastic strain, means of the elements."};
    // The last two: of a cycle that is its smallest and its largest load.
    for (const std::filesystem::path& file : last_fields(run.folder / coarse::fields_folder, 2)) {
        try {
            figure.charts.push_back(charts::captioned(picture(read_field_cells(file)), ""));
        } catch (const std::runtime_error&) {
            continue;  // a run that goes on may have begun it
        }
    }
    return figure;
}

}  // namespace stria::report
