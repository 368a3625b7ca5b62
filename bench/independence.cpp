// The cost of an increment against the size of the structure: the same crack, the same zone and the same elements about
// it in square plates of more and more elements, pulled to the same K. Processor seconds of both components in one
// process, so that other work on the machine counts little.
//     bench_independence [elements across...]
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <numbers>
#include <numeric>
#include <type_traits>
#include <vector>

#include "bench/sizes.hpp"
#include "coarse/analysis/fatigue_analysis.hpp"
#include "coarse/equilibrium/condensed/condensed_factory.hpp"
#include "coarse/zone/refined_scene.hpp"
#include "common/linear/blas.hpp"
#include "fine/zone/fine_model.hpp"

namespace stria {
namespace {

constexpr double size = 0.5, crack = 10.0;  // mm
constexpr double largest_K = 500.0;         // MPa sqrt(mm)
constexpr int steps = 20, cycles = 3;

struct Measurement {
    int elements = 0, unknowns = 0, gamma = 0, points = 0, near = 0, iterations = 0;
    std::int64_t full_checks = 0, checks_by_bound = 0;
    double setup_s = 0.0;
    std::vector<double> increments_ms;

    [[nodiscard]] double mean_ms() const {
        return std::reduce(increments_ms.begin(), increments_ms.end()) / double(increments_ms.size());
    }
    [[nodiscard]] double median_ms() const {
        std::vector<double> sorted = increments_ms;
        std::ranges::nth_element(sorted, sorted.begin() + std::ssize(sorted) / 2);
        return sorted[sorted.size() / 2];
    }
};

double processor_seconds() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// Remote tension that gives K in a plate of this width whose ends may turn (Tada).
double tension(double K, double width) {
    const double x = std::numbers::pi * crack / (2.0 * width);
    const double shape = std::sqrt(std::tan(x) / x) *
                         (0.752 + 2.02 * crack / width + 0.37 * std::pow(1.0 - std::sin(x), 3)) / std::cos(x);
    return K / (shape * std::sqrt(std::numbers::pi * crack));
}

Case plate(int across) {
    Case input;
    const double side = across * size;
    input.mesh = {.specimen = "plate", .width = side, .height = side, .size = size, .grading = {}};
    input.material.young = 200e3;
    input.material.poisson = 0.3;
    input.material.yield_stress = 300.0;
    input.material.kinematic = {{.C = 4000.0}};
    input.cracks = {{.points = {{0.0, side / 2.0}, {crack, side / 2.0}}, .contact = {}}};
    for (const double end : {1.0, -1.0}) {
        BoundarySection pulled;
        pulled.on = end > 0.0 ? "top" : "bottom";
        pulled.traction = Vec2(0.0, end);
        input.boundaries.push_back(pulled);
    }
    input.load.steps = steps;
    input.load.blocks = {{.cycles = cycles, .max = tension(largest_K, side), .min = 0.0}};
    input.fine.radius = 1.5;
    input.fine.refine = 8;
    return input;
}

Measurement measure(int across) {
    const Case input = plate(across);
    double last = processor_seconds();
    const auto lap = [&] {
        const double now = processor_seconds();
        return now - std::exchange(last, now);
    };
    Measurement result;
    const coarse::Scene scene = coarse::refined_scene(input);
    fine::FineModel fine(input);
    coarse::CondensedFactory factory(&fine, input);
    coarse::Listener listener;
    listener.accepted = [&](const coarse::Increment& increment, const coarse::Structure&) {
        result.increments_ms.push_back(1e3 * lap());
        result.iterations += increment.newton.count();
        result.points = static_cast<int>(increment.zone.points);
    };
    coarse::FatigueAnalysis analysis(scene, factory, listener);
    result.setup_s = lap();
    analysis.run();
    result.elements = across * across;
    result.unknowns = analysis.structure().unknowns();
    result.gamma = static_cast<int>(analysis.structure().gamma().size());
    result.near = static_cast<int>(analysis.structure().elements().near().size());
    result.full_checks = analysis.effort().work.structure_checks_full;
    result.checks_by_bound = analysis.effort().work.structure_checks_by_bound;
    return result;
}

template <class Value> void print_row(const char* name, const std::vector<Measurement>& sizes, Value&& value) {
    std::printf("| %s |", name);
    for (const Measurement& m : sizes)
        std::printf(std::is_integral_v<decltype(value(m))> ? " %.8g |" : " %.3g |", double(value(m)));
    std::printf("\n");
}

void print(const std::vector<Measurement>& sizes) {
    print_row("elements", sizes, [](const auto& m) { return m.elements; });
    std::printf("|---|");
    for (std::size_t k = 0; k < sizes.size(); ++k) std::printf("---|");
    std::printf("\n");
    print_row("unknowns of the structure", sizes, [](const auto& m) { return m.unknowns; });
    print_row("unknowns on Gamma", sizes, [](const auto& m) { return m.gamma; });
    print_row("near elements", sizes, [](const auto& m) { return m.near; });
    print_row("points of the zone", sizes, [](const auto& m) { return m.points; });
    print_row("set-up, s", sizes, [](const auto& m) { return m.setup_s; });
    print_row("Newton iterations an increment", sizes,
              [](const auto& m) { return double(m.iterations) / double(m.increments_ms.size()); });
    print_row("an increment, median, ms", sizes, [](const auto& m) { return m.median_ms(); });
    print_row("an increment, mean, ms", sizes, [](const auto& m) { return m.mean_ms(); });
    print_row("the mean, a Newton iteration, ms", sizes,
              [](const auto& m) { return m.mean_ms() * double(m.increments_ms.size()) / double(m.iterations); });
    print_row("looks at all far elements", sizes, [](const auto& m) { return m.full_checks; });
    print_row("looks that their bound saved", sizes, [](const auto& m) { return m.checks_by_bound; });
}

}  // namespace
}  // namespace stria

int main(int argc, char** argv) {
    stria::begin_with_kernels_of_the_processor(argv);
    stria::use_one_thread();
    std::vector<stria::Measurement> sizes;
    for (const int n : stria::sizes_from(argc, argv, 1, {45, 141, 447, 1001})) sizes.push_back(stria::measure(n));
    stria::print(sizes);
    return 0;
}
