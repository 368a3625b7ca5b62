// One material point whose strains and stresses are told, a strain or a stress for each component.
#pragma once

#include <array>
#include <vector>

#include "fine/material/material_law.hpp"

namespace stria::material {

/// What one component is brought to: a strain, or a stress in MPa. Shears are those of Mandel's form, sqrt(2) times the
/// tensor's.
struct Target {
    enum class Of { Strain, Stress } of = Of::Strain;
    double value = 0.0;
};

using Targets = std::array<Target, 4>;  // xx, yy, zz, xy

class DrivenPoint {
public:
    /// A virgin point; the law must outlive it.
    explicit DrivenPoint(const fine::MaterialLaw& law);

    /// In one increment where Newton's method finds the strains of the given stresses, else in two, and so on. Throws
    /// NumericalFailure where none is small enough: the material does not bear these stresses.
    void reach(const Targets& targets);

    [[nodiscard]] const Mandel& strain() const { return strain_; }
    [[nodiscard]] Mandel tensor(int component) const { return fine::tensor_at(state_.data(), 1, component); }
    [[nodiscard]] double scalar(int component) const { return state_[static_cast<std::size_t>(component)]; }
    [[nodiscard]] double stored_energy() const { return law_.stored_energy(state_.data(), 1); }

private:
    void reach(const Targets& targets, int halvings_left);
    /// False where it found no strains; then nothing has changed.
    bool reach_at_once(const Targets& targets);
    [[nodiscard]] Targets half_way(const Targets& targets) const;

    const fine::MaterialLaw& law_;
    Mandel strain_ = Mandel::Zero();
    std::vector<double> state_;
};

}  // namespace stria::material
