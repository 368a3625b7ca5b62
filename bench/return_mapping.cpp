// Time of a material point: one update of a block in which a given share of the points flows.
#include <benchmark/benchmark.h>

#include <random>
#include <vector>

#include "fine/material/catalogue/material_catalogue.hpp"

#include "common/index.hpp"

namespace {

using namespace stria;

constexpr int points = 1000;  // not a power of two: components a multiple of 4 kB apart would share cache sets

MaterialSection material_of(int back_stresses) {
    return {.young = 200e3,
            .poisson = 0.3,
            .yield_stress = 350.0,
            .isotropic = {.law = HardeningLaw::Linear, .modulus = 1000.0},
            .kinematic = std::vector<KinematicHardening>(at(back_stresses), {4000.0, 0.0})};
}

/// Random places of the flowing points: the worst case for a branch.
std::vector<double> strain_increments(double flowing_share) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    std::vector<double> increments(4 * points, 0.0);
    for (std::size_t q = 0; q < points; ++q) {
        const double size = unit(random) < flowing_share ? 4e-3 : 1e-3;
        increments[q] = -0.4 * size;
        increments[points + q] = size;
        increments[3 * points + q] = 0.3 * size * unit(random);
    }
    return increments;
}

void update_points(benchmark::State& run, PlaneState plane, int substeps) {
    const auto law = fine::make_material_law(material_of(static_cast<int>(run.range(1))), plane, substeps);
    const auto size = at(law->state_size()) * points;
    const auto increments = strain_increments(static_cast<double>(run.range(0)) / 100.0);
    const std::vector<double> committed(size, 0.0);
    std::vector<double> trial(size);
    std::vector<double> tangent(16 * points);
    std::vector<unsigned char> yielding(points);
    for (auto _ : run) {
        law->update(points, points, increments.data(), committed.data(), trial.data(), tangent.data(), yielding.data());
        benchmark::DoNotOptimize(trial.data());
        benchmark::ClobberMemory();
    }
    run.SetItemsProcessed(run.iterations() * points);
    run.counters["per_point"] = benchmark::Counter(static_cast<double>(run.iterations()) * points,
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// In plane strain, where a return is exact.
void return_mapping(benchmark::State& run) { update_points(run, PlaneState::Strain, 1); }

/// In plane stress, within an error bound.
void return_in_parts(benchmark::State& run) { update_points(run, PlaneState::Stress, 4); }

}  // namespace

BENCHMARK(return_in_parts)->ArgNames({"flowing_percent", "back_stresses"})->ArgsProduct({{100}, {0, 1, 2}});
BENCHMARK(return_mapping)->ArgNames({"flowing_percent", "back_stresses"})->ArgsProduct({{0, 5, 50, 100}, {0, 1, 2}});
