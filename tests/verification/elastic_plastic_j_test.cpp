// J of specimens that harden, at half and at nine tenths of their limit load, against the same on finer meshes, and its
// spread over rings inside and outside the plastic zone (docs/references.md 3.5). A table is printed.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>
#include <iostream>

#include "coarse/specimen/handbook.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

constexpr double crack_length = 0.5, plate_width = 1.0;        // mm
constexpr double sigma_0 = 400.0, hardening_modulus = 4000.0;  // MPa

struct Hardening {
    std::string specimen;
    bool kinematic;
};

/// Elements of the size `ligament / at_tip` at the tip, growing from there. docs/references.md 3.3 has the limit loads.
Case loaded_specimen(const Hardening& of, double at_tip) {
    const bool ct = of.specimen == "ct";
    Case input = ct ? compact_tension(crack_length) : edge_crack(crack_length, 3.0, End::Pulled);
    const double ligament = plate_width - crack_length, h = ligament / at_tip;
    input.mesh.size = std::min(0.1, 8.0 / at_tip);
    input.mesh.grading = {
        {.at = {input.cracks[0].points[1]}, .size = h, .outer_size = h, .radius = 2.0 * h, .growth = 10.0 / at_tip}};
    input.material.yield_stress = sigma_0;
    if (of.kinematic)
        input.material.kinematic = {{.C = hardening_modulus, .gamma = 0.0}};
    else
        input.material.isotropic.modulus = hardening_modulus;
    input.fine.radius = ligament;
    // The specimens bear 1 N/mm at the load factor 1.
    const double limit =
        (ct ? coarse::ct_limit_load : coarse::sent_limit_load)(plate_width, crack_length, sigma_0, PlaneState::Strain);
    input.load = {.steps = 36,
                  .grading = 1.0,
                  .blocks = {{.cycles = 0, .max = 0.9 * limit, .min = 0.0}},
                  .control = Control::Load};
    return input;
}

/// At 0.5 and 0.9 of the limit load.
std::array<coarse::TipResult, 2> tips_at_loads(const Hardening& of, double at_tip) {
    const RunHistory run = run_direct(loaded_specimen(of, at_tip));
    EXPECT_EQ(run.increments.size(), 18U);
    EXPECT_NEAR(run.increments[9].load_factor / run.increments[17].load_factor, 5.0 / 9.0, 1e-12);
    const std::array<coarse::TipResult, 2> tips{run.increments[9].tips[0], run.increments[17].tips[0]};
    std::cout << fmt::format("{:4s} {:9s}  ligament / h at tip {:3.0f}", of.specimen,
                             of.kinematic ? "kinematic" : "isotropic", at_tip);
    for (const coarse::TipResult& tip : tips) {
        std::cout << fmt::format("   J / (sigma_y W) {:.4e}  spread {:.4f}  zone {:.3f} W",
                                 tip.J / sigma_0 / plate_width, tip.J_spread, tip.plastic_zone / plate_width);
    }
    std::cout << '\n';
    return tips;
}

void expect_settled(const Hardening& of, double at_tip, double finer) {
    const auto own = tips_at_loads(of, at_tip), reference = tips_at_loads(of, finer);
    for (const std::size_t load : {0, 1}) {
        EXPECT_NEAR(own[load].J, reference[load].J, 0.01 * reference[load].J) << of.specimen << load;
        EXPECT_LT(own[load].J_spread, 0.01) << of.specimen << load;
    }
}

TEST(ElasticPlasticJ, IsSettledOnAModerateMesh) { expect_settled({"ct", false}, 50.0, 100.0); }

TEST(ElasticPlasticJ, IsThatOfFinerMeshesLong) {
    for (const char* specimen : {"ct", "sent"})
        for (const bool kinematic : {false, true}) expect_settled({specimen, kinematic}, 100.0, 200.0);
}

}  // namespace
}  // namespace stria::test
