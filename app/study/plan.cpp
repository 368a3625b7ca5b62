#include "app/study/plan.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"

namespace stria::study {

namespace {

double number_of(const std::string& text, const std::string& complaint) {
    const std::optional<double> number = number_in(text);
    if (!number) throw CaseError(complaint);
    return *number;
}

std::map<std::string, double> read_reference_values(const std::vector<std::string>& given) {
    std::map<std::string, double> values;
    for (const std::string& text : given) {
        for (const Setting& setting : parse_settings(text, "--reference-value")) {
            std::string names;
            for (const auto& group : {results(), endings()})
                for (const Quantity& result : group) names += (names.empty() ? "" : ", ") + std::string(result.name);
            const auto is_it = [&](const Quantity& result) { return result.name == setting.key; };
            if (std::ranges::none_of(results(), is_it) && std::ranges::none_of(endings(), is_it))
                throw CaseError(
                    fmt::format("--reference-value {}: is no result; must be one of {}", setting.key, names));
            const std::string complaint =
                fmt::format("--reference-value {}={}: must be a number", setting.key, setting.value);
            values[setting.key] = number_of(setting.value, complaint);
        }
    }
    return values;
}

std::vector<Axis> read_axes(const StudyOptions& options) {
    std::vector<Axis> axes;
    for (const std::string& text : options.over) axes.push_back(parse_axis(text));
    if (options.modes.size() > 1) axes.push_back(make_axis(mode_key, options.modes, "--mode"));
    if (options.fine_ranks.size() > 1) axes.push_back(make_axis(ranks_key, options.fine_ranks, "--fine"));
    if (axes.empty()) throw CaseError("study: what varies is missing; --over key=v1,v2,... says it");
    check_distinct(axes, options.run.overrides);
    return axes;
}

/// Whatever is wrong with a case is better said before the first run than after the last.
void check_case(const RunOptions& shared, const Settings& settings) {
    const RunOptions options = run_options(shared, settings);
    try {
        static_cast<void>(read_case(options.case_path, options.overrides));
    } catch (const CaseError& error) {
        // A value of the command line has no place in a file: the variant that has it stands for that.
        constexpr std::string_view command_line = "--set: ";
        const std::string_view text = error.what();
        if (!text.starts_with(command_line)) throw;
        throw CaseError(fmt::format("{}: {}", to_text(settings), text.substr(command_line.size())));
    }
}

/// A reference is the variant with some settings replaced: a run of its own, unless that is a variant too.
void add_references(Plan& plan, const Settings& by) {
    const auto folder_of = [](const std::vector<Row>& rows, const Settings& settings) -> std::string {
        const auto same = std::ranges::find(rows, settings, &Row::settings);
        return same != rows.end() ? same->folder : "";
    };
    for (Row& variant : plan.variants) {
        const Settings wanted = replaced(variant.settings, by);
        variant.reference = folder_of(plan.variants, wanted);
        if (variant.reference.empty()) variant.reference = folder_of(plan.references, wanted);
        if (!variant.reference.empty()) continue;
        variant.reference =
            plan.references.empty() ? "reference" : fmt::format("reference-{}", plan.references.size() + 1);
        plan.references.push_back({.settings = wanted, .folder = variant.reference});
    }
}

void read_reference(const StudyOptions& options, Plan& plan) {
    plan.reference_values = read_reference_values(options.reference_values);
    plan.with_errors = !options.reference.empty() || !plan.reference_values.empty();
    if (options.reference.empty()) return;
    if (std::filesystem::is_directory(options.reference)) {
        plan.reference_folder = options.reference;
        plan.reference_run = read_outcome(options.reference);
        if (plan.reference_run.status != RunStatus::Done)
            throw CaseError(fmt::format("--reference {}: holds no run that is done", options.reference));
        for (Row& variant : plan.variants) variant.reference = options.reference;
        return;
    }
    if (options.reference.find('=') == std::string::npos)
        throw CaseError(fmt::format("--reference {}: is no folder; must be one, or key=value,...", options.reference));
    add_references(plan, parse_settings(options.reference, "--reference"));
}

}  // namespace

RunOptions run_options(const RunOptions& shared, const Settings& settings) {
    RunOptions options = shared;
    for (const Setting& setting : settings) {
        if (setting.key == mode_key) {
            options.mode = run_mode(setting.value, mode_key);
        } else if (setting.key == ranks_key) {
            const std::string complaint = fmt::format("fine_ranks={}: must be a whole number > 0", setting.value);
            options.fine_ranks = static_cast<int>(number_of(setting.value, complaint));
            if (options.fine_ranks < 1 || std::to_string(options.fine_ranks) != setting.value)
                throw CaseError(complaint);
        } else {
            options.overrides.push_back(setting.key + '=' + setting.value);
        }
    }
    return options;
}

Plan make_plan(const StudyOptions& options) {
    Plan plan;
    plan.axes = read_axes(options);
    const std::vector<Settings> grid = combinations(plan.axes);
    const int count = static_cast<int>(grid.size());
    for (const Settings& settings : grid) {
        const int number = static_cast<int>(plan.variants.size()) + 1;
        plan.variants.push_back(
            {.number = number, .settings = settings, .folder = folder_name(number, count, settings)});
    }
    read_reference(options, plan);
    for (const auto* rows : {&plan.variants, &plan.references})
        for (const Row& row : *rows) check_case(options.run, row.settings);
    return plan;
}

}  // namespace stria::study
