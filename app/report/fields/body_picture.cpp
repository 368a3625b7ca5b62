#include "app/report/fields/body_picture.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "app/report/face_states.hpp"
#include "app/report/fields/field_cells.hpp"
#include "app/report/fields/outline.hpp"
#include "app/report/fields/plan_view.hpp"
#include "common/index.hpp"

namespace stria::report {

namespace {

using Polygon = std::vector<FieldPoint>;

constexpr std::size_t most_cracks = 40;
constexpr double finest = 0.3;  // pixels: corners nearer to each other are one

/// "M10 20L30 40z"; corners that fall together on paper are drawn once.
std::string path_of(const Polygon& points, const Plan& plan, bool closed) {
    std::string text;
    double x = -INFINITY, y = -INFINITY;
    for (const FieldPoint& point : points) {
        const double next_x = plan.x(point.x), next_y = plan.y(point.y);
        if (std::hypot(next_x - x, next_y - y) < finest && &point != &points.back()) continue;
        x = next_x, y = next_y;
        text += fmt::format("{}{:.1f} {:.1f}", text.empty() ? "M" : "L", x, y);
    }
    return closed ? text + "z" : text;
}

std::string area(const std::vector<Polygon>& polygons, const Plan& plan, const std::string& colour) {
    std::string outlines;
    for (const Polygon& polygon : polygons) outlines += path_of(polygon, plan, true);
    return outlines.empty() ? ""
                            : fmt::format("<path class=\"{}\" d=\"{}\" fill=\"currentColor\" fill-rule=\"evenodd\"/>\n",
                                          colour, outlines);
}

std::string edge_of(const std::vector<Polygon>& polygons, const Plan& plan) {
    std::string outlines;
    for (const Polygon& polygon : polygons) outlines += path_of(polygon, plan, true);
    return fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"0.8\"/>\n", outlines);
}

/// Of a crack that began as a notch: as it was given, up to where its faces begin.
Polygon notch_of(const CrackSection& crack, double until) {
    Polygon way;
    if (crack.notch <= 0.0) return way;
    double s = 0.0;
    for (std::size_t k = 0; k < crack.points.size() && s < until; ++k) {
        way.push_back({crack.points[k].x(), crack.points[k].y()});
        if (k + 1 < crack.points.size()) s += (crack.points[k + 1] - crack.points[k]).norm();
    }
    return way;
}

/// From mouth to tip, or from tip to tip.
std::vector<Polygon> ways_of_cracks(const RunRecord& run) {
    std::vector<Polygon> ways;
    const std::vector<double> written = written_increments(run);
    if (written.empty()) return ways;
    const NumberTable faces =
        read_table(run.folder / "faces.csv", [&](double increment) { return increment == written.back(); });
    for (std::size_t crack = 0; crack < most_cracks; ++crack) {
        std::vector<std::size_t> rows;
        for (std::size_t row = 0; row < faces.rows; ++row)
            if (faces["crack"][row] == static_cast<double>(crack)) rows.push_back(row);
        if (rows.empty()) continue;
        std::ranges::sort(rows, {}, [&](std::size_t row) { return faces["s"][row]; });
        const bool given = run.input && crack < run.input->cracks.size();
        ways.push_back(given ? notch_of(run.input->cracks[crack], faces["s"][rows.front()]) : Polygon());
        for (const std::size_t row : rows) ways.back().push_back({faces["x"][row], faces["y"][row]});
    }
    return ways;
}

std::string lines_of(const std::vector<Polygon>& ways, const Plan& plan) {
    std::string text;
    for (const Polygon& way : ways)
        text +=
            fmt::format("<path class=\"{}\" d=\"{}\" fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.6\"/>\n",
                        charts::colour_class(1), path_of(way, plan, false));
    return text;
}

std::string legend(bool zone, bool cracks, double y) {
    double x = charts::left;
    std::string text;
    const auto entry = [&](const char* colour, const char* name) {
        text += fmt::format("<rect x=\"{:.0f}\" y=\"{:.0f}\" width=\"14\" height=\"11\" class=\"{}\" "
                            "fill=\"currentColor\"/>\n",
                            x, y - 9.0, colour);
        text += charts::text_at(x + 18.0, y, "start", name);
        x += 78.0;
    };
    entry("l0", "body");
    if (zone) entry("l2", "zone");
    if (cracks) entry(charts::colour_class(1).c_str(), "crack");
    return text;
}

std::vector<std::size_t> cells_where(const FieldCells& field, auto chosen) {
    std::vector<std::size_t> cells;
    for (std::size_t cell = 0; cell < field.cells.size(); ++cell)
        if (chosen(cell)) cells.push_back(cell);
    return cells;
}

std::string picture(const FieldCells& field, const std::vector<Polygon>& ways) {
    const auto body = outline_of(field, cells_where(field, [](std::size_t) { return true; })),
               zone = outline_of(field, cells_where(field, [&](std::size_t cell) { return field.zone[cell] > 0.0; }));
    Window window;
    for (const Polygon& polygon : body)
        for (const FieldPoint& point : polygon) window.enclose(point);
    if (window.x.low > window.x.high) return "";  // no cells
    window.square();
    const Plan plan = plan_of(window);
    std::string drawing = area(body, plan, "l0") + area(zone, plan, "l2") + edge_of(body, plan) + lines_of(ways, plan);
    drawing += axis_below(plan) + legend(!zone.empty(), !ways.empty(), plan.bottom() + 52.0);
    return charts::framed(fmt::format("Cycle {}", field.cycle), plan.bottom() + 62.0, drawing);
}

}  // namespace

charts::Figure body_picture(const RunRecord& run) {
    charts::Figure figure{.title = "Body and crack", .sentence = "The body as it was made, and what it holds now."};
    const std::vector<std::filesystem::path> files = last_fields(run.folder / "fields", 1);
    if (files.empty()) return figure;
    try {
        figure.charts = {charts::captioned(picture(read_field_cells(files.back()), ways_of_cracks(run)), "")};
    } catch (const std::runtime_error&) {
        figure.charts.clear();  // a run that goes on may have begun it
    }
    return figure;
}

}  // namespace stria::report
