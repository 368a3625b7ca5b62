#include "app/material/cyclic_test.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>

#include "app/material/driven_point.hpp"
#include "coarse/load/load_history.hpp"
#include "common/error.hpp"
#include "common/index.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"
#include "fine/material/hardening_curve.hpp"

namespace stria::material {

namespace {

namespace state = fine::state;

constexpr int xx = 0, yy = 1, zz = 2, xy = 3;

/// Which component the test drives, and how what it drives is counted: gamma = sqrt(2) times Mandel's shear strain, tau
/// its shear stress over sqrt(2).
class Loading {
public:
    Loading(const MaterialTestSection& test, PlaneState plane) : test_(test), plane_(plane) {}

    [[nodiscard]] Targets at(double value) const {
        const bool by_strain = test_.control == TestControl::Strain;
        Targets targets;
        targets[stria::at(driven())] = {by_strain ? Target::Of::Strain : Target::Of::Stress,
                                        by_strain ? value / strain_scale() : value / stress_scale()};
        if (test_.mode == TestMode::Shear) return targets;  // nothing else would follow
        targets[xx].of = Target::Of::Stress;
        // In plane stress there is none through the thickness in any case.
        if (test_.mode == TestMode::Uniaxial && plane_ == PlaneState::Strain) targets[zz].of = Target::Of::Stress;
        return targets;
    }

    [[nodiscard]] double strain(const Mandel& strain) const { return strain_scale() * strain[driven()]; }
    [[nodiscard]] double stress(const Mandel& stress) const { return stress_scale() * stress[driven()]; }
    /// Of stresses that go with a flow of the metal, pulled or sheared.
    [[nodiscard]] double back_stress(const Mandel& X) const {
        return test_.mode == TestMode::Shear ? stress(X) : X[yy] - X[xx];
    }

private:
    [[nodiscard]] int driven() const { return test_.mode == TestMode::Shear ? xy : yy; }
    [[nodiscard]] double strain_scale() const { return test_.mode == TestMode::Shear ? std::numbers::sqrt2 : 1.0; }
    [[nodiscard]] double stress_scale() const { return 1.0 / strain_scale(); }

    const MaterialTestSection& test_;
    PlaneState plane_;
};

class CyclicTest {
public:
    explicit CyclicTest(const Case& input)
        : test_(*input.material_test), material_(input.material), curve_(input.material),
          law_(fine::make_material_law(input.material, input.model.plane, input.fine.substeps)), point_(*law_),
          loading_(test_, input.model.plane) {}

    std::vector<TestRow> rows() {
        note(0, true);
        const int half = test_.steps / 2;
        for (const coarse::Leg& leg : coarse::legs({.blocks = test_.blocks})) {
            for (int k = 1; k <= half; ++k) {
                go_to(k == half ? leg.to : leg.from + (leg.to - leg.from) * k / half, leg.cycle);
                note(leg.cycle, k == half && (leg.ends_cycle || leg.cycle == 0));
            }
        }
        return std::move(rows_);
    }

private:
    void go_to(double value, int cycle) {
        try {
            point_.reach(loading_.at(value));
        } catch (const NumericalFailure& failure) {
            const char* what = test_.control == TestControl::Stress ? "stress" : "strain";
            throw NumericalFailure(
                fmt::format("material test, cycle {}, {} {:.6g}: {}", cycle, what, value, failure.what()));
        }
    }

    void note(int cycle, bool ends_cycle) {
        double back_stress = 0.0;
        for (std::size_t k = 0; k < material_.kinematic.size(); ++k)
            back_stress += loading_.back_stress(point_.tensor(state::back_stress + 4 * static_cast<int>(k)));
        const double p = point_.scalar(state::accumulated);
        rows_.push_back({.increment = static_cast<int>(rows_.size()),
                         .cycle = cycle,
                         .strain = loading_.strain(point_.strain()),
                         .stress = loading_.stress(point_.tensor(state::stress)),
                         .plastic_strain = loading_.strain(point_.tensor(state::plastic_strain)),
                         .back_stress = back_stress,
                         .yield_stress = *material_.yield_stress + curve_.value(p),
                         .accumulated = p,
                         .work = point_.scalar(state::work),
                         .stored = point_.stored_energy(),
                         .dissipation = point_.scalar(state::dissipation),
                         .ends_cycle = ends_cycle});
    }

    const MaterialTestSection& test_;
    const MaterialSection& material_;
    fine::HardeningCurve curve_;
    std::unique_ptr<fine::MaterialLaw> law_;
    DrivenPoint point_;
    Loading loading_;
    std::vector<TestRow> rows_;
};

CycleSummary summary_of(std::span<const TestRow> cycle) {
    const auto extremes = [&](double TestRow::*value) {
        const auto [least, most] = std::ranges::minmax_element(cycle, {}, value);
        return std::pair{(*least).*value, (*most).*value};
    };
    const auto [strain_min, strain_max] = extremes(&TestRow::strain);
    const auto [stress_min, stress_max] = extremes(&TestRow::stress);
    const auto [plastic_min, plastic_max] = extremes(&TestRow::plastic_strain);
    const TestRow &first = cycle.front(), &last = cycle.back();
    return {.cycle = last.cycle,
            .strain_max = strain_max,
            .strain_min = strain_min,
            .stress_max = stress_max,
            .stress_min = stress_min,
            .plastic_range = plastic_max - plastic_min,
            .ratchet = last.plastic_strain - first.plastic_strain,
            .dissipation = last.dissipation - first.dissipation,
            .stored = last.stored - first.stored};
}

}  // namespace

std::vector<TestRow> go_through_cycles(const Case& input) {
    if (!input.material.yield_stress)
        throw CaseError("material.yield_stress is missing: an elastic material has no loop");
    if (!input.material_test)
        throw CaseError("material_test is missing, for instance "
                        "--set 'material_test.blocks=[{cycles=10, max=0.01, ratio=-1}]'");
    return CyclicTest(input).rows();
}

std::vector<CycleSummary> summaries(std::span<const TestRow> rows) {
    std::vector<CycleSummary> all;
    std::size_t begin = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        if (!rows[k].ends_cycle) continue;
        if (rows[k].cycle > 0) all.push_back(summary_of(rows.subspan(begin, k - begin + 1)));
        begin = k;
    }
    return all;
}

}  // namespace stria::material
