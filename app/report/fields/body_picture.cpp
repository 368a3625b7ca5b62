#include "app/report/fields/body_picture.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "app/report/fields/field_cells.hpp"
#include "app/report/fields/outline.hpp"
#include "app/report/fields/plan_view.hpp"
#include "app/report/record/face_states.hpp"
#include "coarse/fields/field_writer.hpp"
#include "coarse/results/result_files.hpp"
#include "common/crack/notch.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"

namespace stria::report {

namespace {

using Polygon = std::vector<FieldPoint>;

constexpr int most_cracks = 40;
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

/// A point of a crack at the arc length s from the crack's present first point, mm.
struct PlaceOnCrack {
    double s;
    FieldPoint point;
};

double distance_of(FieldPoint a, FieldPoint b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Where a tip has been up to an increment, row by row of history.csv.
Polygon places_of_tip(const RunRecord& run, std::size_t tip, double increment) {
    Polygon places;
    for (const std::size_t row : rows_of_tip(run.history, tip))
        if (run.history["increment"][row] <= increment)
            places.push_back({run.history["x"][row], run.history["y"][row]});
    return places;
}

/// Arc by which growth has moved the first point of a crack on, mm: the way of the tip that it was. A mouth stays.
double grown_at_start(const RunRecord& run, const CrackSection& crack, double increment) {
    constexpr double by_mesh = 1e-3;  // of the crack: a mesh moves a tip onto a node that is as near
    if (!run.history.columns.contains("x") || !run.history.columns.contains("y")) return 0.0;
    const FieldPoint first{crack.points.front().x(), crack.points.front().y()};
    for (std::size_t tip = 0; tip < run.tips(); ++tip) {
        const Polygon places = places_of_tip(run, tip, increment);
        if (places.empty() || !(distance_of(places.front(), first) <= by_mesh * length_of(crack.points))) continue;
        double way = 0.0;
        for (std::size_t k = 1; k < places.size(); ++k) way += distance_of(places[k - 1], places[k]);
        return way;
    }
    return 0.0;
}

/// What was machined, as it was given: no face need have a station at its mouth and bends.
std::vector<PlaceOnCrack> corners_of_notch(const RunRecord& run, const CrackSection& crack, double increment) {
    std::vector<PlaceOnCrack> corners;
    if (crack.notch <= 0.0) return corners;
    const Notch notch = notch_of(crack, grown_at_start(run, crack, increment));
    double s = notch.from;
    for (std::size_t k = 0; k < crack.points.size() && notch.holds(s); ++k) {
        corners.push_back({s, {crack.points[k].x(), crack.points[k].y()}});
        if (k + 1 < crack.points.size()) s += (crack.points[k + 1] - crack.points[k]).norm();
    }
    return corners;
}

/// From mouth to tip, or from tip to tip; empty without faces.
Polygon way_of(const RunRecord& run, const NumberTable& faces, int crack, double increment) {
    const std::vector<std::size_t> rows = rows_of_crack(faces, crack, increment);
    if (rows.empty()) return {};
    std::vector<PlaceOnCrack> places;
    if (run.input && crack < std::ssize(run.input->cracks))
        places = corners_of_notch(run, run.input->cracks[at(crack)], increment);
    for (const std::size_t row : rows) places.push_back({faces["s"][row], {faces["x"][row], faces["y"][row]}});
    std::ranges::stable_sort(places, {}, &PlaceOnCrack::s);
    Polygon way(places.size());
    std::ranges::transform(places, way.begin(), &PlaceOnCrack::point);
    return way;
}

std::vector<Polygon> ways_of_cracks(const RunRecord& run) {
    std::vector<Polygon> ways;
    const std::vector<double> written = written_increments(run);
    if (written.empty()) return ways;
    const double last = written.back();
    const NumberTable faces =
        read_table(run.folder / coarse::result_files::faces, [&](double increment) { return increment == last; });
    for (int crack = 0; crack < most_cracks; ++crack)
        if (Polygon way = way_of(run, faces, crack, last); !way.empty()) ways.push_back(std::move(way));
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
    const std::vector<std::filesystem::path> files = last_fields(run.folder / coarse::fields_folder, 1);
    if (files.empty()) return figure;
    try {
        figure.charts = {charts::captioned(picture(read_field_cells(files.back()), ways_of_cracks(run)), "")};
    } catch (const std::runtime_error&) {
        figure.charts.clear();  // a run that goes on may have begun it
    }
    return figure;
}

}  // namespace stria::report
