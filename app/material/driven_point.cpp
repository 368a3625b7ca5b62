#include "app/material/driven_point.hpp"

#include <Eigen/LU>

#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::material {

namespace {

constexpr int most_iterations = 30, most_halvings = 12;

std::vector<int> told_by_stress(const Targets& targets) {
    std::vector<int> components;
    for (int c = 0; c < 4; ++c)
        if (targets[at(c)].of == Target::Of::Stress) components.push_back(c);
    return components;
}

}  // namespace

DrivenPoint::DrivenPoint(const fine::MaterialLaw& law) : law_(law), state_(at(law.state_size()), 0.0) {}

void DrivenPoint::reach(const Targets& targets) { reach(targets, most_halvings); }

void DrivenPoint::reach(const Targets& targets, int halvings_left) {
    if (reach_at_once(targets)) return;
    if (halvings_left == 0) throw NumericalFailure("no strain bears the stress");
    reach(half_way(targets), halvings_left - 1);
    reach(targets, halvings_left - 1);
}

Targets DrivenPoint::half_way(const Targets& targets) const {
    const Mandel stress = tensor(fine::state::stress);
    Targets half = targets;
    for (int c = 0; c < 4; ++c) {
        const double now = targets[at(c)].of == Target::Of::Strain ? strain_[c] : stress[c];
        half[at(c)].value = 0.5 * (now + targets[at(c)].value);
    }
    return half;
}

bool DrivenPoint::reach_at_once(const Targets& targets) {
    const std::vector<int> free = told_by_stress(targets);
    Mandel increment = Mandel::Zero(), wanted = Mandel::Zero();
    for (int c = 0; c < 4; ++c) {
        wanted[c] = targets[at(c)].value;
        if (targets[at(c)].of == Target::Of::Strain) increment[c] = wanted[c] - strain_[c];
    }
    std::vector<double> trial(state_.size());
    Eigen::Matrix<double, 4, 4, Eigen::RowMajor> tangent = law_.elastic();
    unsigned char flows = 0;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        if (!(increment.norm() < 1.0)) return false;
        law_.update(1, 1, increment.data(), state_.data(), trial.data(), tangent.data(), &flows);
        const Mandel stress = fine::tensor_at(trial.data(), 1, fine::state::stress);
        const Eigen::VectorXd residual = (stress - wanted)(free);
        if (residual.norm() <= 1e-11 * (1.0 + stress.norm())) {
            strain_ += increment;
            state_ = trial;
            return true;
        }
        increment(free) -= tangent(free, free).partialPivLu().solve(residual);
    }
    return false;
}

}  // namespace stria::material
