#include "app/run/coarse_run.hpp"

#include <fmt/format.h>
#include <iterator>
#include <string_view>

#include "app/process/exit_code.hpp"
#include "app/process/interruption.hpp"
#include "app/process/version.hpp"
#include "app/run/run_end.hpp"
#include "coarse/advice/case_warnings.hpp"
#include "coarse/model/crack_room.hpp"
#include "coarse/model/reported_length.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "common/io/checksum.hpp"
#include "common/io/whole_file.hpp"
#include "common/memory.hpp"
#include "common/stopwatch.hpp"

namespace stria {
namespace {

constexpr std::string_view warns = "warning: ";

/// For the end of an increment, once the run is asked to end, s: what ends in time is resumed to the last bit. An
/// iteration that is given up has perhaps woken elements at rest, which changes rounding.
constexpr double patience = 0.5;

}  // namespace

coarse::Scene scene_of(const RunOptions& options, const Case& input,
                       const std::function<void(const coarse::Scene&)>& before_solving) {
    try {
        // OpenBLAS tries without end to get its buffer of 128 MB.
        require_memory("linear algebra", 2e8);
        coarse::Scene scene = coarse::refined_scene(input, before_solving);
        coarse::require_tips(scene.enriched, static_cast<int>(input.cracks.size()));
        coarse::require_way_to_grow(scene);
        return scene;
    } catch (const CaseError& error) {
        throw CaseError(fmt::format("{}: {}", options.case_path, error.what()));
    }
}

CoarseRun::CoarseRun(const RunOptions& options, const Case& input, Manner manner)
    : options_(options), directory_(options.output_directory), lock_(directory_), manner_(manner),
      mesh_file_(input.mesh.file ? checksum_of(*input.mesh.file) : ""), scene_(scene_of(options, input)),
      mesh_s_(seconds()), progress_(input, options.quiet, options.verbose, manner_.terminal),
      mark_(coarse::mark_of(scene_)) {
    if (options.resume) read_last_checkpoint();
    if (!from_) coarse::remove_results(directory_);
    write_whole_text(directory_ / coarse::result_files::resolved_case, resolved_toml(input));
}

double CoarseRun::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void CoarseRun::read_last_checkpoint() {
    const std::filesystem::path newest = checkpoint_path(), previous = coarse::previous_checkpoint(newest);
    if (!coarse::has_checkpoint(directory_)) {
        progress_.note(fmt::format("{}: no checkpoint yet, the run starts from the beginning", directory_.string()));
        return;
    }
    try {
        from_ = coarse::read_checkpoint(newest);
    } catch (const CaseError& damage) {
        if (!std::filesystem::exists(previous)) throw;
        progress_.note(fmt::format("{}; the one before it serves", damage.what()));
        from_ = coarse::read_checkpoint(previous);
        std::filesystem::rename(previous, newest);
    }
    coarse::check_same_case(from_->mark, mark_, from_->analysis.load);
    coarse::forget_former_end(*from_, mark_, scene_.input.output);
    saved_ = from_->analysis.counts.increments;
    progress_.note(fmt::format("resumed from {} after increment {}, load factor {:.6g}", newest.string(), *saved_,
                               from_->analysis.load_factor));
}

int CoarseRun::perform(coarse::EquilibriumFactory& factory, const FineSide* fine) {
    Course course{.fine = fine};
    coarse::FatigueAnalysis analysis(scene_, factory, listener_of(course), from_ ? &from_->analysis : nullptr);
    course.analysis = &analysis;
    note_sizes(analysis.structure());
    warn_of_case(analysis);
    if (analysis.finished()) {
        progress_.note(fmt::format("nothing is left to do: results in {}", directory_.string()));
        return Done;
    }
    begin_tables(course, factory);
    run_analysis(course);
    return end(course);
}

coarse::Listener CoarseRun::listener_of(Course& course) {
    coarse::Listener listener;
    listener.note = [this](const std::string& text) { take_note(text); };
    listener.attempted = [this](const coarse::LoadStep& step, const coarse::NewtonReport& report) {
        progress_.attempted(step, report);
    };
    listener.accepted = [this, &course](const coarse::Increment& increment, const coarse::Structure& structure) {
        take_increment(course, increment, structure);
    };
    listener.growth_ended = [&course](const coarse::Increment& last, const coarse::Structure& structure) {
        course.recorder->record_end(last, structure);
    };
    listener.reached = [this, &course](const coarse::LoadStep& step) { return goes_on_after(step, course); };
    listener.goes_on = [] { return !interrupted(); };
    listener.waits = [] { return seconds_since_interruption() < patience; };
    listener.breaks_off = [this, &course] {
        if (saved_.value_or(0) != course.analysis->effort().counts.increments)
            write_checkpoint(*course.analysis, *course.recorder);
    };
    return listener;
}

void CoarseRun::take_note(const std::string& text) {
    progress_.note(text);
    if (text.starts_with(warns)) warnings_.met.emplace_back(text.substr(warns.size()));
}

void CoarseRun::take_increment(Course& course, const coarse::Increment& increment, const coarse::Structure& structure) {
    note_sizes(structure);
    course.recorder->record(increment, structure, course.analysis->closure());
    progress_.accepted(increment, course.recorder->N());
}

bool CoarseRun::goes_on_after(const coarse::LoadStep& step, const Course& course) {
    if (course.analysis->finished()) return true;  // that one is written with the summary
    const bool stop = interrupted();
    if (stop || is_due(step)) write_checkpoint(*course.analysis, *course.recorder);
    return !stop;
}

void CoarseRun::warn_of_case(const coarse::FatigueAnalysis& analysis) {
    warnings_.of_case = coarse::case_warnings(scene_, analysis.nominal_at_start());
    for (const std::string& warning : warnings_.of_case) progress_.note(std::string(warns) + warning);
    if (from_) warnings_.met = from_->warnings;
}

void CoarseRun::begin_tables(Course& course, coarse::EquilibriumFactory& factory) {
    // What an earlier part of the run says of itself must not be taken for what this one has done.
    std::filesystem::remove(directory_ / coarse::result_files::summary);
    course.recorder = std::make_unique<coarse::RunRecorder>(
        scene_, directory_, [&factory] { return factory.zone_state(); }, from_ ? &from_->recorder : nullptr);
    from_.reset();
}

void CoarseRun::run_analysis(const Course& course) {
    try {
        course.analysis->run();
    } catch (const NumericalFailure& failure) {
        summarise(coarse::RunStatus::Failed, course);
        throw NumericalFailure(fmt::format("{}; {}", failure.what(), last_checkpoint()));
    }
}

int CoarseRun::end(const Course& course) {
    const coarse::FatigueAnalysis& analysis = *course.analysis;
    const double N = course.recorder->N();
    warnings_.at_end = warnings_at_end(analysis, scene_.input, N);
    for (const std::string& warning : warnings_.at_end) progress_.note(std::string(warns) + warning);
    const bool done = analysis.finished();
    summarise(done ? coarse::RunStatus::Done : coarse::RunStatus::Interrupted, course);
    if (!done) {
        progress_.note(fmt::format("{}: {}; --resume {}", time_is_up() ? "its time is up" : "interrupted",
                                   last_checkpoint(), saved_ ? "goes on from there" : "begins anew"));
        return Interrupted;
    }
    // Last of all: who resumes what is cut off before this line comes here again.
    write_checkpoint(analysis, *course.recorder);
    progress_.finished(directory_.string(), seconds(), cycles_passed(analysis, N));
    return Done;
}

void CoarseRun::note_sizes(const coarse::Structure& structure) {
    sizes_ = {structure.unknowns(), std::ssize(structure.gamma())};
}

bool CoarseRun::is_due(const coarse::LoadStep& step) const {
    return coarse::checkpoint_is_due(
        scene_.input.output.checkpoint_every, step,
        {.has_one = saved_.has_value(), .seconds = checkpoint_s_, .of_the_run_s = seconds()});
}

void CoarseRun::write_checkpoint(const coarse::FatigueAnalysis& analysis, const coarse::RunRecorder& recorder) {
    const Stopwatch watch(checkpoint_s_);
    const coarse::Checkpoint now{mark_, analysis.state(), recorder.state(), warnings_.met};
    coarse::write_checkpoint(checkpoint_path(), now);
    saved_ = now.analysis.counts.increments;
}

std::string CoarseRun::last_checkpoint() const {
    if (!saved_) return "no checkpoint has been written yet";
    return fmt::format("the last checkpoint is {}, after increment {}", checkpoint_path().string(), *saved_);
}

void CoarseRun::summarise(coarse::RunStatus status, const Course& course) const {
    coarse::Summary summary = summary_of(*course.analysis, *course.recorder, course.fine);
    summary.status = status;
    summary.version = version_text();
    summary.mode = to_text(manner_.mode);
    summary.ranks = manner_.ranks;
    summary.mesh_file = mesh_file_;
    summary.coarse_unknowns = sizes_.unknowns;
    summary.interface_unknowns = sizes_.on_gamma;
    const double output = course.recorder->output_seconds() + checkpoint_s_;
    summary.timing.mesh = mesh_s_;
    summary.timing.coarse_solve -= output;
    summary.timing.output = output;
    summary.timing.checkpoint = checkpoint_s_;
    summary.timing.total = seconds();
    for (const auto* some : {&warnings_.of_case, &warnings_.met, &warnings_.at_end})
        summary.warnings.insert(summary.warnings.end(), some->begin(), some->end());
    write_whole_text(directory_ / coarse::result_files::summary, text_of(coarse::to_json(summary)));
}

}  // namespace stria
