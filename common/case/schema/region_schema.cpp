#include "common/case/schema/region_schema.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <map>
#include <set>

#include "common/case/schema/body_schema.hpp"
#include "common/error.hpp"
#include "common/geometry/clipping.hpp"
#include "common/index.hpp"
#include "common/io/number_table.hpp"
#include "common/schema/given.hpp"

namespace stria {

using schema::Given;
using schema::Place;
using schema::Section;
using schema::Value;

namespace {

bool ascends(const std::vector<double>& values) {
    return values.size() > 1 && std::ranges::adjacent_find(values, std::greater_equal()) == values.end();
}

/// Whether two edges of a closed polygon meet elsewhere than in a corner that they share.
bool crosses_itself(const std::vector<Vec2>& polygon) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = i + 1; j < n; ++j) {
            const auto met = intersect(polygon[i], polygon[(i + 1) % n], polygon[j], polygon[(j + 1) % n]);
            const bool neighbours = j == i + 1 || (i == 0 && j == n - 1);
            if (met && !(neighbours && met->first == met->second)) return true;
        }
    }
    return false;
}

void check_outline(const RegionSection& region, const Value& table, const Place& place) {
    const Given given{table, place};
    if (given.has("outline") == region.group.has_value()) given.refuse("needs outline or group, one of them");
    if (!given.has("outline")) return;
    const std::vector<Vec2>& outline = region.outline;
    given.demand(outline.size() >= 2, "outline", "must be a polygon, or two opposite corners of a rectangle");
    given.demand(outline.size() > 2 || ((outline[0] - outline[1]).array() != 0.0).all(), "outline",
                 "must be two opposite corners: the rectangle has no area");
    given.demand(outline.size() == 2 || !crosses_itself(outline), "outline", "must not cross or touch itself");
}

void check_profile(const StressProfile& profile, const Value& table, const Place& place) {
    const Given given{table, place};
    given.demand(ascends(profile.at), "at", "must be two or more, ascending");
    given.demand(profile.stress.size() == profile.at.size(), "stress", "must have one number per place of at");
}

void check_grid(const StressGrid& grid, const Value& table, const Place& place) {
    const Given given{table, place};
    for (const auto& [name, axis] : {std::pair{"x", &grid.x}, std::pair{"y", &grid.y}})
        given.demand(ascends(*axis), name, "must be two or more, ascending");
    for (const auto& [name, values] : {std::pair{"xx", &grid.xx}, std::pair{"yy", &grid.yy}, std::pair{"xy", &grid.xy}})
        given.demand(values->size() == grid.x.size() * grid.y.size(), name, "must have one number per node, x fastest");
}

void check_initial_stress(const InitialStressSection& stress, const Value& table, const Place& place) {
    const Given given{table, place};
    if (!stress.sigma_x && !stress.sigma_y && !stress.file && !stress.grid)
        given.refuse("needs sigma_x, sigma_y, file or grid");
    if (stress.file && stress.grid) given.refuse("has both file and grid; one of them says it");
}

Section<StressProfile> profile_section() {
    Section<StressProfile> s;
    s.value("at", &StressProfile::at).in("mm").must_be_given().says("Places along the axis, ascending.");
    s.value("stress", &StressProfile::stress)
        .in("MPa")
        .must_be_given()
        .says("The stress there; straight lines between.");
    s.check(check_profile);
    return s;
}

Section<StressGrid> grid_section() {
    Section<StressGrid> s;
    s.value("x", &StressGrid::x).in("mm").must_be_given().says("Columns of nodes, ascending.");
    s.value("y", &StressGrid::y).in("mm").must_be_given().says("Rows of nodes, ascending.");
    for (const auto& [name, member] :
         {std::pair{"xx", &StressGrid::xx}, std::pair{"yy", &StressGrid::yy}, std::pair{"xy", &StressGrid::xy}})
        s.value(name, member).in("MPa").must_be_given().says("At the nodes, row by row, x fastest.");
    s.check(check_grid);
    return s;
}

Section<MisfitStress> misfit_section() {
    Section<MisfitStress> s;
    s.value("xx", &MisfitStress::xx).in("MPa").says("Normal stress along x.");
    s.value("yy", &MisfitStress::yy).in("MPa").says("Normal stress along y.");
    s.value("xy", &MisfitStress::xy).in("MPa").says("Shear stress.");
    return s;
}

}  // namespace

