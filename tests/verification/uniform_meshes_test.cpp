// Rates of convergence of the specimens' stress intensities on uniform meshes, against our own on the finest.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <functional>
#include <iostream>

#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

struct Specimen {
    std::string name;
    std::function<Case()> make;
};

coarse::TipResult solved(Case input, int across) {
    input.mesh.size = (input.mesh.specimen == "ct" ? 1.25 : 1.0) / across;
    return ElasticSolution(input).tips.front();
}

class UniformMeshes : public ::testing::TestWithParam<Specimen> {};

TEST_P(UniformMeshes, ConvergeLong) {
    const double K = solved(GetParam().make(), 321).K_I;
    double before = 0.0;
    int last = 0;
    for (const int across : {11, 21, 41, 81}) {
        const coarse::TipResult tip = solved(GetParam().make(), across);
        const double error = std::abs(tip.K_I / K - 1.0);
        std::cout << fmt::format("uniform {}, {:2d} across: K_I {:+.3f} %, by J {:+.3f} %, rate {:.2f}\n",
                                 GetParam().name, across, 100.0 * (tip.K_I / K - 1.0),
                                 100.0 * (std::sqrt(tip.J * plane_modulus) / K - 1.0),
                                 last > 0 ? std::log(before / error) / std::log(double(across) / last) : 0.0);
        if (across >= 41) {
            EXPECT_LT(error, GetParam().name.starts_with("ct") ? 0.01 : 0.003);
        }
        before = error;
        last = across;
    }
}

INSTANTIATE_TEST_SUITE_P(Specimens, UniformMeshes,
                         ::testing::Values(Specimen{"sent a/W 0.3", [] { return edge_crack(0.3, 2.0, End::Pulled); }},
                                           Specimen{"sent a/W 0.5", [] { return edge_crack(0.5, 2.0, End::Pulled); }},
                                           Specimen{"sent a/W 0.7", [] { return edge_crack(0.7, 2.0, End::Pulled); }},
                                           Specimen{"ct a/W 0.5", [] { return compact_tension(0.5); }},
                                           Specimen{"mt 2a/W 0.5", [] { return middle_crack(0.5, 2.0); }}),
                         [](const auto& test) { return test_name(test.param.name); });

}  // namespace
}  // namespace stria::test
