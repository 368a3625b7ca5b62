// The parts in which a strain increment is returned: what is elastic of it at once, and the rest in as many as the
// error bound asks for.
#pragma once

#include <algorithm>

#include "fine/material/implicit/j2_return.hpp"
#include "fine/material/implicit/with_slope.hpp"

namespace stria::fine {

/// All parts of a pack are counted together: a point that needs fewer takes parts of nothing at the end. Shares of the
/// increment are smooth in it, so that the stress is too: of 2.3 parts the third is 0.3 times as large as the others.
template <int rows> class PartsOfIncrement {
public:
    /// `elastic`: deviatoric elastic stress of the whole increment, by which slopes are, MPa. `flows`: what flows in
    /// it.
    PartsOfIncrement(const J2Parameters& parameters, const ReturnLaw& law, const PackState<rows>& before,
                     const Deviators<rows>& elastic, const Mask<rows>& flows)
        : elastic_(Scalars<rows>::Ones()), parts_(Scalars<rows>::Ones()) {
        const Path path(parameters, before, elastic);
        elastic_ = chosen<rows>(flows, path.elastic, elastic_);
        put_parts(std::pow(parameters.error_of_parts(), -2.0) * squared_error(law, before, path),
                  most(parameters, path), flows);
    }

    /// The share before the yield surface is reached.
    [[nodiscard]] const WithSlope<rows>& elastic() const { return elastic_; }

    [[nodiscard]] int count() const { return static_cast<int>(std::ceil(parts_.value.maxCoeff())); }

    /// The share of part k = 0, 1, ...
    [[nodiscard]] WithSlope<rows> part(int k) const {
        const WithSlope<rows> one(Scalars<rows>::Ones()), none(Scalars<rows>::Zero());
        const WithSlope<rows> whole = one / parts_, last = one - static_cast<double>(k) * whole;
        const WithSlope<rows> size = chosen<rows>(parts_.value >= k + 1.0, whole, last);
        return chosen<rows>(parts_.value > k, (one - elastic_) * size, none);
    }

private:
    /// From the relative stress before, along a straight line: to the yield surface, and on to the trial stress.
    struct Path {
        Scalars<rows> radius;
        WithSlope<rows> elastic{Scalars<rows>::Zero()};
        DeviatorWithSlope<rows> reached, trial;

        Path(const J2Parameters& law, const PackState<rows>& before, const Deviators<rows>& d)
            : radius(std::sqrt(2.0 / 3.0) * (law.yield_stress + law.isotropic.value(before.p))),
              reached(fixed<rows>(before.stress)), trial(varied<rows>(d)) {
            for (const Deviators<rows>& X : before.back) reached = reached - fixed<rows>(X);
            const WithSlope<rows> DD = dot(trial, trial), S = dot(reached, trial), xi2 = dot(reached, reached);
            const WithSlope<rows> inside((radius * radius - xi2.value).max(0.0));
            const WithSlope<rows> qq = S * S + DD * inside;
            // Along the surface, or not at all: nothing is elastic.
            const Mask<rows> across = qq.value > 1e-24 * radius * radius * DD.value;
            const WithSlope<rows> one(Scalars<rows>::Ones()), none(Scalars<rows>::Zero());
            const WithSlope<rows> q = sqrt(chosen<rows>(across, qq, one));
            const Mask<rows> outwards = S.value > 0.0;
            const WithSlope<rows> share =
                chosen<rows>(outwards, inside, q - S) / chosen<rows>(outwards, q + S, chosen<rows>(across, DD, one));
            elastic = chosen<rows>(across, share, none);
            const DeviatorWithSlope<rows> start = reached;
            reached = start + elastic * trial;
            trial = start + trial;
        }
    };

    /// Of backward Euler in one step, over the yield stress, squared: half of what the rate of flow, of the stress and
    /// of back stresses, changes by. The direction at the end is guessed from elasticity alone.
    static WithSlope<rows> squared_error(const ReturnLaw& law, const PackState<rows>& before, const Path& path) {
        const WithSlope<rows> one(Scalars<rows>::Ones()), per_radius(1.0 / path.radius);
        const WithSlope<rows> beyond = sqrt(dot(path.trial, path.trial)) * per_radius - one;
        const double fastest = law.first_rates.maxCoeff();
        DeviatorWithSlope<rows> end = path.trial;
        for (int i = 0; i < 3; ++i)
            end[stria::at(i)] = end[stria::at(i)] / (one + (law.first_rates[i] / fastest) * beyond);
        end = (one / sqrt(dot(end, end))) * end;
        const DeviatorWithSlope<rows> turn = end - per_radius * path.reached;
        const DeviatorWithSlope<rows> of_stress = (0.5 * beyond) * turn;
        const WithSlope<rows> dp = std::sqrt(2.0 / 3.0) / fastest * (beyond * WithSlope<rows>(path.radius));
        const WithSlope<rows> per(0.5 / path.radius), grown = std::sqrt(2.0 / 3.0) * dp;
        double linear = 0.0;
        for (const double C : law.linear_C) linear += C * C;
        WithSlope<rows> sum = dot(of_stress, of_stress);
        if (linear > 0.0) sum = sum + linear * (per * per * grown * grown * dot(turn, turn));
        for (std::size_t k = 0; k < law.recalling.size(); ++k) {
            const DeviatorWithSlope<rows> lag = lag_of(law.recalling[k], before.back[k], dp, end, turn);
            sum = sum + per * per * dot(lag, lag);
        }
        return sum;
    }

    /// What the increment of a back stress changes by between the start and the end of it.
    static DeviatorWithSlope<rows> lag_of(const KinematicHardening& term, const Deviators<rows>& X,
                                          const WithSlope<rows>& dp, const DeviatorWithSlope<rows>& end,
                                          const DeviatorWithSlope<rows>& turn) {
        const double root = std::sqrt(2.0 / 3.0), C = std::max(term.C, term.C_start.value_or(0.0));
        const WithSlope<rows> grown = (root * C) * dp, one(Scalars<rows>::Ones());
        if (term.gamma == 0.0 || term.threshold) return grown * turn;
        const WithSlope<rows> recalled = term.gamma * dp, lost = (term.gamma + term.C_rate) * dp;
        return (lost / (one + lost)) * (grown * end - recalled * fixed<rows>(X));
    }

    /// As many parts as there may be. Where an increment is many radii of the yield surface long its flow has long
    /// turned: a part of x radii leaves (1 - (1 - 2 a) x) / (1 + a x)^2 of the angle, a as in Alexander's method, for
    /// all x > 2 no more than a fifth of it, and eight parts nothing that counts. What recall lags by fades more
    /// slowly.
    static WithSlope<rows> most(const J2Parameters& law, const Path& path) {
        constexpr double long_increment = 10.0;  // radii
        const WithSlope<rows> all(Scalars<rows>::Constant(5.0 * law.substeps));
        const bool recalls = std::ranges::any_of(law.kinematic, [](const auto& term) { return term.gamma != 0.0; });
        if (recalls) return all;
        const WithSlope<rows> length = sqrt(dot(path.trial, path.trial)) * WithSlope<rows>(1.0 / path.radius);
        const WithSlope<rows> fewer = long_increment * (all / length),
                              least(Scalars<rows>::Constant(2.0 * law.substeps));
        const WithSlope<rows> most = chosen<rows>(fewer.value > least.value, fewer, least);
        return chosen<rows>(length.value > long_increment, most, all);
    }

    /// `error`: squared, over the bound. Backward Euler needs its root as parts; a method of second order, which starts
    /// on the yield surface, needs the root of that (unit.*EveryLawInParts.*).
    void put_parts(const WithSlope<rows>& error, const WithSlope<rows>& most, const Mask<rows>& flows) {
        const Mask<rows> several = flows && error.value > 1.0, too_many = !(error.value < most.value.pow(4));
        parts_ = sqrt(sqrt(chosen<rows>(several, error, parts_)));
        parts_ = chosen<rows>(several && too_many, most, parts_);
    }

    WithSlope<rows> elastic_, parts_;
};

}  // namespace stria::fine
