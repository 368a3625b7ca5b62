#include "tests/stress/law_trials.hpp"

#include <cmath>
#include <fmt/format.h>

#include "common/error.hpp"
#include "fine/material/catalogue/material_catalogue.hpp"
#include "fine/material/hardening_curve.hpp"
#include "tests/stress/random_metal.hpp"
#include "tests/support/material_point.hpp"

namespace stria::test {
namespace {

/// Onwards, back, anywhere, or nowhere; from a thousandth of the yield strain to some hundreds of times as much.
std::vector<Mandel> random_path(Dice& dice) {
    std::vector<Mandel> path{1e-3 * Mandel(dice.between(-1.0, 1.0), 1.0, 0.0, dice.between(-1.0, 1.0))};
    while (path.size() < 40) {
        const Mandel anywhere = dice.decade(-6.0, -0.5) *
                                Mandel(dice.between(-1.0, 1.0), dice.between(-1.0, 1.0), 0.0, dice.between(-1.0, 1.0));
        const int kind = dice.below(8);
        path.push_back(kind == 0   ? Mandel(path.back())
                       : kind == 1 ? Mandel(-path.back())
                       : kind == 2 ? Mandel::Zero()
                                   : anywhere);
    }
    return path;
}

/// Overstress over the yield stress.
double overstress(const Law& law, const PointUpdate& now) {
    Mandel relative = now.stress();
    for (int k = 0; k < static_cast<int>(law.material.kinematic.size()); ++k)
        relative -= now.tensor(fine::state::back_stress + 4 * k);
    const double p = now.scalar(fine::state::accumulated);
    return von_mises(relative) / (*law.material.yield_stress + fine::HardeningCurve(law.material).value(p)) - 1.0;
}

struct Trial {
    const Law& law;
    unsigned seed;
    Tally& tally;
    std::string kind;

    void measure(const char* what, double value, double limit) const {
        tally.measure(fmt::format("{}, {}", what, kind), seed, value, limit);
    }
};

void look(const Trial& trial, const PointUpdate& before, const PointUpdate& now) {
    if (!trial.law.material.yield_stress) return;
    const double over = overstress(trial.law, now);
    trial.measure("yield surface", now.yields ? std::abs(over) : std::max(over, 0.0), 1e-8);
    const auto change = [&](int component) { return now.scalar(component) - before.scalar(component); };
    trial.measure("flow that is taken back", -std::min(change(fine::state::accumulated), 0.0), 0.0);
    trial.measure("dissipation that is given back",
                  -std::min(change(fine::state::dissipation), 0.0) /
                      (*trial.law.material.yield_stress + std::abs(now.scalar(fine::state::dissipation))),
                  1e-12);
    trial.measure("tangent that is not symmetric", (now.tangent - now.tangent.transpose()).norm(), 0.0);
}

void go_along(const Trial& trial, const std::vector<Mandel>& path, int substeps) {
    constexpr double smaller = 0x1p20;
    const auto law = fine::make_material_law(trial.law.material, trial.law.plane, substeps);
    const auto scaled = fine::make_material_law(in_units(trial.law.material, smaller), trial.law.plane, substeps);
    const std::vector<double> nothing(at(law->state_size()), 0.0);
    PointUpdate now{.state = nothing, .tangent = law->elastic(), .yields = false}, other = now;
    Mandel strain = Mandel::Zero();
    double way = 0.0, off = 0.0, in_other_units = 0.0;
    for (const Mandel& increment : path) {
        const PointUpdate before = now;
        now = update_point(*law, before.state, increment);
        other = update_point(*scaled, other.state, increment);
        strain += increment;
        way += increment.norm();
        look(trial, before, now);
        const double scale = law->elastic().norm() * way;
        const Mandel elastic =
            trial.law.material.yield_stress ? strain - now.tensor(fine::state::plastic_strain) : strain;
        off = std::max(off, (law->elastic() * elastic - now.stress()).norm() / scale);
        in_other_units = std::max(in_other_units, (other.stress() / smaller - now.stress()).norm() / scale);
    }
    trial.measure("stress of the elastic strain", off, 1e-9);
    trial.measure("stress, in other units", in_other_units, 1e-9);
}

}  // namespace

void try_law(unsigned seed, Tally& tally) {
    Dice dice(seed);
    const Law law = random_law(dice);
    const std::vector<Mandel> path = random_path(dice);
    for (const int substeps : {1, 4}) {
        const std::string kind = substeps == 1 ? "law at once" : "law in parts";
        try {
            go_along({law, seed, tally, kind}, path, substeps);
        } catch (const CaseError& error) {
            tally.refuse(error.what(), seed);
        } catch (const std::exception& error) {
            tally.fail(kind, seed, fmt::format("{}: {}", law.name, error.what()));
        }
    }
}

}  // namespace stria::test
