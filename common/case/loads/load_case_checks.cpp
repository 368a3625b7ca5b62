#include "common/case/loads/load_case_checks.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <utility>

#include "common/schema/given.hpp"

namespace stria {

using schema::entry_of;
using schema::Given;
using schema::Place;
using schema::place_of;
using schema::reject;
using schema::Value;

bool is_of_main_load(const BoundarySection& boundary) { return !boundary.load_case && !boundary.travelling; }

void check_load_case(const LoadCaseSection& load_case, const Value& table, const Place& place) {
    const Given given{table, place};
    const auto is_plain = [](char letter) {
        return std::isalnum(static_cast<unsigned char>(letter)) || letter == '_' || letter == '-';
    };
    const std::string& name = load_case.name;
    given.demand(!name.empty() && std::ranges::all_of(name, is_plain), "name",
                 "must be of letters, digits, _ and -: it names a column");
    const int histories =
        (load_case.constant ? 1 : 0) + (load_case.factor ? 1 : 0) + (load_case.blocks.empty() ? 0 : 1);
    if (histories > 1) given.refuse("has more than one of constant, factor and blocks");
    for (const auto& [key, number] : {std::pair("constant", load_case.constant), {"factor", load_case.factor}})
        given.demand(!number || std::abs(*number) < 1e100, key, "must be smaller than 1e100 in size");
    const bool lags = load_case.factor.has_value();
    given.demand(lags || load_case.phase == 0.0, "phase", "needs factor: it lags behind [load]");
    given.demand(lags || load_case.path == LagPath::Sine, "path", "needs factor and phase");
}

namespace {

void check_names(const Case& whole, const Given& given) {
    for (std::size_t k = 0; k < whole.load_cases.size(); ++k) {
        const std::string& name = whole.load_cases[k].name;
        const Given of_case = given.entry("load_case", k);
        const auto first = std::ranges::find(whole.load_cases, name, &LoadCaseSection::name);
        of_case.demand(first == whole.load_cases.begin() + static_cast<std::ptrdiff_t>(k), "name",
                       "is the name of another load case");
        const auto uses = [&](const BoundarySection& boundary) { return boundary.load_case == name; };
        if (std::ranges::none_of(whole.boundaries, uses))
            of_case.refuse(fmt::format("loads nothing: no [[boundary]] has case = \"{}\"", name));
    }
}

}  // namespace

void check_load_cases(const Case& whole, const Value& root, const Place& place) {
    const Given given{root, place};
    std::vector<std::string> names;
    for (const LoadCaseSection& load_case : whole.load_cases) names.push_back('"' + load_case.name + '"');
    for (std::size_t k = 0; k < whole.boundaries.size(); ++k) {
        const std::optional<std::string>& name = whole.boundaries[k].load_case;
        if (!name || std::ranges::find(whole.load_cases, *name, &LoadCaseSection::name) != whole.load_cases.end())
            continue;
        given.entry("boundary", k)
            .refuse_value("case", names.empty() ? "is no load case: there is no [[load_case]]"
                                                : fmt::format("is no load case; there are {}", fmt::join(names, ", ")));
    }
    check_names(whole, given);
    for (std::size_t k = 0; k < whole.load_cases.size(); ++k) {
        const LoadCaseSection& load_case = whole.load_cases[k];
        if (load_case.constant || load_case.factor || !load_case.blocks.empty() || whole.load.spectrum) continue;
        given.entry("load_case", k)
            .refuse("needs constant, factor or blocks, or a column of load.spectrum with its name");
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
        // The column of a spectrum file has no blocks in the case: the line is that of the load case.
        const auto refuse = [&, k](const std::string& sentence) {
            reject(place_of(place, "load_case", k).inside("blocks"), entry_of(root, "load_case", k).line, sentence);
        };
        if (const std::optional<std::string> way = standstill(whole.load))
            refuse("change while [load] does, and it stands still on " + *way + ": give it a small range there");
        if (count(load_case.blocks) == count(whole.load.blocks)) continue;
        refuse(fmt::format("have {:.0f} cycles, [load] has {:.0f}: there must be as many", count(load_case.blocks),
                           count(whole.load.blocks)));
    }
}

}  // namespace stria
