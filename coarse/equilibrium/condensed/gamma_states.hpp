// What is committed on Gamma, what Newton's method tries, and the increments that led here.
#pragma once

#include <Eigen/Core>
#include <deque>

#include "coarse/load/load_factors.hpp"
#include "common/predictor.hpp"

namespace stria::coarse {

/// Displacements of places on Gamma, mm, and load factors.
struct GammaState {
    Eigen::VectorXd displacement;
    double load_factor = 0.0;
    Eigen::VectorXd cases = {};  // of a state

    [[nodiscard]] LoadFactors factors() const { return {load_factor, cases}; }
};

class GammaStates {
public:
    /// `remembered`: increments to predict from, at the most.
    GammaStates(GammaState committed, std::size_t remembered);

    [[nodiscard]] const GammaState& committed() const { return committed_; }
    [[nodiscard]] const GammaState& trial() const { return trial_; }
    [[nodiscard]] GammaState& trial() { return trial_; }

    /// Trial = what the predictor says, at these factors of the load cases.
    void begin(const Predictor& predictor, const Eigen::VectorXd& cases);

    /// The way to the trial state is remembered until the next commit().
    void put_aside();
    void commit();
    void rollback() { trial_ = committed_; }

    /// Those remembered, the last one first.
    [[nodiscard]] const std::deque<GammaState>& increments() const { return increments_.all(); }
    void restore(GammaState committed, const std::deque<GammaState>& increments);

private:
    [[nodiscard]] GammaState increment() const;

    GammaState committed_, trial_;
    IncrementMemory<GammaState> increments_;
};

}  // namespace stria::coarse
