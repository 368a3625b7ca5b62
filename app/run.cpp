#include "app/run.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <unistd.h>

#include "app/fine_side.hpp"
#include "app/monolithic.hpp"
#include "app/progress.hpp"
#include "app/version.hpp"
#include "coarse/condensed_equilibrium.hpp"
#include "coarse/handbook_comparison.hpp"
#include "coarse/largest_load.hpp"
#include "coarse/results/run_recorder.hpp"
#include "coarse/zone_selection.hpp"
#include "common/error.hpp"
#include "common/io/case_file.hpp"
#include "common/io/whole_file.hpp"
#include "common/linear/sparse_lu.hpp"
#include "coupling/mpi_transport.hpp"
#include "coupling/serve.hpp"
#include "fine/fine_model.hpp"

namespace stria {
namespace {

/// What only the mesh can tell is wrong names the case file too.
coarse::Scene scene_of(const RunOptions& options, const Case& input) {
    try {
        return coarse::make_scene(input);
    } catch (const CaseError& error) {
        throw CaseError(fmt::format("{}: {}", options.case_path, error.what()));
    }
}

/// mpirun puts a pipe or a terminal of its own between us and the user: the launcher knows what the user has.
bool users_terminal() { return std::getenv("STRIA_TERMINAL") != nullptr; }

/// One run from case to results, whoever finds equilibrium.
class Run {
public:
    Run(const RunOptions& options, const Case& input, std::string mode, int ranks, bool terminal)
        : options_(options), directory_(options.output_directory), mode_(std::move(mode)), ranks_(ranks),
          scene_(scene_of(options, input)), mesh_s_(seconds()),
          progress_(input, options.quiet, options.verbose, terminal) {
        write_whole_text(directory_ / "case.resolved.toml", resolved_toml(input));
    }

    void perform(coarse::EquilibriumFactory& factory, const FineSide* fine) {
        std::unique_ptr<coarse::RunRecorder> recorder;
        coarse::FatigueAnalysis* running = nullptr;
        coarse::Listener listener;
        listener.note = [&](const std::string& text) { progress_.note(text); };
        listener.attempted = [&](const coarse::LoadStep& step, const coarse::NewtonReport& report) {
            progress_.attempted(step, report);
        };
        listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure& structure) {
            recorder->record(increment, structure, running->closure());
            progress_.accepted(increment);
        };
        coarse::FatigueAnalysis analysis(scene_, factory, listener);
        running = &analysis;
        recorder = std::make_unique<coarse::RunRecorder>(scene_, directory_, [&] { return factory.zone_state(); });
        try {
            analysis.run();
        } catch (const NumericalFailure&) {
            summarise("failed", analysis, *recorder, fine);
            throw;
        }
        summarise("done", analysis, *recorder, fine);
        progress_.finished(directory_.string(), seconds());
    }

    [[nodiscard]] const coarse::Scene& scene() const { return scene_; }

private:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

    static void add_ranks(const FineSide& fine, const coupling::StepReport& zone, coarse::Summary& summary) {
        const coupling::Traffic traffic = fine.traffic();
        summary.messages = traffic.messages_sent + traffic.messages_received;
        summary.bytes = traffic.bytes_sent + traffic.bytes_received;
        for (const coupling::StepReport& rank : fine.reports(zone)) {
            summary.points_of_ranks.push_back(rank.points);
            summary.multipliers_of_ranks.push_back(rank.multipliers);
        }
        summary.ranks_idle = std::ranges::count(summary.points_of_ranks, 0);
    }

    void summarise(const char* status, const coarse::FatigueAnalysis& analysis, const coarse::RunRecorder& recorder,
                   const FineSide* fine) const {
        const coupling::StepReport& zone = recorder.last_zone();
        coarse::Summary summary;
        summary.status = status;
        summary.version = version_text();
        summary.mode = mode_;
        summary.ranks = ranks_;
        summary.coarse_unknowns = analysis.structure().unknowns();
        summary.interface_unknowns = std::ssize(analysis.structure().gamma());
        summary.fine_unknowns = zone.unknowns;
        summary.fine_points = zone.points;
        summary.multipliers = zone.multipliers;
        summary.fronts_refactored = zone.fronts_refactored;
        summary.factors_reused = zone.factors_reused;
        summary.points_evaluated = zone.points_evaluated;
        summary.points_proven_elastic = zone.points_proven_elastic;
        summary.tangents_computed = zone.tangents_computed;
        summary.elastic_tangents_reused = zone.elastic_tangents_reused;
        summary.newton_iterations = analysis.newton_iterations();
        summary.step_cuts = analysis.cuts();
        summary.zone_extensions = analysis.zone_extensions();
        summary.yield_warnings = analysis.yield_warnings();
        summary.flowing_rings = analysis.flowing_rings();
        if (fine != nullptr) add_ranks(*fine, zone, summary);
        summary.timing = {.mesh = mesh_s_,
                          .setup = analysis.setup_seconds(),
                          .coarse_factor = analysis.coarse_factor_seconds(),
                          .fine_constitutive = zone.constitutive_s,
                          .fine_contact = zone.contact_s,
                          .fine_factor = zone.factor_s,
                          .exchange = analysis.exchange_seconds(),
                          .coarse_solve =
                              analysis.run_seconds() - analysis.exchange_seconds() - recorder.output_seconds(),
                          .output = recorder.output_seconds(),
                          .total = seconds()};
        summary.last = recorder.last_rows();
        coarse::write_json(directory_ / "summary.json", coarse::to_json(summary));
    }

    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    const RunOptions& options_;
    std::filesystem::path directory_;
    std::string mode_;
    int ranks_;
    coarse::Scene scene_;
    double mesh_s_;  // and enrichment
    Progress progress_;
};

/// The elastic structure for the load factor 1, all faces traction-free.
struct Nominal {
    coarse::Structure structure;
    Eigen::VectorXd u;
    std::vector<coarse::TipResult> tips;

