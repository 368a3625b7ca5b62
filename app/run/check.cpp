#include "app/run/check.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <span>
#include <string>
#include <vector>

#include "app/run/coarse_run.hpp"
#include "coarse/advice/case_warnings.hpp"
#include "coarse/advice/work_estimate.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/fracture/K_behind_turns.hpp"
#include "coarse/fracture/halved_elements.hpp"
#include "coarse/fracture/handbook_comparison.hpp"
#include "coarse/fracture/plastic_zone.hpp"
#include "coarse/fracture/turned_tip.hpp"
#include "coarse/growth/growth_increment.hpp"
#include "coarse/growth/growth_texts.hpp"
#include "coarse/load/load_history.hpp"
#include "coarse/mesh_file/mesh_file.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "coarse/zone/zone_size.hpp"
#include "common/case/case_questions.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/memory.hpp"

namespace stria {
namespace {

void print_handbook(const coarse::NominalSolution& nominal) {
    for (const coarse::HandbookLine& line : coarse::compare_with_handbook(nominal)) {
        fmt::print("# {}: handbook {:.6g}", line.quantity + (line.unit.empty() ? "" : ", " + line.unit), line.handbook);
        if (std::isfinite(line.own))
            fmt::print(", this mesh {:.6g} ({:+.2f} %)", line.own, 100.0 * (line.own / line.handbook - 1.0));
        fmt::print("\n");
    }
}

/// K of what has a factor of its own, at a tip.
void print_load_cases(const Case& input, std::size_t t, const coarse::TipResult& tip) {
    if (tip.K_I_of_cases.empty()) return;
    std::size_t k = 0;
    for (const LoadCaseSection& load_case : input.load_cases) {
        fmt::print("# tip {}: K_I = {:.5g}, K_II = {:.5g} MPa sqrt(mm) at the factor 1 of the load case \"{}\"\n", t,
                   tip.K_I_of_cases[k], tip.K_II_of_cases[k], load_case.name);
        ++k;
    }
    const auto positions = static_cast<std::size_t>(coarse::positions_of_travel(input.load));
    for (const BoundarySection& boundary : input.boundaries) {
        if (!boundary.travelling) continue;
        const auto extremes = [&](const std::vector<double>& K) {
            return std::ranges::minmax(std::span(K).subspan(k, positions));
        };
        const auto I = extremes(tip.K_I_of_cases), II = extremes(tip.K_II_of_cases);
        fmt::print("# tip {}: K_I = {:.5g} to {:.5g}, K_II = {:.5g} to {:.5g} MPa sqrt(mm) under the pressure that "
                   "travels on {}, faces without tractions\n",
                   t, I.min, I.max, II.min, II.max, boundary.on);
        k += positions;
    }
}

/// K at the largest load, of one tip.
struct LargestK {
    double factor;  // of the load
    bool initial;   // the initial stress has a share

