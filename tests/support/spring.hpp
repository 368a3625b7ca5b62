// An equilibrium of one equation: a spring that is pulled.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "coarse/equilibrium/equilibrium.hpp"
#include "common/case/case.hpp"
#include "common/error.hpp"

namespace stria::coarse {

/// A spring with the force f(u), pulled by the load factor. `scale`: of its residual.
class Spring : public Equilibrium {
public:
    std::function<double(double)> force = [](double x) { return x + x * x * x; };
    std::function<double(double)> stiffness = [](double x) { return 1.0 + 3.0 * x * x; };
    double scale = 1.0, interior = 0.0, contact = 0.0;
    double u = 0.0, start = 0.0;
    int applied = 0, parts = 0, looked = 0, provisional = 0;  // states that are
    int wakes_at = -1;                                        // number of the state, from 0
    int closed = 0;                                           // multipliers
    std::vector<int> changes;                                 // of status, of the states to come
    bool elastic = false;
    int elastic_states = 0;
    int yielding = 0, begun_apart = 0;
    bool parts_slowly = false;  // unless it begins apart: no state balances
    bool inside = false;        // its residual is one of the zone's
    double condensed = 1.0;     // what condensing makes of it

    void begin(const Target& target, const Predictor& predictor) override {
        load_ = target.value;
        u = start + predictor.factor;
        begun_apart += predictor.apart ? 1 : 0;
    }
    Residual linearise() override {
        residual_ = load_ - force(u);
        if (parts_slowly && begun_apart == 0) residual_ = 1.0;
        elastic_states += elastic ? 1 : 0;
        return {.boundary = condensed * std::abs(residual_),
                .nodal = std::abs(residual_),
                .interior = inside ? std::abs(residual_) : interior,
                .contact = contact,
                .scale = scale,
                .along = residual_ * correction_,
                .along_before = before_,
                .yielding_points = yielding,
                .closed = closed,
                .status_changes = next_changes(),
                .provisional = provisional-- > 0,
                .woken = wakes_at-- == 0};
    }
    double solve() override {
        correction_ = residual_ / stiffness(u);
        return std::abs(correction_) / std::max(std::abs(u), 1e-300);
    }
    void look_at_rest() override { ++looked; }
    void set_elastic(bool is) override { elastic = is; }
    void apply() override {
        before_ = residual_ * correction_;
        u += correction_;
        ++applied;
    }
    void apply_further(double part) override {
        u += part * correction_;
        ++parts;
    }
    void put_aside() override {}
    coupling::StepReport commit(const coupling::Commit&) override { return {}; }
    void rollback() override {}
    [[nodiscard]] LoadFactors factors() const override { return load_; }
    [[nodiscard]] const std::vector<std::int32_t>& yielding_points() const override { return none_; }
    [[nodiscard]] Eigen::VectorXd structure_displacement() const override { return {}; }
    [[nodiscard]] const Eigen::VectorXd& near_displacement() const override { return nothing_; }
    [[nodiscard]] MachineReading machine_reading() const override { return {}; }
    [[nodiscard]] EquilibriumState state() const override { return {}; }
    void restore(const EquilibriumState&) override {}

private:
    int next_changes() {
        if (changes.empty()) return 0;
        const int first = changes.front();
        changes.erase(changes.begin());
        return first;
    }

    std::vector<std::int32_t> none_;
    double load_ = 0.0, residual_ = 0.0, correction_ = 0.0, before_ = 0.0;
    Eigen::VectorXd nothing_;
};

inline const SolverSection solver{.tolerance = 1e-10, .max_iterations = 12, .max_cuts = 8};

}  // namespace stria::coarse
