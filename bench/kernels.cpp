// The kernels that a Newton iteration is made of: a material point, an interface point, the matrices of an element.
// Nanoseconds a call, and the share of the peak that dgemm reaches in the same run on the same core. Flops are counted
// by hand, an addition, a multiplication, a division and a root one each; what is hot stays in the first cache.
#include <benchmark/benchmark.h>

#include <Eigen/Core>
#include <algorithm>
#include <ctime>
#include <memory>
#include <random>
#include <string>

#include "coarse/enrichment/enrichment.hpp"
#include "coarse/specimen/structured.hpp"
#include "common/index.hpp"
#include "common/linear/blas.hpp"
#include "common/linear/lapack.hpp"
#include "fine/bulk/points/element_kernels.hpp"
#include "fine/contact/contact_interface.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"

namespace {

using namespace stria;

/// Flops a second of processor time of C -= A B with 512 x 512 matrices, the best of ten.
double peak() {
    constexpr int n = 512;
    const Eigen::MatrixXd a = Eigen::MatrixXd::Random(n, n), b = Eigen::MatrixXd::Random(n, n);
    Eigen::MatrixXd c = Eigen::MatrixXd::Zero(n, n);
    double best = 1e300;
    for (int k = 0; k < 10; ++k) {
        const std::clock_t start = std::clock();
        lapack::subtract_product(n, n, n, a.data(), n, b.data(), n, c.data(), n);
        best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return 2.0 * n * n * n / best;
}

double peak_of_this_core() {
    static const double value = [] {
        use_one_thread();
        return peak();
    }();
    return value;
}

/// Each iteration makes so many calls of so many flops.
void count(benchmark::State& run, double calls, double flops) {
    using benchmark::Counter;
    const double all = static_cast<double>(run.iterations()) * calls;
    run.counters["per_call"] = Counter(all, Counter::kIsRate | Counter::kInvert);
    run.counters["flops_per_call"] = flops;
    run.counters["share_of_peak"] = Counter(all * flops / peak_of_this_core(), Counter::kIsRate);
}

void dgemm_512(benchmark::State& run) {
    for (auto _ : run) benchmark::DoNotOptimize(peak());
    run.counters["GFlop_per_s"] = peak_of_this_core() / 1e9;
}

MaterialSection steel() {
    return {.young = 200e3,
            .poisson = 0.3,
            .yield_stress = 350.0,
            .isotropic = {.law = HardeningLaw::Linear, .modulus = 1000.0},
            .kinematic = {{4000.0, 0.0}}};
}

/// Radial return with one back stress. The elastic stress takes 14 flops, its deviator less X 10, the yield function
/// 14, the state (strain, p, work, dissipation, X) 31: 69. Flow adds its direction and size 8, the stress 8, the
/// tangent 58: 143.
void return_map(benchmark::State& run) {
    constexpr int points = 200;
    const auto law = fine::make_material_law(steel(), PlaneState::Strain);
    const auto components = at(law->state_size());
    const double size = run.range(0) != 0 ? 4e-3 : 1e-3;
    std::vector<double> increments(4 * points, 0.0);
    for (std::size_t q = 0; q < points; ++q) {
        increments[q] = -0.4 * size;
        increments[points + q] = size;
    }
    const std::vector<double> committed(components * points, 0.0);
    std::vector<double> trial(components * points), tangent(16 * points);
    std::vector<unsigned char> yielding(points);
    for (auto _ : run) {
        law->update(points, points, increments.data(), committed.data(), trial.data(), tangent.data(), yielding.data());
        benchmark::ClobberMemory();
    }
    count(run, points, run.range(0) != 0 ? 143.0 : 69.0);
}

/// A plate of 9 x 9 unit elements with a crack to its middle: plain, cut, and holding the tip.
struct Plate {
    Plate() {
        input.material = steel();
        input.cracks.resize(1);
        input.cracks[0].points = {{0.0, 4.4}, {4.5, 4.4}};
        input.cracks[0].contact = ContactSection{};
        std::vector<double> ticks;
        for (int i = 0; i <= 9; ++i) ticks.push_back(i);
        mesh = coarse::enrich(BodyMesh(coarse::grid_mesh(ticks, ticks)), input.cracks, {.functions = 1});
        u = 1e-3 * Eigen::VectorXd::Random(mesh.unknowns);
    }
    [[nodiscard]] ElementOperator element(long kind) const {
        const Vec2 centre = kind == 0 ? Vec2(7.5, 0.5) : kind == 1 ? Vec2(1.5, 4.5) : Vec2(4.5, 4.5);
        const int index = 9 * static_cast<int>(centre.y()) + static_cast<int>(centre.x());
        const auto cut = std::ranges::find(mesh.pieces, index, &CrackPiece::element);
        const IntegrationRule rule{
            .subcells = 2, .singular_gauss = 2, .tip_points = 4, .mean_dilatation = MeanDilatation::Everywhere};
        return make_operator(mesh, index, cut != mesh.pieces.end() ? &*cut : nullptr, rule);
    }

    Case input;
    EnrichedMesh mesh;
    Eigen::VectorXd u;
    Elasticity elastic = elasticity_of(steel(), PlaneState::Strain);
};

/// Calls work(kernel, operator) over and over; `flops` of an element with f functions and q points.
template <class Work, class Flops> void on_element(benchmark::State& run, const Work& work, const Flops& flops) {
    const Plate plate;
    const ElementOperator op = plate.element(run.range(0));
    fine::with_kernel(op, [&](const auto& kernel) {
        for (auto _ : run) {
            work(plate, kernel, op);
            benchmark::ClobberMemory();
        }
    });
    const auto f = static_cast<double>(op.unknowns.size()) / 2.0, q = static_cast<double>(op.points.size());
    count(run, 1.0, flops(f, q));
    run.counters["points"] = q;
    run.counters["unknowns"] = 2.0 * f;
}

/// B^T C B at each point, made once a geometry: C B 64 f, B^T times that 32 f^2.
void elastic_stiffness(benchmark::State& run) {
    on_element(
        run,
        [](const Plate& plate, const auto&, const ElementOperator& op) {
            benchmark::DoNotOptimize(op.stiffness(plate.elastic.stiffness()));
        },
        [](double f, double q) { return q * (64.0 * f + 32.0 * f * f); });
}

/// K du and du^T K du: all that an element costs that is proven elastic.
void elastic_force(benchmark::State& run) {
    const Plate plate;
    const Eigen::MatrixXd K = plate.element(run.range(0)).stiffness(plate.elastic.stiffness());
    on_element(
        run,
        [&](const Plate& of, const auto& kernel, const ElementOperator&) {
            benchmark::DoNotOptimize(kernel.elastic_force(K, kernel.gather(of.u)));
        },
        [](double f, double) { return 8.0 * f * f + 4.0 * f; });
}

/// At each point: gradient 8 f, mean dilatation 4 f, strain 10.
void strains(benchmark::State& run) {
    std::vector<double> strain(4 * 1000);
    on_element(
        run,
        [&](const Plate& plate, const auto& kernel, const ElementOperator& op) {
            kernel.write_strains(kernel.gather(plate.u), strain.data(), std::ssize(op.points));
        },
        [](double f, double q) { return q * (12.0 * f + 10.0); });
}

/// At each point: deviator and weight 10, times the gradients 8 f, pressure times their mean 4 f.
void forces(benchmark::State& run) {
    const std::vector<double> stress(4 * 1000, 100.0);
    on_element(
        run,
        [&](const Plate&, const auto& kernel, const ElementOperator& op) {
            benchmark::DoNotOptimize(kernel.force(stress.data(), std::ssize(op.points)));
        },
        [](double f, double q) { return q * (12.0 * f + 10.0); });
}

/// The elastic matrix and what flow takes away, every point flowing: as elastic_stiffness, and the copy.
void tangent_with_flow(benchmark::State& run) {
    const Plate plate;
    const Eigen::MatrixXd K = plate.element(run.range(0)).stiffness(plate.elastic.stiffness());
    const MandelMatrix lost = -0.5 * plate.elastic.stiffness();
    on_element(
        run,
        [&](const Plate&, const auto& kernel, const ElementOperator& op) {
            typename std::decay_t<decltype(kernel)>::Matrix tangent = K;
            for (std::size_t q = 0; q < op.points.size(); ++q) kernel.add_stiffness(lost, q, tangent);
            benchmark::DoNotOptimize(tangent);
        },
        [](double f, double q) { return q * (64.0 * f + 32.0 * f * f); });
}

/// Multipliers of the plate's crack, opened by more than it moves.
struct Faces {
    Faces() : contact(plate.mesh, {}, plate.input.cracks, 2, plate.elastic.plane_modulus()) {
        for (const FaceStation& station : contact.operators().stations())
            for (const FaceStation::Term& term : station.terms) open[term.unknown + 1] = 1.0;
        contact.settle(open);
        const SparseRows& B = contact.operators().operator_B();
        entries = static_cast<double>(B.nonZeros()) / contact.multipliers();
        pressure = Eigen::VectorXd::Zero(contact.multipliers());
    }

    Plate plate;
    fine::ContactInterface contact;
    Eigen::VectorXd open = Eigen::VectorXd::Zero(plate.mesh.unknowns), pressure;
    double entries = 0.0;  // of a row of B
};

/// A product and a sum for each entry of its row, the weight.
void interface_gap(benchmark::State& run) {
    const Faces faces;
    for (auto _ : run) benchmark::DoNotOptimize(faces.contact.jumps(faces.plate.u));
    count(run, faces.contact.multipliers(), 2.0 * faces.entries + 1.0);
}

/// Those that cannot close: what has moved, once for all (two flops an entry of B, as each acts on jumps of its own),
/// and 2 each.
void interface_gap_proven_open(benchmark::State& run) {
    const Faces faces;
    coupling::WorkCounts work;
    const Eigen::VectorXd u = faces.open + 1e-3 * faces.plate.u;
    for (auto _ : run) benchmark::DoNotOptimize(faces.contact.jumps_that_matter(u, faces.pressure, work));
    count(run, faces.contact.multipliers(), 2.0 * faces.entries + 2.0);
}

/// p - c g and its sign.
void interface_status(benchmark::State& run) {
    Faces faces;
    const fine::ContactInterface::Jumps jumps = faces.contact.jumps(faces.open);
    for (auto _ : run) {
        faces.contact.choose_statuses(faces.pressure, jumps);
        benchmark::ClobberMemory();
    }
    count(run, faces.contact.multipliers(), 3.0);
}

/// Right-hand side of a multiplier's row and its matrix, which has a diagonal only where faces are apart.
void interface_row(benchmark::State& run) {
    const Faces faces;
    const fine::ContactInterface::Jumps jumps = faces.contact.jumps(faces.open);
    for (auto _ : run) {
        benchmark::DoNotOptimize(faces.contact.right_hand_side(faces.pressure, jumps));
        for (int k = 0; k < faces.contact.multipliers(); ++k) benchmark::DoNotOptimize(faces.contact.matrix_of(k));
    }
    count(run, faces.contact.multipliers(), 3.0);
}

}  // namespace

BENCHMARK(dgemm_512);
BENCHMARK(return_map)->ArgName("flows")->Arg(0)->Arg(1);
BENCHMARK(interface_gap);
BENCHMARK(interface_gap_proven_open);
BENCHMARK(interface_status);
BENCHMARK(interface_row);
// 0: plain, 1: cut, 2: holds the tip.
BENCHMARK(elastic_stiffness)->ArgName("kind")->DenseRange(0, 2);
BENCHMARK(elastic_force)->ArgName("kind")->DenseRange(0, 2);
BENCHMARK(strains)->ArgName("kind")->DenseRange(0, 2);
BENCHMARK(forces)->ArgName("kind")->DenseRange(0, 2);
BENCHMARK(tangent_with_flow)->ArgName("kind")->DenseRange(0, 2);
