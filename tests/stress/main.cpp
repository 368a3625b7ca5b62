// stria_stress N SEED: random cracks, and random metals on random paths, as many as asked for, and a fifth as many
// bodies that flow, through what must hold for all of them. Prints the worst of each measure, and what failed with its
// seed. `stria_stress 1 SEED` repeats one and shows it. Exit code 1 where something failed.
#include <cstdlib>
#include <fmt/format.h>
#include <iostream>

#include "common/linear/blas.hpp"
#include "tests/stress/body_trials.hpp"
#include "tests/stress/crack_trials.hpp"
#include "tests/stress/law_trials.hpp"

namespace {

constexpr unsigned bodies_one_in = 5;

void show(const stria::test::CrackedPlate& plate) {
    std::cout << fmt::format("{} elements across; the crack, in elements:", plate.mesh_name);
    for (const stria::Vec2& x : plate.points)
        std::cout << fmt::format(" ({:.12g}, {:.12g})", x.x() / plate.h, x.y() / plate.h);
    std::cout << '\n';
}

}  // namespace

int main(int count, char** words) {
    stria::begin_with_kernels_of_the_processor(words);
    if (count != 3) {
        std::cerr << "usage: stria_stress N SEED\n";
        return 2;
    }
    const auto trials = static_cast<unsigned>(std::strtoul(words[1], nullptr, 10)),
               first = static_cast<unsigned>(std::strtoul(words[2], nullptr, 10));
    stria::use_one_thread();
    stria::test::Tally tally;
    for (unsigned seed = first; seed < first + trials; ++seed) {
        const stria::test::CrackedPlate plate = stria::test::random_crack(seed);
        if (trials == 1) show(plate);
        stria::test::try_crack(plate, seed, tally);
        stria::test::try_law(seed, tally);
        if (seed % bodies_one_in == 0) stria::test::try_body(seed, tally);
    }
    std::cout << fmt::format("{} cracks and metals, of the seeds from {}\n", trials, first);
    tally.print();
    return tally.clean() ? 0 : 1;
}
