// One material point driven on its own: strain increments, or uniaxial and plane stress histories by Newton's method.
#pragma once

#include <Eigen/LU>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <stdexcept>
#include <vector>

#include "common/index.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"

namespace stria::test {

/// A yield stress in MPa, linear isotropic hardening, and linear back stresses of these moduli.
inline MaterialSection linear_hardening(double yield_stress, double isotropic = 0.0,
                                        const std::vector<double>& kinematic = {}) {
    MaterialSection section{.young = 200e3,
                            .poisson = 0.3,
                            .yield_stress = yield_stress,
                            .isotropic = {.law = HardeningLaw::Linear, .modulus = isotropic},
                            .kinematic = {}};
    for (const double C : kinematic) section.kinematic.push_back({C, 0.0});
    return section;
}

struct PointUpdate {
    std::vector<double> state;
    MandelMatrix tangent;
    bool yields;

    [[nodiscard]] Mandel tensor(int c) const { return {scalar(c), scalar(c + 1), scalar(c + 2), scalar(c + 3)}; }
    [[nodiscard]] Mandel stress() const { return tensor(fine::state::stress); }
    /// Zero where the law stores no such component.
    [[nodiscard]] double scalar(int component) const {
        const auto place = at(component);
        return place < state.size() ? state[place] : 0.0;
    }
};

inline PointUpdate update_point(const fine::MaterialLaw& law, const std::vector<double>& committed,
                                const Mandel& strain_increment) {
    PointUpdate update{.state = std::vector<double>(committed.size()), .tangent = {}, .yields = false};
    Eigen::Matrix<double, 4, 4, Eigen::RowMajor> tangent;
    unsigned char yields = 0;
    law.update(1, 1, strain_increment.data(), committed.data(), update.state.data(), tangent.data(), &yields);
    update.tangent = law.can_yield() ? MandelMatrix(tangent) : law.elastic();
    update.yields = yields != 0;
    return update;
}

class MaterialPoint {
public:
    explicit MaterialPoint(const MaterialSection& material, PlaneState plane = PlaneState::Strain)
        : law_(fine::make_material_law(material, plane)),
          plane_(plane), last_{.state = std::vector<double>(at(law_->state_size()), 0.0),
                               .tangent = law_->elastic(),
                               .yields = false} {}

    const PointUpdate& strain_by(const Mandel& increment) {
        last_ = update_point(*law_, last_.state, increment);
        strain_ += increment;
        return last_;
    }

    /// Brings the strain component `driven` to `value` while the stress components `free` vanish; the others stay.
    const PointUpdate& drive(int driven, double value, std::initializer_list<int> free) {
        const std::vector<int> unknown(free);
        Mandel increment = Mandel::Zero();
        increment[driven] = value - strain_[driven];
        for (int iteration = 0; iteration < 50; ++iteration) {
            const PointUpdate trial = update_point(*law_, last_.state, increment);
            const Eigen::VectorXd residual = trial.stress()(unknown);
            if (residual.norm() <= 1e-10 * (1.0 + trial.stress().norm())) return strain_by(increment);
            increment(unknown) -= trial.tangent(unknown, unknown).partialPivLu().solve(residual);
        }
        throw std::runtime_error("material point: lateral strains not found");
    }

    /// Uniaxial stress along yy: its value at the strain `value`.
    double uniaxial(double value) {
        if (plane_ == PlaneState::Stress) return drive(1, value, {0}).stress()[1];
        return drive(1, value, {0, 2}).stress()[1];
    }

    [[nodiscard]] const PointUpdate& last() const { return last_; }
    [[nodiscard]] const fine::MaterialLaw& law() const { return *law_; }

private:
    std::unique_ptr<fine::MaterialLaw> law_;
    PlaneState plane_;
    PointUpdate last_;
    Mandel strain_ = Mandel::Zero();
};

}  // namespace stria::test
