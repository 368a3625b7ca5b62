// The zone's tree of fronts: 40 x 40 elements of 8 unknowns; boundary: the outline and two rows of nodes to
// the middle. All fronts, those above 30 changed elements at the tip or in a corner, and one solution.
#include "common/substructure/front_tree.hpp"

#include <benchmark/benchmark.h>

#include <vector>

#include "common/index.hpp"

namespace stria {
namespace {

constexpr int side = 40;

int node_at(int i, int j) { return j * (side + 1) + i; }

FrontTree::Layout layout() {
    FrontTree::Layout result;
    result.unknowns = 2 * (side + 1) * (side + 1);
    for (int j = 0; j < side; ++j) {
        for (int i = 0; i < side; ++i) {
            std::vector<int> unknowns;
            for (const int node : {node_at(i, j), node_at(i + 1, j), node_at(i + 1, j + 1), node_at(i, j + 1)}) {
                unknowns.insert(unknowns.end(), {2 * node, 2 * node + 1});
            }
            result.element_unknowns.push_back(unknowns);
            result.centres.emplace_back(i + 0.5, j + 0.5);
        }
    }
    for (int j = 0; j <= side; ++j) {
        for (int i = 0; i <= side; ++i) {
            const bool outline = i == 0 || i == side || j == 0 || j == side;
            const bool slit = i <= side / 2 && (j == side / 2 || j == side / 2 + 1);
            const int first = 2 * node_at(i, j);
            if (outline || slit) result.boundary.insert(result.boundary.end(), {first, first + 1});
        }
    }
    return result;
}

/// Positive definite, as stiff between nodes as to the ground: the cost does not depend on the entries.
std::vector<Eigen::MatrixXd> element_matrices() {
    const Eigen::MatrixXd one = 2.0 * Eigen::MatrixXd::Identity(8, 8) - Eigen::MatrixXd::Constant(8, 8, 0.125);
    return std::vector<Eigen::MatrixXd>(at(side * side), one);
}

/// Flags 6 x 5 elements from (i, j) on.
std::vector<char> flags(int i, int j) {
    std::vector<char> changed(at(side * side), 0);
    for (int y = j; y < j + 5; ++y) {
        for (int x = i; x < i + 6; ++x) changed[at(y * side + x)] = 1;
    }
    return changed;
}

void factor(benchmark::State& state, Symmetry symmetry, const std::vector<char>& changed) {
    const std::vector<Eigen::MatrixXd> matrices = element_matrices();
    FrontTree tree(layout());
    tree.factor(matrices, changed, symmetry);
    const long before = tree.refactored();
    for (auto _ : state) tree.factor(matrices, changed, symmetry);
    const auto refactored = static_cast<double>(tree.refactored() - before);
    state.counters["fronts"] = refactored / static_cast<double>(state.iterations());
    state.counters["boundary"] = static_cast<double>(tree.tangent().rows());
}

void factor_all(benchmark::State& state, Symmetry symmetry) {
    factor(state, symmetry, std::vector<char>(at(side * side), 1));
}
void factor_corner(benchmark::State& state, Symmetry symmetry) { factor(state, symmetry, flags(0, 0)); }
void factor_tip(benchmark::State& state, Symmetry symmetry) { factor(state, symmetry, flags(18, 18)); }

void solve(benchmark::State& state, Symmetry symmetry) {
    const FrontTree::Layout zone = layout();
    FrontTree tree(zone);
    tree.factor(element_matrices(), std::vector<char>(zone.centres.size(), 1), symmetry);
    const Eigen::VectorXd load = Eigen::VectorXd::Ones(zone.unknowns);
    for (auto _ : state) {
        const ReducedLoad reduced = tree.reduce(load);
        benchmark::DoNotOptimize(tree.expand(reduced, reduced.boundary));
    }
}

void build(benchmark::State& state) {
    const FrontTree::Layout zone = layout();
    for (auto _ : state) benchmark::DoNotOptimize(FrontTree(zone).fronts());
}

BENCHMARK(build)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(factor_all, symmetric, Symmetry::Symmetric)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(factor_corner, symmetric, Symmetry::Symmetric)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(factor_tip, symmetric, Symmetry::Symmetric)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, symmetric, Symmetry::Symmetric)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(factor_all, general, Symmetry::General)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(factor_corner, general, Symmetry::General)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(factor_tip, general, Symmetry::General)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(solve, general, Symmetry::General)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stria