Section<RegionSection> region_section() {
    Section<RegionSection> s;
    s.value("outline", &RegionSection::outline)
        .in("mm")
        .or_else("absent: it is a group")
        .says("A polygon, or two opposite corners of a rectangle. Node lines follow its axis-parallel edges; elsewhere "
              "an element belongs to the region that holds its centre. It may reach beyond the body.");
    s.value("group", &RegionSection::group)
        .says("Instead of an outline: a group of elements of mesh.file, by its name.");
    s.table("material", &RegionSection::material, material_section())
        .says("Its material, with the keys of [material]; without yield_stress it never yields.");
    s.table("initial_stress", &RegionSection::initial_stress, misfit_section())
        .says("The stress that it would have if nothing around it gave way: a misfit, -E alpha dT / (1 - nu) of a "
              "film that has warmed up by dT. Equilibrium lets go of a part of it. In plane strain zz is nu (xx + yy), "
              "so the flow of a film that is held across the plane too begins late.");
    s.leave_out({"outline"}, [](const RegionSection& region) { return region.group.has_value(); });
    s.check(check_outline);
    return s;
}

Section<InitialStressSection> initial_stress_section() {
    Section<InitialStressSection> s;
    s.table("sigma_x", &InitialStressSection::sigma_x, profile_section())
        .says("Normal stress along x as a function of y; it must cover the body and have no resultant.");
    s.table("sigma_y", &InitialStressSection::sigma_y, profile_section())
        .says("Normal stress along y as a function of x; likewise.");
    s.value("file", &InitialStressSection::file)
        .says("CSV file, relative to the case file, with the columns x, y, sxx, syy, sxy: the nodes of a grid, in any "
              "order. The resolved case holds them as grid.");
    s.table("grid", &InitialStressSection::grid, grid_section())
        .says("Stress at the nodes of a grid that covers the body, bilinear between them.");
    s.check(check_initial_stress);
    return s;
}

StressGrid read_stress_grid(const std::filesystem::path& path) {
    const NumberTable table = read_table(path);
    const auto complain = [&](std::size_t row, const std::string& what) {
        throw CaseError(fmt::format("{}:{}: initial_stress.file: {}", path.string(), table.lines[row], what));
    };
    if (table.columns.empty()) throw CaseError(fmt::format("{}: initial_stress.file: cannot be read", path.string()));
    const auto reject_names = [&](const std::string& what) {
        throw CaseError(fmt::format("{}:{}: initial_stress.file: {}", path.string(), table.names_line, what));
    };
    if (!table.repeated.empty()) reject_names(fmt::format("column {} is given twice", table.repeated));
    for (const char* name : {"x", "y", "sxx", "syy", "sxy"})
        if (!table.columns.contains(name)) reject_names(fmt::format("has no column {}", name));
    if (table.cut_off) complain(table.rows, "has not as many cells as the line of names");
    std::map<std::pair<double, double>, std::array<double, 3>> nodes;  // by y, then x
    std::set<double> columns, rows;
    for (std::size_t k = 0; k < table.rows; ++k) {
        const double x = table["x"][k], y = table["y"][k];
        const std::array stress{table["sxx"][k], table["syy"][k], table["sxy"][k]};
        if (!std::isfinite(x + y + stress[0] + stress[1] + stress[2])) complain(k, "must be numbers");
        if (!nodes.emplace(std::pair(y, x), stress).second) complain(k, "repeats a node");
        columns.insert(x);
        rows.insert(y);
    }
    if (nodes.size() != columns.size() * rows.size() || columns.size() < 2 || rows.size() < 2)
        throw CaseError(fmt::format("{}: initial_stress.file: {} nodes are no grid of {} columns and {} rows",
                                    path.string(), nodes.size(), columns.size(), rows.size()));
    StressGrid grid;
    grid.x.assign(columns.begin(), columns.end());
    grid.y.assign(rows.begin(), rows.end());
    for (const auto& [place, stress] : nodes) {
        grid.xx.push_back(stress[0]);
        grid.yy.push_back(stress[1]);
        grid.xy.push_back(stress[2]);
    }
    return grid;
}

}  // namespace stria
