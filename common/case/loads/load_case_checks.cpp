#include "common/case/loads/load_case_checks.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <utility>

namespace stria {

using schema::find;
using schema::List;
using schema::Place;
using schema::reject;
using schema::Value;

bool is_of_main_load(const BoundarySection& boundary) { return !boundary.load_case && !boundary.travelling; }

void check_load_case(const LoadCaseSection& load_case, const Value& table, const Place& place) {
    const auto demand = [&](bool met, const char* key, const char* what) {
        if (!met) reject(place.inside(key), *find(table, key), {}, what);
    };
    const auto is_plain = [](char letter) {
        return std::isalnum(static_cast<unsigned char>(letter)) || letter == '_' || letter == '-';
    };
    const std::string& name = load_case.name;
    if (name.empty() || !std::ranges::all_of(name, is_plain))
        reject(place.inside("name"), *find(table, "name"), {},
               "must be of letters, digits, _ and -: it names a column");
    const int histories =
        (load_case.constant ? 1 : 0) + (load_case.factor ? 1 : 0) + (load_case.blocks.empty() ? 0 : 1);
    if (histories > 1) reject(place, table.line, "has more than one of constant, factor and blocks");
    for (const auto& [key, number] : {std::pair("constant", load_case.constant), {"factor", load_case.factor}})
        if (number) demand(std::abs(*number) < 1e100, key, "must be smaller than 1e100 in size");
    const bool lags = load_case.factor.has_value();
    if (!lags && load_case.phase != 0.0) demand(false, "phase", "needs factor: it lags behind [load]");
    if (!lags && load_case.path != LagPath::Sine) demand(false, "path", "needs factor and phase");
}

void check_pressure(const BoundarySection& boundary, const Value& table, const Place& place) {
    const auto complain = [&](const char* key, const char* demand) {
        if (const Value* given = find(table, key)) reject(place.inside(key), given->line, demand);
    };
    const bool edge = boundary.on != "point" && !boundary.on.starts_with("pin-");
    if (!boundary.pressure) complain("cosine", "needs a pressure that it distributes");
    if (boundary.cosine && !(boundary.cosine->norm() > 0.0)) complain("cosine", "must not be zero: it is a direction");
    if (!boundary.cosine) complain("centre", "needs cosine");
    if (!boundary.travelling) return;
    if (!edge) complain("travelling", "needs an edge, not a point or pin");
    constexpr auto alone = "does not go with travelling: give it a [[boundary]] of its own";
    for (const char* key : {"displacement", "traction", "pressure", "force", "case"}) complain(key, alone);
    if (!boundary.traction_gradient.isZero(0.0)) complain("traction_gradient", alone);
    if (boundary.travelling->from == boundary.travelling->to)
        reject(place.inside("travelling.to"), find(table, "travelling")->line, "must differ from from");
}

namespace {

/// The table of an entry of a list of tables.
const Value& entry_of(const Value& root, const char* list, std::size_t k) {
    return std::get<List>(find(root, list)->data)[k];
}

Place place_of(const Place& place, const char* list, std::size_t k) {
    return place.inside(list).inside(std::to_string(k));
}

void check_names(const Case& whole, const Value& root, const Place& place) {
    for (std::size_t k = 0; k < whole.load_cases.size(); ++k) {
        const std::string& name = whole.load_cases[k].name;
        const Value& table = entry_of(root, "load_case", k);
        const auto first = std::ranges::find(whole.load_cases, name, &LoadCaseSection::name);
        if (first != whole.load_cases.begin() + static_cast<std::ptrdiff_t>(k))
            reject(place_of(place, "load_case", k).inside("name"), *find(table, "name"), {},
                   "is the name of another load case");
        const auto uses = [&](const BoundarySection& boundary) { return boundary.load_case == name; };
        if (std::ranges::none_of(whole.boundaries, uses))
            reject(place_of(place, "load_case", k), table.line,
                   fmt::format("loads nothing: no [[boundary]] has case = \"{}\"", name));
    }
}

}  // namespace

void check_load_cases(const Case& whole, const Value& root, const Place& place) {
    std::vector<std::string> names;
    for (const LoadCaseSection& load_case : whole.load_cases) names.push_back('"' + load_case.name + '"');
    for (std::size_t k = 0; k < whole.boundaries.size(); ++k) {
        const std::optional<std::string>& name = whole.boundaries[k].load_case;
        if (!name || std::ranges::find(whole.load_cases, *name, &LoadCaseSection::name) != whole.load_cases.end())
            continue;
        reject(place_of(place, "boundary", k).inside("case"), *find(entry_of(root, "boundary", k), "case"), {},
               names.empty() ? "is no load case: there is no [[load_case]]"
                             : fmt::format("is no load case; there are {}", fmt::join(names, ", ")));
    }
    check_names(whole, root, place);
    for (std::size_t k = 0; k < whole.load_cases.size(); ++k) {
        const LoadCaseSection& load_case = whole.load_cases[k];
        if (load_case.constant || load_case.factor || !load_case.blocks.empty() || whole.load.spectrum) continue;
        reject(place_of(place, "load_case", k), entry_of(root, "load_case", k).line,
               "needs constant, factor or blocks, or a column of load.spectrum with its name");
    }
}

namespace {

/// A way of [load] that goes nowhere: on it a load case could not change. Nothing if there is none.
std::optional<std::string> standstill(const LoadSection& load) {
    double at = 0.0;
    int cycle = 0;
    const auto stays = [&](double to) { return std::exchange(at, to) == to; };
    for (const LoadBlock& block : load.blocks) {
        if (stays(block.max)) return fmt::format("its way to the maximum of cycle {}", cycle + 1);
        cycle += block.cycles;
        if (block.cycles > 0 && stays(block.min)) return fmt::format("its way to the minimum of cycle {}", cycle);
    }
    return std::nullopt;
}

}  // namespace

void check_cycles_of_cases(const Case& whole, const Value& root, const Place& place) {
    const auto count = [](const auto& blocks) {
        double cycles = 0.0;
        for (const auto& block : blocks) cycles += block.cycles;
        return cycles;
    };
    for (std::size_t k = 0; k < whole.load_cases.size(); ++k) {
        const LoadCaseSection& load_case = whole.load_cases[k];
        if (load_case.blocks.empty()) continue;
        if (const std::optional<std::string> way = standstill(whole.load))
            reject(place_of(place, "load_case", k).inside("blocks"), entry_of(root, "load_case", k).line,
                   "change while [load] does, and it stands still on " + *way + ": give it a small range there");
        if (count(load_case.blocks) == count(whole.load.blocks)) continue;
        reject(place_of(place, "load_case", k).inside("blocks"), entry_of(root, "load_case", k).line,
               fmt::format("have {:.0f} cycles, [load] has {:.0f}: there must be as many", count(load_case.blocks),
                           count(whole.load.blocks)));
    }
}

}  // namespace stria
