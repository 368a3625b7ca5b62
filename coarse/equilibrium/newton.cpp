#include "coarse/equilibrium/newton.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <utility>

#include "coarse/equilibrium/line_search.hpp"
#include "common/error.hpp"

namespace stria::coarse {

std::string NewtonReport::table() const {
    std::string text =
        "   it   residual    boundary    interior     contact      target  correction  yielding  closed  changes\n";
    const auto add = [&](const std::vector<NewtonIteration>& rows) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto& [r, correction] = rows[i];
            text += fmt::format("{:5} {:10.3e} {:11.3e} {:11.3e} {:11.3e} {:11.3e} {:11.3e} {:9} {:7} {:8}\n", i,
                                r.largest() / r.scale, r.boundary, r.interior, r.contact, r.target, correction,
                                r.yielding_points, r.closed, r.status_changes);
        }
    };
    add(lost);
    add(iterations);
    return text;
}

namespace {

/// Newton's method leads nowhere from where the predictor said: after some iterations it is as far off as at first, or
/// as far as it might be from nothing. Judged by what the nodes feel: condensing makes more of the same state, by how
/// much it is out of balance inside, so that one mode would give up a start that another one stays with.
bool is_misled(const NewtonReport& report) {
    constexpr std::size_t enough = 4;
    if (report.iterations.size() != enough) return false;
    const Residual &first = report.iterations.front().residual, &last = report.iterations.back().residual;
    return !(last.largest_nodal() < std::min(first.largest_nodal(), 0.1 * last.scale));
}

/// Where a residual is as small as rounding for the second time, and neither it nor the correction falls any more, what
/// is left of both is rounding: near a limit load the body answers to next to no force with a large displacement.
class LeftToRounding {
public:
    [[nodiscard]] bool is(const Residual& residual, double correction) {
        constexpr double rounding = 1e-11;  // of the forces that balance
        if (!residual.within(rounding)) return false;
        const bool is = residual.largest() >= 0.5 * residual_ && correction >= 0.5 * correction_;
        residual_ = residual.largest();
        correction_ = correction;
        return is;
    }

private:
    // Where the residual was as small last.
    double residual_ = std::numeric_limits<double>::infinity(), correction_ = residual_;
};

/// Where nothing is known of an increment in which closed faces open, they come to rest on elastic metal first.
/// Newton's first correction keeps them closed, and the metal that this stretches flows: what follows is far from a
/// state which may even be elastic.
class ContactFirst {
public:
    explicit ContactFirst(bool may_be) : may_be_(may_be) {}

    /// With each state in turn: whether it is to be evaluated again, with the metal the other way.
    [[nodiscard]] bool turns(const Residual& state) {
        constexpr int most = 8;
        const bool changes = state.status_changes > 0;
        ++states_;
        if (elastic_) {
            const bool first = states_ == 3;  // the one before, and so with its statuses
            if (first || (changes && states_ < most)) return false;
            elastic_ = false;
            return true;
        }
        may_be_ = may_be_ && (states_ == 1 ? state.closed > 0 : states_ == 2 && changes);
        elastic_ = may_be_ && states_ == 2;
        return elastic_;
    }
    [[nodiscard]] bool elastic() const { return elastic_; }

private:
    bool may_be_, elastic_ = false;
    int states_ = 0;
};

/// From one start after the other to one target.
class NewtonSearch {
public:
    NewtonSearch(Equilibrium& equilibrium, const Target& target, const NewtonLimits& limits)
        : equilibrium_(equilibrium), target_(target), limits_(limits) {}

    /// False where the start turns out to mislead.
    [[nodiscard]] bool is_done_from(const Predictor& start);
    /// Goes back to what is committed, and counts what there is as lost; returns what went wrong.
    std::string start_anew();

    NewtonReport report;

private:
    /// From one start until convergence or for as long as is allowed; false where the start turns out to mislead.
    [[nodiscard]] bool iterate(bool guessed);

    Equilibrium& equilibrium_;
    const Target& target_;
    const NewtonLimits& limits_;
};

bool NewtonSearch::is_done_from(const Predictor& start) {
    const bool guessed = start.goes_on || start.factor != 0.0;
    try {
        equilibrium_.begin(target_, start);
        return iterate(guessed);
    } catch (const NumericalFailure& failure) {
        report.failure = failure.what();
        return !guessed;
    }
}

std::string NewtonSearch::start_anew() {
    equilibrium_.rollback();
    report.lost.insert(report.lost.end(), report.iterations.begin(), report.iterations.end());
    report.iterations.clear();
    return std::exchange(report.failure, {});
}

bool NewtonSearch::iterate(bool guessed) {
    const SolverSection& solver = limits_.solver;
    std::optional<LineSearch> search(std::in_place);
    LeftToRounding left_to_rounding;
    ContactFirst contact_first(!guessed && target_.held == 0.0);
    for (int iteration = 0; iteration <= solver.max_iterations; ++iteration) {
        report.stopped = !limits_.waits();
        if (report.stopped) return true;
        const Residual residual = equilibrium_.linearise();
        if (!residual.is_finite()) throw NumericalFailure("the residual is not a number");
        if (residual.woken) iteration = 0;  // what has been woken is new to it
        if (contact_first.turns(residual)) {
            report.iterations.push_back({residual, 0.0});
            search.emplace();
            iteration = 0;  // what flows from here on is new to it
            equilibrium_.set_elastic(contact_first.elastic());
            equilibrium_.apply_further(0.0);
            continue;
        }
        if (const double part = search->further(residual); part != 0.0) {
            report.iterations.push_back({residual, 0.0});
            equilibrium_.apply_further(part);
            continue;
        }
        const double correction = equilibrium_.solve();
        report.iterations.push_back({residual, correction});
        const bool settled = residual.within(solver.tolerance) &&
                             (left_to_rounding.is(residual, correction) || correction <= 10.0 * solver.tolerance);
        const bool rounding = residual.largest() < 1e-13 * limits_.largest_force && residual.target <= solver.tolerance;
        if (!contact_first.elastic() && (settled || rounding)) {
            report.converged = !residual.provisional;
            if (report.converged) return true;
            equilibrium_.look_at_rest();
        }
        if (guessed && is_misled(report)) return false;
        equilibrium_.apply();
    }
    report.failure = fmt::format("no convergence in {} iterations (solver.max_iterations)", solver.max_iterations);
    return !guessed;
}

/// Faces that touch, and part one after the other: along slender arms there are more of them than iterations, and a
/// load that is halved parts as many. Where metal flows a smaller load is another matter.
bool parts_slowly(const NewtonReport& report) {
    return !report.converged && !report.stopped && !report.iterations.empty() &&
           report.iterations.back().residual.yielding_points == 0 &&
           std::ranges::any_of(report.iterations, [](const auto& it) { return it.residual.status_changes > 0; });
}

}  // namespace

NewtonReport find_equilibrium(Equilibrium& equilibrium, const Target& target, const Predictor& predictor,
                              const NewtonLimits& limits) {
    NewtonSearch search(equilibrium, target, limits);
    if (!search.is_done_from(predictor)) {
        search.start_anew();
        static_cast<void>(search.is_done_from({}));
    }
    if (target.held != 0.0 || !parts_slowly(search.report)) return std::move(search.report);
    const std::string failure = search.start_anew();
    Predictor apart;
    apart.apart = true;
    static_cast<void>(search.is_done_from(apart));
    NewtonReport& report = search.report;
    if (!report.converged && !report.stopped) report.failure = failure;  // a body that only its faces hold floats
    return std::move(report);
}

}  // namespace stria::coarse