    explicit Nominal(const coarse::Scene& scene)
        : structure(scene, std::vector<char>(scene.mesh.elements.size(), 0)), u(structure.expand({}, 1.0)),
          tips(coarse::fracture_parameters(structure, u, {})) {}
};

void print_handbook(const Nominal& nominal) {
    for (const coarse::HandbookLine& line : coarse::compare_with_handbook(nominal.structure, nominal.u, nominal.tips)) {
        fmt::print("# {}: handbook {:.6g}", line.quantity + (line.unit.empty() ? "" : ", " + line.unit), line.handbook);
        if (std::isfinite(line.own))
            fmt::print(", this mesh {:.6g} ({:+.2f} %)", line.own, 100.0 * (line.own / line.handbook - 1.0));
        fmt::print("\n");
    }
}

void print_zone_estimate(const coarse::Scene& scene, const Nominal& nominal) {
    const double largest = coarse::largest_load_factor(scene.input.load, nominal.structure, nominal.tips);
    std::vector<double> K_I;
    for (const coarse::TipResult& tip : nominal.tips) {
        K_I.push_back(tip.K_I * largest);
        fmt::print("# tip {}: K_I = {:.5g} MPa sqrt(mm) at the load factor {:g} (elastic, traction-free faces)\n",
                   K_I.size(), K_I.back(), largest);
        if (scene.input.material.yield_stress) {
            fmt::print(
                "#   radius of the zone, eq. (3): {:.4g} mm\n",
                coarse::subdivision_radius(scene.input.fine.beta, K_I.back(), *scene.input.material.yield_stress));
        }
    }
    const std::vector<char> in_zone = coarse::select_zone(scene, K_I);
    const auto elements = std::ranges::count(in_zone, static_cast<char>(1));
    fmt::print("# zone: {} elements, about {} points\n", elements,
               elements * 4 * scene.input.fine.subcells * scene.input.fine.subcells);
}

}  // namespace

int run_coarse_with_mpi(const RunOptions& options) {
    use_one_thread();
    const Case input = read_case(options.case_path, options.overrides);
    if (!needs_fine(input)) {
        coarse::CondensedFactory alone(nullptr);
        Run(options, input, "mpi", 1, users_terminal()).perform(alone, nullptr);
        return 0;
    }
    const coupling::MpiSession session(coupling::Role::Coarse);
    try {
        FineSide fine(input, session);
        coarse::CondensedFactory factory(&fine.scale());
        Run(options, input, "mpi", 1 + session.peers(), users_terminal()).perform(factory, &fine);
    } catch (const CaseError&) {
        throw;  // the conversation has ended in order: both sides leave
    } catch (const NumericalFailure&) {
        throw;
    } catch (const std::exception& failure) {
        fmt::print(stderr, "stria-coarse: {}\n", failure.what());
        session.abort(4);
    }
    return 0;
}

int run_fine_with_mpi(const RunOptions& options) {
    use_one_thread();
    const Case input = read_case(options.case_path, options.overrides);
    const coupling::MpiSession session(coupling::Role::Fine);
    try {
        const std::unique_ptr<coupling::Transport> transport = session.transport();
        fine::FineModel model(input);
        coupling::serve(*transport, model, digest(input));
    } catch (const CaseError&) {
        throw;
    } catch (const std::exception& failure) {
        fmt::print(stderr, "stria-fine: {}\n", failure.what());
        session.abort(4);
    }
    return 0;
}

int run_in_process(const RunOptions& options) {
    use_one_thread();
    const Case input = read_case(options.case_path, options.overrides);
    Run run(options, input, options.mode, 1, isatty(STDOUT_FILENO) != 0);
    if (options.mode == "monolithic") {
        MonolithicFactory factory(run.scene().input);
        run.perform(factory, nullptr);
    } else {
        FineSide fine(run.scene().input, options.fine_ranks);
        coarse::CondensedFactory factory(&fine.scale());
        run.perform(factory, &fine);
    }
    return 0;
}

int check(const RunOptions& options) {
    const Case input = read_case(options.case_path, options.overrides);
    const coarse::Scene scene = scene_of(options, input);
    fmt::print("{}\n", resolved_toml(input));
    fmt::print("# mesh: {} nodes, {} elements, {} unknowns with enrichment; {} tips\n", scene.mesh.nodes.size(),
               scene.mesh.elements.size(), scene.enriched.unknowns, scene.enriched.tips.size());
    const Nominal nominal(scene);
    print_handbook(nominal);
    if (!needs_fine(input)) {
        fmt::print("# elastic, traction-free, unrefined: no fine component is started\n");
        return 0;
    }
    print_zone_estimate(scene, nominal);
    return 0;
}

}  // namespace stria