    /// K_I and K_II there, of those of the load factor 1 and of the initial stress.
    [[nodiscard]] coarse::TipResult of(const coarse::TipResult& unit) const {
        coarse::TipResult tip;
        tip.K_I = unit.K_I * factor + unit.K_initial;
        tip.K_II = unit.K_II * factor + unit.K_II_initial + 0.0;
        return tip;
    }
    [[nodiscard]] std::string text(const coarse::TipResult& unit) const {
        const coarse::TipResult tip = of(unit);
        return fmt::format("K_I = {:.5g}, K_II = {:.5g}", tip.K_I, tip.K_II);
    }
};

LargestK at_largest_load(const coarse::Scene& scene, const coarse::UnitResponse& unit) {
    const auto [largest, smallest] = coarse::range_of_load(scene.input, unit);
    return {largest > 0.0 ? largest : smallest, scene.initial_stress().any()};
}

/// Before a body is solved: who waits for it knows for what.
void print_estimate_of_body(const char* which, double seconds, double bytes) {
    fmt::print("# estimate of the elastic body{}: about {:.2g} s of a processor and {:.2g} MB\n", which, seconds,
               1e-6 * (bytes_of_program + bytes));
    std::fflush(stdout);
}
void print_estimate_of_body(const char* which, const coarse::Scene& scene) {
    print_estimate_of_body(which, coarse::seconds_of_body(scene), coarse::bytes_of_body(scene));
}

/// Takes four to five times what the scene's own body takes: not where that is much.
std::vector<coarse::TipResult> halved_where_cheap(const coarse::Scene& scene) {
    constexpr double of_body = 4.5, most_seconds = 10.0, most_bytes = 1e9;
    const double seconds = of_body * coarse::seconds_of_body(scene), bytes = of_body * coarse::bytes_of_body(scene);
    if (seconds <= most_seconds && bytes <= most_bytes) {
        print_estimate_of_body(" on elements half as large", seconds, bytes);
        return coarse::tips_on_halved_elements(scene);
    }
    fmt::print("# K on elements half as large is not asked for: it takes about {:.2g} s of a processor and {:.2g} MB\n",
               seconds, 1e-6 * (bytes_of_program + bytes));
    return {};
}

void print_K(const coarse::Scene& scene, const coarse::NominalSolution& nominal, const coarse::UnitResponse& unit) {
    if (nominal.tips.empty()) return;
    constexpr double worth_a_warning = 0.005;
    const LargestK K = at_largest_load(scene, unit);
    const std::vector<double> opening = coarse::largest_K_I(scene.input, unit),
                              turned = coarse::largest_K_behind_turns(scene.input, unit);
    const std::vector<coarse::TipResult> halved = halved_where_cheap(scene);
    for (std::size_t t = 0; t < nominal.tips.size(); ++t) {
        const coarse::TipResult& tip = nominal.tips[t];
        fmt::print("# tip {}: {} MPa sqrt(mm) at the load factor {:g}{} (elastic, traction-free faces)\n", t,
                   K.text(tip), K.factor, tip.K_I_of_cases.empty() ? "" : " without load cases");
        if (K.initial)
            fmt::print("#   of K_I {:.5g} and of K_II {:.5g} by the initial stress\n", tip.K_initial,
                       tip.K_II_initial + 0.0);
        if (turned[t] != opening[t])
            fmt::print("#   as it grows it turns sharply at first: K_I = {:.4g} behind that\n", turned[t]);
        if (halved.empty()) continue;
        const double change = coarse::change_of_K(tip, halved[t]);
        fmt::print("#   on elements half as large {}: K changes by {:.2g} %\n", K.text(halved[t]), 100.0 * change);
        if (change > worth_a_warning)
            fmt::print("# warning: tip {}: K changes by {:.2g} % on elements half as large, and a life by the exponent "
                       "of its law times that: smaller elements about the crack (mesh.size, mesh.grading or the mesh "
                       "file)\n",
                       t, 100.0 * change);
    }
}

/// Of tips that turn sharply with the first growth, by an increment that is given. Load cases aside.
void print_turns(const coarse::Scene& scene, const coarse::NominalSolution& nominal, const coarse::UnitResponse& unit) {
    const std::optional<GrowthSection>& growth = scene.input.growth;
    if (!growth || growth->direction == GrowthDirection::Straight || growth->increment.is_auto()) return;
    const LargestK K = at_largest_load(scene, unit);
    for (std::size_t t = 0; t < nominal.tips.size(); ++t) {
        const coarse::TipResult tip = K.of(nominal.tips[t]);
        if (std::abs(coarse::hoop_stress_angle(tip.K_I, tip.K_II)) <= coarse::sharp_turn) continue;
        const double element = coarse::tip_element_edge(scene.enriched, scene.enriched.tips[t]);
        if (const auto warning = coarse::turns_sharply(t, growth->increment.value(), element))
            fmt::print("# {}\n", *warning);
    }
}

void print_zone_estimate(const coarse::Scene& scene, const std::vector<double>& K) {
    for (std::size_t t = 0; t < K.size(); ++t) {
        if (const double yield_stress = scene.yield_stress_at_tips()[t]; std::isfinite(yield_stress)) {
            fmt::print("# tip {}: radius of the zone, eq. (3): {:.4g} mm by K = {:.5g} MPa sqrt(mm)\n", t,
                       coarse::subdivision_radius(scene.input.fine.beta, K[t], yield_stress), K[t]);
        }
    }
    const coarse::ZoneSize zone = coarse::size_of_zone(scene, coarse::select_zone(scene, K));
    fmt::print("# zone: {:.0f} elements, {:.0f} points\n", zone.elements, zone.points);
}

/// Of growth, mm; where the program chooses it, what it may be at first: no less than an element at the tip.
double largest_increment(const coarse::Scene& scene, const coarse::NominalSolution& nominal,
                         const std::vector<double>& K_I) {
    if (!scene.input.growth) return 0.0;
    const GrowthSection& growth = *scene.input.growth;
    if (!growth.increment.is_auto()) return growth.increment.value();
    double largest = 0.0;
    for (std::size_t t = 0; t < K_I.size(); ++t) {
        const double zone =
            coarse::forward_zone_ahead(K_I[t], scene.yield_stress_at_tips()[t], scene.input.model.plane);
        largest = std::max({largest, coarse::tip_element_edge(scene.enriched, scene.enriched.tips[t]),
                            coarse::largest_increment(growth, zone > 0.0, zone, nominal.tips[t].a)});
    }
    return largest;
}

/// Small elements follow the tips: what there will be of them.
void print_way(const coarse::WorkEstimate& work, double increment) {
    fmt::print(
        "# growth: at most {:.4g} mm in {:.0f} steps; after it about {:.0f} elements, {:.0f} of them in the zone, "
        "with {:.0f} points\n",
        increment * work.growths, work.growths, work.at_end.all, work.at_end.elements, work.at_end.points);
}

void print_estimate(const coarse::Scene& scene, const coarse::NominalSolution& nominal,
                    const std::vector<double>& K_I) {
    const double increment = largest_increment(scene, nominal, K_I);
    const coarse::WorkEstimate work = coarse::estimate_work(scene, nominal, K_I, increment);
    if (scene.input.growth && needs_fine(scene.input)) print_way(work, increment);
    fmt::print(
        "# estimate of the run: {:.0f} increments, at most {:.0f} of {:.0f} points flow; about {:.2g} s of a processor "
        "and {:.2g} MB, to a factor of two or three; more where increments have to be halved\n",
        work.increments, work.yielding, work.points, work.seconds, 1e-6 * work.bytes);
}

}  // namespace

int check(const RunOptions& options) {
    const Case input = read_case(options.case_path, options.overrides);
    const auto before_solving = [](const coarse::Scene& scene) {
        print_estimate_of_body(" before it is refined", scene);
    };
    const coarse::Scene scene = scene_of(options, input, before_solving);
    fmt::print("{}\n", resolved_toml(input));
    if (input.mesh.file)
        for (const std::string& line : coarse::describe_mesh_file(*input.mesh.file)) fmt::print("# {}\n", line);
    fmt::print("# mesh: {} nodes, {} elements, {} unknowns with enrichment; {} tips\n", scene.mesh->nodes.size(),
               scene.mesh->elements.size(), scene.enriched.unknowns, scene.enriched.tips.size());
    print_estimate_of_body("", scene);
    const coarse::NominalSolution nominal = coarse::solve_nominal(scene);
    print_handbook(nominal);
    const coarse::UnitResponse unit = coarse::unit_response(nominal);
    const std::vector<double> K = coarse::largest_K(input, unit);
    for (const std::string& warning : coarse::case_warnings(scene, unit)) fmt::print("# warning: {}\n", warning);
    for (std::size_t t = 0; t < nominal.tips.size(); ++t) print_load_cases(input, t, nominal.tips[t]);
    print_turns(scene, nominal, unit);
    print_K(scene, nominal, unit);
    if (!needs_fine(input)) {
        fmt::print("# elastic, traction-free, unrefined: no fine component is started\n");
    } else {
        print_zone_estimate(scene, K);
    }
    print_estimate(scene, nominal, K);
    return 0;
}

}  // namespace stria
