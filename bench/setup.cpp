// Set-up of the structure, phase by phase: an elastic edge-cracked plate of square elements, one process a size, the
// best of some repeats. Prints seconds, shares, the exponent from size to size, and the peak of memory after each
// phase.
//     bench_setup [repeats] [elements...]
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "bench/sizes.hpp"
#include "coarse/enrichment/enrichment.hpp"
#include "coarse/enrichment/tip_enrichment.hpp"
#include "coarse/fields/field_writer.hpp"
#include "coarse/fields/zone_fields.hpp"
#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/model/scene.hpp"
#include "coarse/specimen/specimen.hpp"
#include "coarse/structure/structure.hpp"
#include "common/linear/blas.hpp"

namespace stria {
namespace {

constexpr std::array phases{"mesh", "enrichment", "assembly", "ordering", "factor", "solve", "rings", "fields"};

struct Measurement {
    int elements = 0;
    double factor_entries = 0.0;
    std::array<double, phases.size()> seconds{};
    std::array<double, phases.size()> peak_gb{};

    [[nodiscard]] double setup() const {  // what a run pays before its first increment
        return seconds[0] + seconds[1] + seconds[2] + seconds[3] + seconds[4] + seconds[5] + seconds[6];
    }
};

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

double peak_gb() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1048576.0;
}

Case plate(int elements) {
    Case input;
    const double width = 50.0, height = 200.0;
    input.mesh = {.specimen = "sent",
                  .width = width,
                  .height = height,
                  .size = std::sqrt(width * height / elements),
                  .grading = {}};
    input.material.young = 200e3;
    input.material.poisson = 0.3;
    input.cracks = {{.points = {{0.0, height / 2.0}, {0.4 * width, height / 2.0}}, .contact = {}}};
    BoundarySection top, bottom;
    top.on = "top";
    top.traction = Vec2(0.0, 1.0);
    bottom.on = "bottom";
    bottom.traction = Vec2(0.0, -1.0);
    input.boundaries = {top, bottom};
    return input;
}

Measurement measure(int elements) {
    use_one_thread();
    Measurement result;
    double last = now();
    std::size_t phase = 0;
    const auto lap = [&] {
        const double time = now();
        result.peak_gb[phase] = peak_gb();
        result.seconds[phase++] = time - last;
        last = time;
    };
    coarse::Scene scene;
    scene.input = plate(elements);
    scene.materials = Materials(scene.input);
    scene.mesh = BodyMesh(coarse::make_mesh(scene.input.mesh, scene.input.cracks));
    scene.loads.main = coarse::resolve_boundaries(scene.mesh, scene.input.boundaries);
    scene.free_motions = coarse::analyse_rigid_motions(scene.mesh, scene.loads.main);
    lap();
    scene.enriched = coarse::enrich(scene.mesh, scene.input.cracks, coarse::choose_enrichment(scene.input));
    coarse::put_loads_on_unknowns(scene);
    lap();
    const coarse::Structure structure(scene);
    for (const double seconds :
         {structure.seconds().assembly, structure.seconds().ordering, structure.seconds().factor}) {
        result.peak_gb[phase] = peak_gb();
        result.seconds[phase++] = seconds;
    }
    last = now();
    const Eigen::VectorXd u = structure.expand({}, 1.0);
    lap();
    (void)coarse::fracture_parameters(structure, u, {});
    lap();
    const std::filesystem::path file =
        std::filesystem::temp_directory_path() / ("stria_bench_" + std::to_string(getpid()));
    coarse::write_vtkhdf(file, coarse::make_fields(structure, u, nullptr, {}));
    std::filesystem::remove(file);
    lap();
    result.elements = static_cast<int>(scene.mesh->elements.size());
    result.factor_entries = structure.factor_entries();
    return result;
}

/// In a process of its own: memory given back to the heap would hide what the next size takes.
Measurement measure_apart(int elements) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) std::exit(1);
    Measurement result;
    const pid_t child = fork();
    if (child == 0) {
        result = measure(elements);
        const bool written = write(ends[1], &result, sizeof result) == sizeof result;
        _exit(written ? 0 : 1);
    }
    const bool read_all = read(ends[0], &result, sizeof result) == sizeof result;
    int status = 0;
    waitpid(child, &status, 0);
    close(ends[0]);
    close(ends[1]);
    if (!read_all || status != 0) std::exit(1);
    return result;
}

Measurement best_of(int repeats, int elements) {
    Measurement best = measure_apart(elements);
    for (int k = 1; k < repeats; ++k) {
        const Measurement again = measure_apart(elements);
        for (std::size_t phase = 0; phase < phases.size(); ++phase)
            best.seconds[phase] = std::min(best.seconds[phase], again.seconds[phase]);
    }
    return best;
}

double exponent(double time, double before, int elements, int elements_before) {
    return std::log(time / before) / std::log(double(elements) / elements_before);
}

void print(const std::vector<Measurement>& sizes) {
    std::printf("| elements |");
    for (const Measurement& m : sizes) std::printf(" %d |", m.elements);
    std::printf("\n|---|");
    for (std::size_t k = 0; k < sizes.size(); ++k) std::printf("---|");
    const auto row = [&](const char* name, auto&& seconds, auto&& peak) {
        std::printf("\n| %s |", name);
        for (std::size_t k = 0; k < sizes.size(); ++k) {
            std::printf(" %.3f s (%.0f %%)", seconds(sizes[k]), 100.0 * seconds(sizes[k]) / sizes[k].setup());
            if (k > 0)
                std::printf(" ^%.2f", exponent(seconds(sizes[k]), seconds(sizes[k - 1]), sizes[k].elements,
                                               sizes[k - 1].elements));
            std::printf(", %.2f GB |", peak(sizes[k]));
        }
    };
    for (std::size_t phase = 0; phase < phases.size(); ++phase)
        row(
            phases[phase], [&](const Measurement& m) { return m.seconds[phase]; },
            [&](const Measurement& m) { return m.peak_gb[phase]; });
    row(
        "set-up", [](const Measurement& m) { return m.setup(); },
        [](const Measurement& m) { return m.peak_gb[phases.size() - 2]; });
    std::printf("\n| factor, million entries |");
    for (const Measurement& m : sizes) std::printf(" %.2f |", m.factor_entries / 1e6);
    std::printf("\n");
}

}  // namespace
}  // namespace stria

int main(int argc, char** argv) {
    stria::begin_with_kernels_of_the_processor(argv);
    const int repeats = argc > 1 ? std::atoi(argv[1]) : 3;
    const std::vector<int> elements = stria::sizes_from(argc, argv, 2, {2'000, 20'000, 200'000, 1'000'000});
    std::vector<stria::Measurement> sizes;
    for (const int size : elements) sizes.push_back(stria::best_of(repeats, size));
    stria::print(sizes);
    return 0;
}
