#include "app/run/run_end.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <ranges>

#include "coarse/analysis/run_texts.hpp"
#include "coarse/load/load_history.hpp"

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

}  // namespace

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

std::vector<std::string> warnings_at_end(const coarse::FatigueAnalysis& analysis, const Case& input, double N) {
    std::vector<std::string> warnings;
    const bool one_load = input.growth && !coarse::varies(input);  // the rate leaps with the load
    if (const double doubt = analysis.life_in_doubt(); one_load && doubt > input.growth->accuracy * N) {
        const double percent = 100.0 * doubt / (N - doubt);
        warnings.push_back(fmt::format("N is too large by about {:.{}f} %: da/dN changes much from one growth to the "
                                       "next; a smaller growth.increment, or \"auto\", tells it",
                                       percent, percent < 10.0 ? 1 : 0));
    }
    if (!std::isfinite(N))
        warnings.emplace_back(
            "no N is known: the crack was arrested within its last growth, and no rate tells how many "
            "cycles that takes; cycles.csv has N up to there, and a smaller growth.increment tells "
            "the place");
    if (const double grown = analysis.uncounted_growth(); grown > 0.0)
        warnings.push_back(
            fmt::format("N does not count the last {:.4g} mm: the cycles that tell their rate are not over", grown));
    if (std::string doubt = coarse::work_out_of_balance(analysis.work()); !doubt.empty())
        warnings.push_back(std::move(doubt));
    return warnings;
}

coarse::Summary summary_of(const coarse::FatigueAnalysis& analysis, const coarse::RunRecorder& recorder,
                           const FineSide* fine) {
    const coupling::StepReport& zone = recorder.last_zone();
    const coarse::CoarseEffort effort = analysis.effort();
    coarse::Summary summary;
    summary.fine_unknowns = zone.unknowns;
    summary.fine_points = zone.points;
    summary.multipliers = zone.multipliers;
    summary.work = zone.work + effort.work;
    summary.counts = effort.counts;
    summary.step_cuts = analysis.cuts();
    if (fine != nullptr) add_ranks(*fine, zone, summary);
    summary.timing = {.setup = effort.setup_s,
                      .coarse_factor = effort.condensing_s,
                      .growth = effort.growth_s,
                      .fine_constitutive = zone.constitutive_s,
                      .fine_contact = zone.contact_s,
                      .fine_factor = zone.factor_s,
                      .exchange = effort.exchange_s,
                      .coarse_solve = effort.run_s - effort.exchange_s};
    summary.N = recorder.N();
    if (analysis.life_is_over()) summary.life = summary.N;
    summary.last = recorder.last_rows();
    summary.K_initial = recorder.last_K_initial();
    summary.closure_distance = analysis.closure().opening_at();
    return summary;
}

}  // namespace stria
