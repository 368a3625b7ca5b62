// Several fine components beside one that does the same work alone.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

#include "coupling/ranks/fine_ranks.hpp"
#include "fine/zone/fine_model.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {

struct Team {
    Team(const Case& input, int ranks) {
        std::vector<coupling::FineScale*> each;
        for (int k = 0; k < ranks; ++k) {
            models.push_back(std::make_unique<fine::FineModel>(input));
            each.push_back(models.back().get());
        }
        together = std::make_unique<coupling::FineRanks>(each, 10);
    }
    std::vector<std::unique_ptr<fine::FineModel>> models;
    std::unique_ptr<coupling::FineRanks> together;
};

inline coupling::PatchResponse answer(coupling::FineScale& fine, int iteration, const Eigen::VectorXd& boundary,
                                      const Predictor& predictor = {}) {
    fine.request({.iteration = iteration, .predictor = predictor, .load_factor = 1.0, .boundary = boundary});
    return fine.collect();
}

inline double difference(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return (a - b).norm() / b.norm(); }

/// Accumulated plastic strain and stress of all points, whatever their order.
inline std::vector<std::array<double, 4>> points_of(const coupling::ZoneState& state) {
    std::vector<std::array<double, 4>> points;
    for (std::size_t q = 0; q < state.x.size(); ++q)
        points.push_back({state.x[q], state.y[q], state.accumulated[q], state.stress[4 * q]});
    std::ranges::sort(points);
    return points;
}

/// A plate that flows, with a crack that ends in its middle.
class FineRanks : public testing::TestWithParam<int> {
protected:
    static Case one_crack() { return plate_case({{0.0, 4.4}, {5.6, 4.4}}); }
    explicit FineRanks(const Case& of = one_crack()) : input(of) {}

    [[nodiscard]] Eigen::VectorXd boundary(double size, unsigned seed) const {
        return random_vector(std::ssize(patch.boundary), size, seed);
    }
    Case input;
    coupling::Patch patch = plate_patch(plate_mesh(11, 9, one_crack()));
    Team team{input, GetParam()};
    fine::FineModel one{input};
};

}  // namespace stria::test
