// A fine scale of linear springs: one from each boundary unknown to ground and one between neighbours.
#pragma once

#include <stdexcept>
#include <utility>

#include "common/error.hpp"
#include "coupling/fine_scale.hpp"

namespace stria::test {

class FakeFineScale final : public coupling::FineScale {
public:
    explicit FakeFineScale(double stiffness = 1.0) : stiffness_(stiffness) {}

    /// What the next call does instead of its work.
    enum class Trouble { None, Numerical, Case, Bug } trouble = Trouble::None;

    int fails_in_rollback = 0;  // number of the call of rollback() that fails; 0: none
    int commits = 0, rollbacks = 0, reversals = 0;

    void set_patch(const coupling::Patch& patch) override {
        fail_if_told();
        const auto n = static_cast<Eigen::Index>(patch.boundary.size());
        tangent_ = Eigen::MatrixXd::Zero(n, n);
        for (Eigen::Index i = 0; i < n; ++i) {
            tangent_(i, i) += stiffness_ / static_cast<double>(i + 3);
            if (i > 0) connect(i - 1, i);
        }
        committed_ = trial_ = Eigen::VectorXd::Zero(n);
    }

    void request(const coupling::PatchDisplacement& displacement) override {
        trial_ = displacement.boundary;
        iteration_ = displacement.iteration;
    }

    coupling::PatchResponse collect() override {
        fail_if_told();
        coupling::PatchResponse response;
        response.force = tangent_ * trial_;
        response.tangent = {tangent_};
        response.interior_force = response.force.size() > 0 ? response.force.lpNorm<Eigen::Infinity>() : 0.0;
        response.interior_displacement = trial_.size() > 0 ? trial_.lpNorm<Eigen::Infinity>() : 0.0;
        response.digest.yielding_points = {iteration_, 0, 3};
        response.digest.status_changes = 1;
        return response;
    }

    coupling::StepReport commit(const coupling::Commit& what) override {
        fail_if_told();
        committed_ = trial_;
        ++commits;
        reversals += what.reversal ? 1 : 0;
        coupling::StepReport report;
        report.dissipation = 0.1 * commits;
        report.unknowns = trial_.size();
        return report;
    }

    void rollback() override {
        fail_if_told();
        trial_ = committed_;
        if (++rollbacks == fails_in_rollback) throw NumericalFailure("a spring broke");
    }

    coupling::ZoneState state() override {
        fail_if_told();
        coupling::ZoneState state;
        state.displacement = committed_;
        return state;
    }

    coupling::ZoneSnapshot snapshot() override {
        fail_if_told();
        coupling::ZoneSnapshot snapshot;
        snapshot.displacement = committed_;
        return snapshot;
    }

    void restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) override {
        set_patch(patch);
        committed_ = trial_ = snapshot.displacement;
    }

private:
    void connect(Eigen::Index i, Eigen::Index j) {
        const double spring = 0.7 * stiffness_ / static_cast<double>(j);
        tangent_(i, i) += spring;
        tangent_(j, j) += spring;
        tangent_(i, j) -= spring;
        tangent_(j, i) -= spring;
    }

    void fail_if_told() {
        switch (std::exchange(trouble, Trouble::None)) {
        case Trouble::None:
            return;
        case Trouble::Numerical:
            throw NumericalFailure("a spring broke");
        case Trouble::Case:
            throw CaseError("case.toml:3: a spring of no steel");
        case Trouble::Bug:
            throw std::logic_error("a bug");
        }
    }

    double stiffness_;
    int iteration_ = 0;
    Eigen::MatrixXd tangent_;
    Eigen::VectorXd committed_, trial_;
};

}  // namespace stria::test
