#include "app/run/coarse_run.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <ranges>
#include <string_view>

#include "app/process/exit_code.hpp"
#include "app/process/interruption.hpp"
#include "app/process/version.hpp"
#include "coarse/advice/case_warnings.hpp"
#include "coarse/analysis/run_texts.hpp"
#include "coarse/load/load_history.hpp"
#include "coarse/model/crack_room.hpp"
#include "coarse/results/summary.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "common/io/checksum.hpp"
#include "common/io/whole_file.hpp"
#include "common/memory.hpp"
#include "common/stopwatch.hpp"

namespace stria {
namespace {

void add_ranks(const FineSide& fine, const coupling::StepReport& zone, coarse::Summary& summary) {
    summary.work += fine.traffic();
    for (const coupling::StepReport& rank : fine.reports(zone)) {
        summary.points_of_ranks.push_back(rank.points);
        summary.multipliers_of_ranks.push_back(rank.multipliers);
    }
    summary.work.ranks_idle = std::ranges::count(summary.points_of_ranks, 0);
    summary.work.history_moves = fine.history_moves();
}

constexpr std::string_view warns = "warning: ";

/// For the end of an increment, once the run is asked to end, s: what ends in time is resumed to the last bit. An
/// iteration that is given up has perhaps woken elements at rest, which changes rounding.
constexpr double patience = 0.5;

/// "life N = 264000 cycles, a = 13 mm", as in the last rows of cycles.csv, of each crack; empty before the first cycle
/// has ended, and where no crack grows. What has grown in the last cycle belongs to the cycles that follow.
std::string cycles_passed(const coarse::FatigueAnalysis& analysis, double N) {
    const coarse::Scene& scene = analysis.structure().scene();
    if (!scene.input.growth || N == 0.0 || analysis.last_cycle().empty()) return "";
    std::map<int, double> a;  // of the cracks
    for (std::size_t t = 0; t < analysis.last_cycle().size(); ++t)
        a[scene.enriched.tips[t].crack] = analysis.last_cycle()[t].a;
    const std::string lengths = fmt::format("a = {:.6g} mm", fmt::join(std::views::values(a), ", "));
    if (!std::isfinite(N)) return "no N is known, " + lengths;  // arrested
    return fmt::format("{}N = {:.6g} cycles, {}", analysis.life_is_over() ? "life " : "", N, lengths);
}

}  // namespace

coarse::Scene scene_of(const RunOptions& options, const Case& input,
                       const std::function<void(const coarse::Scene&)>& before_solving) {
    try {
        // OpenBLAS tries without end to get its buffer of 128 MB.
        require_memory("linear algebra", 2e8);
        coarse::Scene scene = coarse::refined_scene(input, before_solving);
        coarse::require_tips(scene.enriched, static_cast<int>(input.cracks.size()));
        return scene;
    } catch (const CaseError& error) {
        throw CaseError(fmt::format("{}: {}", options.case_path, error.what()));
    }
}

CoarseRun::CoarseRun(const RunOptions& options, const Case& input, Manner manner)
    : options_(options), directory_(options.output_directory), lock_(directory_), manner_(std::move(manner)),
      mesh_file_(input.mesh.file ? checksum_of(*input.mesh.file) : ""), scene_(scene_of(options, input)),
      mesh_s_(seconds()), progress_(input, options.quiet, options.verbose, manner_.terminal),
      mark_(coarse::mark_of(scene_)) {
    if (options.resume) read_last_checkpoint();
    if (!from_)
        for (const std::filesystem::path& old :
             {checkpoint_path(), coarse::previous_checkpoint(checkpoint_path()), directory_ / "closure.csv",
              directory_ / "loads.csv", directory_ / "load-cases.csv"})
            std::filesystem::remove(old);
    write_whole_text(directory_ / "case.resolved.toml", resolved_toml(input));
}

double CoarseRun::seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void CoarseRun::read_last_checkpoint() {
    const std::filesystem::path newest = checkpoint_path(), previous = coarse::previous_checkpoint(newest);
    if (!std::filesystem::exists(newest) && !std::filesystem::exists(previous)) {
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
    std::unique_ptr<coarse::RunRecorder> recorder;
    coarse::FatigueAnalysis* running = nullptr;
    coarse::Listener listener;
    listener.note = [&](const std::string& text) {
        progress_.note(text);
        if (text.starts_with(warns)) warnings_.met.emplace_back(text.substr(warns.size()));
    };
    listener.attempted = [&](const coarse::LoadStep& step, const coarse::NewtonReport& report) {
        progress_.attempted(step, report);
    };
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure& structure) {
        note_sizes(structure);
        recorder->record(increment, structure, running->closure());
        progress_.accepted(increment, recorder->N());
    };
    listener.growth_ended = [&](const coarse::Increment& last, const coarse::Structure& structure) {
        recorder->record_end(last, structure);
    };
    listener.reached = [&](const coarse::LoadStep& step) {
        if (running->finished()) return true;  // that one is written with the summary
        const bool stop = interrupted();
        if (stop || is_due(step)) write_checkpoint(*running, *recorder);
        return !stop;
    };
    listener.goes_on = [] { return !interrupted(); };
    listener.waits = [] { return seconds_since_interruption() < patience; };
    listener.breaks_off = [&] {
        if (saved_.value_or(0) != running->effort().counts.increments) write_checkpoint(*running, *recorder);
    };
    coarse::FatigueAnalysis analysis(scene_, factory, listener, from_ ? &from_->analysis : nullptr);
    running = &analysis;
    note_sizes(analysis.structure());
    warnings_.of_case = coarse::case_warnings(scene_, analysis.nominal_at_start());
    for (const std::string& warning : warnings_.of_case) progress_.note(std::string(warns) + warning);
    if (from_) warnings_.met = from_->warnings;
    if (analysis.finished()) {
        progress_.note(fmt::format("nothing is left to do: results in {}", directory_.string()));
        return Done;
    }
    // What an earlier run says of itself must not be taken for what this one has done.
    std::filesystem::remove(directory_ / "summary.json");
    recorder = std::make_unique<coarse::RunRecorder>(
        scene_, directory_, [&] { return factory.zone_state(); }, from_ ? &from_->recorder : nullptr);
    from_.reset();
    try {
        analysis.run();
    } catch (const NumericalFailure& failure) {
        summarise("failed", analysis, *recorder, fine);
        throw NumericalFailure(fmt::format("{}; {}", failure.what(), last_checkpoint()));
    }
    warn_at_end(analysis, recorder->N());
    const bool done = analysis.finished();
    summarise(done ? "done" : "interrupted", analysis, *recorder, fine);
    // Last of all: who resumes what is cut off before this line comes here again.
    if (done) write_checkpoint(analysis, *recorder);
    if (done)
        progress_.finished(directory_.string(), seconds(), cycles_passed(analysis, recorder->N()));
    else
        progress_.note(fmt::format("{}: {}; --resume {}", time_is_up() ? "its time is up" : "interrupted",
                                   last_checkpoint(), saved_ ? "goes on from there" : "begins anew"));
    return done ? Done : Interrupted;
}

void CoarseRun::warn_at_end(const coarse::FatigueAnalysis& analysis, double N) {
    const bool one_load = scene_.input.growth && !coarse::varies(scene_.input);  // the rate leaps with the load
    if (const double doubt = analysis.life_in_doubt(); one_load && doubt > scene_.input.growth->accuracy * N)
        warnings_.at_end.push_back(
            fmt::format("N is too large by about {:.2g} %: da/dN changes much from one growth to the "
                        "next; a smaller growth.increment, or \"auto\", tells it",
                        100.0 * doubt / N));
    if (const double grown = analysis.uncounted_growth(); grown > 0.0)
        warnings_.at_end.push_back(
            fmt::format("N does not count the last {:.4g} mm: the cycles that tell their rate are not over", grown));
    if (std::string doubt = coarse::work_out_of_balance(analysis.work()); !doubt.empty())
        warnings_.at_end.push_back(std::move(doubt));
    for (const std::string& warning : warnings_.at_end) progress_.note(std::string(warns) + warning);
}

void CoarseRun::note_sizes(const coarse::Structure& structure) {
    sizes_ = {structure.unknowns(), std::ssize(structure.gamma())};
}

bool CoarseRun::is_due(const coarse::LoadStep& step) const {
    const int every = scene_.input.output.checkpoint_every;
    const bool first = !saved_ && step.reversal;  // what fails in the first cycle is not lost
    return every > 0 && (first || (step.ends_cycle && step.cycle % every == 0));
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

void CoarseRun::summarise(const char* status, const coarse::FatigueAnalysis& analysis,
                          const coarse::RunRecorder& recorder, const FineSide* fine) const {
    const coupling::StepReport& zone = recorder.last_zone();
    coarse::Summary summary;
    summary.status = status;
    summary.version = version_text();
    summary.mode = manner_.mode;
    summary.ranks = manner_.ranks;
    summary.mesh_file = mesh_file_;
    summary.coarse_unknowns = sizes_.unknowns;
    summary.interface_unknowns = sizes_.on_gamma;
    summary.fine_unknowns = zone.unknowns;
    summary.fine_points = zone.points;
    summary.multipliers = zone.multipliers;
    const coarse::CoarseEffort effort = analysis.effort();
    summary.work = zone.work + effort.work;
    summary.counts = effort.counts;
    summary.step_cuts = analysis.cuts();
    if (fine != nullptr) add_ranks(*fine, zone, summary);
    const double output = recorder.output_seconds() + checkpoint_s_;
    summary.timing = {.mesh = mesh_s_,
                      .setup = effort.setup_s,
                      .coarse_factor = effort.condensing_s,
                      .growth = effort.growth_s,
                      .fine_constitutive = zone.constitutive_s,
                      .fine_contact = zone.contact_s,
                      .fine_factor = zone.factor_s,
                      .exchange = effort.exchange_s,
                      .coarse_solve = effort.run_s - effort.exchange_s - output,
                      .output = output,
                      .checkpoint = checkpoint_s_,
                      .total = seconds()};
    summary.N = recorder.N();
    if (analysis.life_is_over()) summary.life = summary.N;
    summary.last = recorder.last_rows();
    for (const auto* some : {&warnings_.of_case, &warnings_.met, &warnings_.at_end})
        summary.warnings.insert(summary.warnings.end(), some->begin(), some->end());
    write_json(directory_ / "summary.json", coarse::to_json(summary));
}

}  // namespace stria
