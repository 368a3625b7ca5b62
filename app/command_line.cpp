#include "app/command_line.hpp"

#include "app/process/children.hpp"
#include "app/process/version.hpp"
#include "common/error.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <fmt/format.h>

namespace stria {

namespace {

constexpr int max_ranks = 1024;

void add_case(CLI::App& app, RunOptions& options) {
    app.add_option("case", options.case_path, "The case file")->required()->type_name("CASE.toml");
    app.add_option("--set", options.overrides, "Use this value instead of the file's, e.g. --set fine.beta=4")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
}

void add_manners(CLI::App& app, RunOptions& options) {
    app.add_flag("--force", options.force, "Write into a folder that holds results");
    app.add_flag("--quiet", options.quiet, "Say nothing but errors");
    app.add_flag("--verbose", options.verbose, "Say more");
    app.add_flag("!--no-report", options.report, "Write no report.html");
}

void add_run_options(CLI::App& app, RunOptions& options) {
    add_case(app, options);
    app.add_option("-o,--output", options.output_directory, "Folder of the results; default runs/<case name>")
        ->type_name("DIR");
    app.add_option_function<std::string>(
           "--mode", [&](const std::string& word) { options.mode = run_mode(word, "--mode"); },
           "Two programs over MPI, two components in this one, or one model; default mpi")
        ->type_name("mpi|inprocess|monolithic");
    app.add_option("--fine", options.fine_ranks, "Number of fine ranks")
        ->type_name("N")
        ->check(CLI::Range(1, max_ranks));
    app.add_flag("--resume", options.resume, "Go on from the checkpoint in the folder of results");
    app.add_option("--max-seconds", options.max_seconds,
                   "End after so many seconds by the clock as if interrupted, with a checkpoint to go on from")
        ->type_name("S");
    add_manners(app, options);
}

void add_study_options(CLI::App& app, study::StudyOptions& options) {
    add_case(app, options.run);
    const auto repeatable = [&](const char* name, std::vector<std::string>& values, const char* sentence) {
        return app.add_option(name, values, sentence)->allow_extra_args(false);
    };
    repeatable("--over", options.over, "Run the case with each of these values; several: every combination")
        ->type_name("KEY=V1,V2,...");
    repeatable("--mode", options.modes, "As in stria run; several vary it")->type_name("MODE,...")->delimiter(',');
    repeatable("--fine", options.fine_ranks, "Number of fine ranks; several vary it")
        ->type_name("N,...")
        ->delimiter(',');
    app.add_option("--reference", options.reference,
                   "What errors are relative to: each variant with these settings instead, or the folder of a run")
        ->type_name("KEY=VALUE,...|DIR");
    repeatable("--reference-value", options.reference_values, "Errors relative to this value, e.g. J=3.28")
        ->type_name("RESULT=VALUE");
    app.add_option("-o,--output", options.run.output_directory, "Folder of the study; default runs/<case name>-study")
        ->type_name("DIR");
    app.add_flag("--resume", options.resume, "Keep the variants that are done, go on with those that are begun");
    app.add_option("--jobs", options.jobs, "Variants at a time, each on its share of the cores; 0: read what there is")
        ->type_name("N")
        ->check(CLI::Range(0, most_children));
    app.add_flag("--print-commands{lines}", options.commands,
                 "Run nothing; print a line for each run, or with =slurm the script of a job array")
        ->check(CLI::IsMember({"lines", "slurm"}));
    add_manners(app, options.run);
}

void add_report_options(CLI::App& app, RunOptions& options) {
    app.add_option("folder", options.output_directory, "The folder of a run, ended or not")
        ->required()
        ->type_name("DIR");
    app.add_flag("--quiet", options.quiet, "Say nothing but errors");
}

void add_material_options(CLI::App& app, RunOptions& options) {
    add_case(app, options);
    app.add_option("-o,--output", options.output_directory,
                   "Folder of loop.csv, cycles.csv and loop.svg; default runs/<case name>-material")
        ->type_name("DIR");
    add_manners(app, options);
}

/// A word that belongs to the script: nothing is ever silently ignored.
void add_test(CLI::App& app) {
    app.add_subcommand("test", "Build and run the tests: a command of the script ./stria alone")
        ->prefix_command()
        ->callback([] { throw CaseError("test is a command of the script ./stria at the top of the source tree"); });
}

/// False where --help or --version answered.
bool parse(CLI::App& app, int argc, const char* const* argv) {
    app.set_version_flag("--version", version_text());
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& answered) {
        app.exit(answered);
        return false;
    } catch (const CLI::ParseError& error) {
        throw CaseError(fmt::format("{}; {} --help says more", error.what(), app.get_name()));
    }
    return true;
}

/// The library would say no more than that a command is missing.
void check_command(CLI::App& app, int argc, const char* const* argv) {
    if (argc < 2 || argv[1][0] == '-') return;
    for (const CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
        if (command->get_name() == argv[1]) return;
    throw CaseError(fmt::format("{} is not a command; stria --help lists them", argv[1]));
}

void check_run(const RunOptions& options) {
    if (options.max_seconds && !(*options.max_seconds > 0.0 && std::isfinite(*options.max_seconds)))
        throw CaseError(fmt::format("--max-seconds {}: must be a number > 0", *options.max_seconds));
    if (options.fine_ranks > 1 && options.mode == RunMode::Monolithic)
        throw CaseError(fmt::format("--fine {}: mode monolithic has no fine ranks", options.fine_ranks));
}

}  // namespace

std::optional<Command> parse_stria(int argc, const char* const* argv) {
    Command command;
    CLI::App app("Fatigue cracks in metals by a two-scale extended finite element method", "stria");
    app.require_subcommand(1);
    CLI::App* run = app.add_subcommand("run", "Run a case");
    add_run_options(*run, command.run);
    CLI::App* check = app.add_subcommand("check", "Read and check everything, solve no more than the elastic body");
    add_case(*check, command.run);
    CLI::App* study = app.add_subcommand("study", "Run a case with every combination of some values, and compare");
    add_study_options(*study, command.study);
    CLI::App* material = app.add_subcommand("material", "Drive one point of the material through cycles of strain or "
                                                        "stress");
    add_material_options(*material, command.run);
    CLI::App* explain = app.add_subcommand("explain", "Explain a key of the case file, or all");
    explain->add_option("key", command.key, "A key such as material.young, or a section");
    explain->add_flag("--markdown", command.markdown, "The whole reference as docs/case-reference.md has it");
    CLI::App* report = app.add_subcommand("report", "Write report.html anew from the files of a run");
    add_report_options(*report, command.run);
    add_test(app);
    check_command(app, argc, argv);
    if (!parse(app, argc, argv)) return std::nullopt;
    command.name = app.get_subcommands().front()->get_name();
    check_run(command.run);
    return command;
}

std::optional<Command> parse_component(const std::string& program, int argc, const char* const* argv) {
    Command command;
    command.name = "run";
    CLI::App app("One of the two components of stria run, for batch systems", program);
    add_run_options(app, command.run);
    if (program == "stria-coarse")
        app.add_flag("--own-rank", command.run.own_rank, "Be one fine rank more, beside those of stria-fine");
    if (!parse(app, argc, argv)) return std::nullopt;
    check_run(command.run);
    return command;
}

}  // namespace stria
