#include "app/study/study.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "app/process/exit_code.hpp"
#include "app/process/version.hpp"
#include "app/process/writable_folder.hpp"
#include "app/results/run_files.hpp"
#include "app/run/run_lock.hpp"
#include "app/study/commands.hpp"
#include "app/study/convergence/convergence_table.hpp"
#include "app/study/page.hpp"
#include "app/study/plan.hpp"
#include "app/study/runner.hpp"
#include "coarse/results/result_files.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "common/io/whole_file.hpp"

namespace stria::study {

namespace {

void name_folder(StudyOptions& options) {
    std::string& folder = options.run.output_directory;
    if (folder.empty()) folder = "runs/" + read_case(options.run.case_path, options.run.overrides).name + "-study";
}

void claim_folder(StudyOptions& options) {
    const std::string& folder = options.run.output_directory;
    if (!options.run.force && !options.resume && holds_study(folder))
        throw CaseError(fmt::format(
            "{} holds a study; --resume keeps what is done, --force overwrites, -o DIR writes elsewhere", folder));
    if (!options.run.force && coarse::has_results(folder))
        throw CaseError(fmt::format("{} holds a run, and the table of a study is no part of it; -o DIR writes "
                                    "elsewhere, --force takes the run's files away",
                                    folder));
    make_writable_folder(folder);
    options.run.force = true;  // the variants' folders are ours now
}

/// Modes and ranks that do not vary hold for all variants.
void fix_single_values(StudyOptions& options) {
    Settings single;
    if (options.modes.size() == 1) single.push_back({mode_key, options.modes.front()});
    if (options.fine_ranks.size() == 1) single.push_back({ranks_key, options.fine_ranks.front()});
    options.run = run_options(options.run, single);
}

/// The outcome that a variant is compared with.
Outcome reference_of(const Plan& plan, const Row& variant) {
    Outcome reference;
    for (const auto* rows : {&plan.references, &plan.variants})
        for (const Row& row : *rows)
            if (row.folder == variant.reference) reference = row.outcome;
    if (!plan.reference_folder.empty()) reference = plan.reference_run;
    for (const auto& [name, value] : plan.reference_values) {
        reference.values[name] = value;
        // A number for the mean opening is compared with the mean, not with a profile.
        if (name == "opening_at_max") reference.at_maximum = {};
        if (name == "opening_at_min") reference.at_minimum = {};
    }
    return reference;
}

Report report_of(const StudyOptions& options, const Plan& plan) {
    const Case input = read_case(options.run.case_path, options.run.overrides);
    std::string reference = options.reference;
    for (const std::string& value : options.reference_values) reference += (reference.empty() ? "" : ", ") + value;
    return {.title = input.title.empty() ? input.name : input.title,
            .case_path = options.run.case_path,
            .version = version_text(),
            .fixed = options.run.overrides,
            .axes = plan.axes,
            .rows = plan.variants,
            .references = plan.references,
            .reference = reference};
}

/// No table where no axis is one of sizes.
void write_convergence(const std::filesystem::path& path, const std::vector<ConvergenceRow>& rows) {
    if (rows.empty()) {
        std::filesystem::remove(path);
        return;
    }
    write_whole(path, [&](const std::filesystem::path& file) {
        CsvWriter table(file, convergence_columns());
        for (const ConvergenceRow& row : rows) table.row(cells(row));
    });
}

/// As far as the study has come.
void write_results(const StudyOptions& options, Plan& plan) {
    const std::filesystem::path folder = options.run.output_directory;
    if (plan.with_errors)
        for (Row& variant : plan.variants) variant.errors = errors(variant.outcome, reference_of(plan, variant));
    write_whole(folder / study_table, [&](const std::filesystem::path& file) {
        CsvWriter table(file, columns(plan.axes, plan.with_errors));
        for (const Row& row : plan.variants) table.row(cells(row, plan.with_errors));
    });
    const Report report = report_of(options, plan);
    write_convergence(folder / convergence_table, convergence_rows(report));
    write_whole_text(folder / study_page, page(report));
}

void say_results(const StudyOptions& options, const Plan& plan) {
    for (const ConvergenceRow& row : convergence_rows(report_of(options, plan))) fmt::print("{}\n", sentence(row));
    fmt::print("table and charts in {}/study.csv and study.html\n", options.run.output_directory);
}

/// What is compared with comes first: errors are known as soon as a variant is done.
std::vector<Row*> rows_of(Plan& plan) {
    std::vector<Row*> rows;
    for (auto* some : {&plan.references, &plan.variants})
        for (Row& row : *some) rows.push_back(&row);
    return rows;
}

/// Rows that an interruption has left are a reason to come again, also where all that have run are done.
int worst_code(const std::vector<Row*>& rows, bool interrupted) {
    const auto code_of = [&](const Row* row) {
        return interrupted && row->outcome.status == RunStatus::NotRun ? Interrupted : row->outcome.exit_code;
    };
    int worst = Done;
    for (const Row* row : rows) worst = std::max(worst, code_of(row));
    return worst;
}

}  // namespace

int run_study(StudyOptions options) {
    fix_single_values(options);
    name_folder(options);
    Plan plan = make_plan(options);
    if (!options.commands.empty()) {
        fmt::print("{}", options.commands == "slurm" ? job_array(options, plan) : command_lines(options, plan));
        return Done;
    }
    claim_folder(options);
    const RunLock lock(options.run.output_directory);
    if (coarse::has_results(options.run.output_directory)) coarse::remove_results(options.run.output_directory);
    const std::vector<Row*> rows = rows_of(plan);
    Runner runner(options.run, options.resume, options.jobs);
    runner.run(rows, [&] { write_results(options, plan); });
    write_results(options, plan);
    if (!options.run.quiet) say_results(options, plan);
    return worst_code(rows, runner.interrupted());
}

}  // namespace stria::study
