// What the functions at a stationary tip are worth in a power-law material: an edge crack pulled to half its limit load
// and to all of it, with none, with one and with six functions of eq. (2), r^(1/2) and r^(1/(n+1)). Prints CSV, one row
// a load: J, CTOD, openings, mean stresses ahead of the tip, CPU seconds so far, iterations, condition numbers.
//     bench_power_law_tip [plane strain: 0, plane stress: 1] [n] [across:refine:function ...]
// A mesh has `across` elements over the width, split log2(refine) times at the tip. Functions: 0 none; 1, 6 of r^(1/2);
// 11, 16 likewise of r^(1/(n+1)). The tip lies on an element edge, and again a third of an element from two of them.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/enrichment/enrichment.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/specimen/handbook.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/integration/crack_faces.hpp"
#include "common/linear/blas.hpp"
#include "fine/zone/fine_model.hpp"
#include "tests/support/condition_number.hpp"

namespace stria::test {
namespace {

constexpr double sigma_0 = 400.0, young = 200e3,
                 cell = 1.0 / 64.0;  // MPa; mm, of the patches whose stress is asked for

struct Trial {
    PlaneState plane = PlaneState::Strain;
    double n = 5.0;
    bool on_edge = true;
    int across = 8, refine = 8, function = 0;

    // Halved, a third of an element is two thirds of one: the tip lies alike on all meshes.
    [[nodiscard]] double a() const { return 0.5 + (on_edge ? 0.0 : 1.0 / 24.0); }
    [[nodiscard]] static double level() { return 1.0 + 1.0 / 24.0; }
    [[nodiscard]] double limit() const { return coarse::sent_limit_load(1.0, a(), sigma_0, plane); }
    [[nodiscard]] double exponent() const { return function > 10 ? 1.0 / (n + 1.0) : 0.5; }
};

Case case_of(const Trial& trial) {
    Case input;
    input.model.plane = trial.plane;
    input.mesh = {.specimen = "sent", .width = 1.0, .height = 2.0, .size = 1.0 / trial.across, .grading = {}};
    input.material = {.young = young,
                      .poisson = 0.3,
                      .yield_stress = (trial.n < 4.0 ? 0.1 : 0.3) * sigma_0,
                      .isotropic = {.law = HardeningLaw::Power, .n = trial.n, .alpha = 1.0, .reference = sigma_0},
                      .kinematic = {}};
    input.cracks = {{.points = {{0.0, Trial::level()}, {trial.a(), Trial::level()}}, .contact = {}}};
    for (const double sign : {1.0, -1.0}) {
        BoundarySection end;
        end.on = sign > 0.0 ? "top" : "bottom";
        end.traction = Vec2(0.0, sign);
        input.boundaries.push_back(end);
    }
    input.fine.radius = 10.0;
    input.fine.refine = trial.refine;
    input.load = {.steps = 32, .grading = 1.0, .blocks = {{.cycles = 0, .max = trial.limit(), .min = 0.0}}};
    return input;
}

coarse::Scene scene_of(const Trial& trial, const Case& input) {
    coarse::Scene scene = coarse::refined_scene(input);
    scene.enriched = coarse::enrich(scene.mesh, input.cracks, {trial.function % 10, trial.exponent()});
    coarse::put_loads_on_unknowns(scene);
    return scene;
}

/// Of the tangent of the zone, all of whose boundary is held.
double condition_of_tangent(const fine::FineModel& fine) {
    const fine::Bulk& bulk = fine.system().bulk();
    std::vector<Triplet> entries;
    for (int e = 0; e < bulk.elements().count(); ++e) {
        const std::vector<int>& unknowns = bulk.elements().op(e).unknowns;
        const Eigen::MatrixXd& tangent = bulk.tangent(e);
        for (Eigen::Index i = 0; i < tangent.rows(); ++i)
            for (Eigen::Index j = 0; j < tangent.cols(); ++j)
                entries.emplace_back(unknowns[at(i)], unknowns[at(j)], tangent(i, j));
    }
    const coupling::Patch& patch = fine.system().patch();
    SparseMatrix K(patch.mesh.unknowns, patch.mesh.unknowns);
    K.setFromTriplets(entries.begin(), entries.end());
    UnknownSet held(patch.mesh.unknowns);
    for (const int unknown : patch.boundary) held.insert(unknown);
    return condition_number(K, held, 40);
}

/// Mean stress across the crack's line over the patch that is so many cells ahead of the cell edge at or beyond the
/// tip.
double stress_ahead(const coupling::ZoneState& state, const Trial& trial, int cells) {
    const double from = (std::ceil(trial.a() / cell - 1e-9) + cells) * cell,
                 low = std::floor(Trial::level() / cell) * cell;
    double force = 0.0, area = 0.0;
    for (std::size_t p = 0; p < state.x.size(); ++p) {
        if (state.x[p] < from || state.x[p] > from + cell || state.y[p] < low || state.y[p] > low + cell) continue;
        force += state.weight[p] * state.stress[4 * p + 1];
        area += state.weight[p];
    }
    return area > 0.0 ? force / area : 0.0;
}

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class CpuTime {
public:
    explicit CpuTime(double& sum) : sum_(sum), start_(seconds()) {}
    CpuTime(const CpuTime&) = delete;
    CpuTime& operator=(const CpuTime&) = delete;
    ~CpuTime() { sum_ += seconds() - start_; }

private:
    double& sum_;
    double start_;
};

void print_state(const Trial& trial, const coarse::TipResult& tip, fine::FineModel& fine) {
    const coupling::ZoneState state = fine.state();
    std::printf(",%.8g,%.3g,%.8g", tip.J, tip.J_spread, tip.CTOD);
    for (const int cells : {1, 4}) {
        const FaceStation behind = face_station_at(fine.system().patch().mesh, 0, trial.a() - cells * cell);
        std::printf(",%.8g", behind.opening(state.displacement));
    }
    for (const int cells : {0, 1, 3}) std::printf(",%.8g", stress_ahead(state, trial, cells));
    std::printf(",%zu", state.x.size());
}

void run(const Trial& trial) {
    const double start = seconds();
    double aside = 0.0;  // what measuring takes
    const Case input = case_of(trial);
    const coarse::Scene scene = scene_of(trial, input);
    const double elastic = [&] {
        const CpuTime watch(aside);
        return condition_number(coarse::Structure(scene), 40);
    }();
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    int iterations = 0;
    coarse::Listener listener;
    listener.attempted = [&](const coarse::LoadStep&, const coarse::NewtonReport& r) { iterations += r.count(); };
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure&) {
        const double spent = seconds() - start - aside, load = increment.load_factor / trial.limit();
        if (std::abs(load - 0.5) > 1e-9 && std::abs(load - 1.0) > 1e-9) return;
        const CpuTime watch(aside);
        std::printf("%s,%g,%s,%d,%d,%d,%.1f", trial.plane == PlaneState::Strain ? "strain" : "stress", trial.n,
                    trial.on_edge ? "edge" : "inside", trial.across, trial.refine, trial.function, load);
        print_state(trial, increment.tips[0], fine);
        std::printf(",%.3f,%d,%.4g,%.4g\n", spent, iterations, elastic, condition_of_tangent(fine));
        std::fflush(stdout);
    };
    coarse::FatigueAnalysis(scene, factory, listener).run();
}

}  // namespace
}  // namespace stria::test

int main(int argc, char** argv) {
    using stria::test::Trial;
    stria::begin_with_kernels_of_the_processor(argv);
    stria::use_one_thread();
    if (argc < 4) return 2;
    Trial trial;
    trial.plane = std::atoi(argv[1]) == 0 ? stria::PlaneState::Strain : stria::PlaneState::Stress;
    trial.n = std::atof(argv[2]);
    std::printf(
        "plane,n,tip,across,refine,function,load,J,J_spread,CTOD,opening_1,opening_4,stress_0,stress_1,stress_3,"
        "points,seconds,iterations,condition,condition_of_tangent\n");
    for (int k = 3; k < argc; ++k) {
        if (std::sscanf(argv[k], "%d:%d:%d", &trial.across, &trial.refine, &trial.function) != 3) return 2;
        for (const bool on_edge : {true, false}) {
            trial.on_edge = on_edge;
            stria::test::run(trial);
        }
    }
    return 0;
}
