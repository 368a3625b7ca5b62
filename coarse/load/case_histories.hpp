// The factors of load cases along the way of the main load (load_history.hpp): dead loads, loads that lag behind it,
// loads with extremes of their own, and pressures that travel.
#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "coarse/load/load_factors.hpp"
#include "coarse/load/load_history.hpp"
#include "common/case/case.hpp"

namespace stria::coarse {

/// A place on the way through a history.
struct LoadPlace {
    std::size_t leg = 0;
    double way = 0.0;    // of the leg, 0 to 1, in the main load's value
    int increment = 1;   // of the leg, from 1
    double share = 0.0;  // of that increment
    double scale = 1.0;  // of the main load's values (LoadController::set_scale)
};

class CaseHistories {
public:
    CaseHistories() = default;
    explicit CaseHistories(const Case& input);

    /// How many unit loads there are beside the main one: the load cases in their order, then for each boundary with a
    /// pressure that travels its positions.
    [[nodiscard]] Eigen::Index count() const;
    /// Of them, those of load cases.
    [[nodiscard]] std::size_t load_cases() const { return cases_.size(); }

    /// The main history behind the leg in which dead loads and pressures that travel come on, if there are any. Where
    /// displacements are controlled and the first one is zero a leg from where these, or an initial stress, have moved
    /// the boundary comes before it.
    [[nodiscard]] const std::vector<Leg>& legs() const { return legs_; }
    /// Of them, those that are no legs of the main history alone (load_history.hpp).
    [[nodiscard]] std::size_t legs_before_history() const { return put_first_; }
    [[nodiscard]] bool leads() const { return !legs_.empty() && legs_.front().leads; }

    /// Load cases lag, and no pressure travels.
    [[nodiscard]] bool lag() const { return travelling_ == 0 && !turns().empty(); }
    /// What they do may be largest between the ends of legs: loads lag, or travel.
    [[nodiscard]] bool peak_between_ends() const { return travelling_ > 0 || !turns().empty(); }
    /// At that part of a leg the loads may go on in another direction: where one turns, or a leg ends, but not where
    /// all that are not dead go through an ellipse.
    [[nodiscard]] bool have_corner(double way) const;
    /// Parts of a leg at which a load that lags turns, ascending, between 0 and 1.
    [[nodiscard]] std::vector<double> turns() const;
    /// Part of a leg at a part of its angle, half a cycle, by the path of the first load that lags.
    [[nodiscard]] double at_angle(double part) const;
    /// Parts of a leg at equal angles; the first 0.
    [[nodiscard]] std::vector<double> at_equal_angles(int increments) const;

    [[nodiscard]] Eigen::VectorXd at(const LoadPlace& place) const;
    /// As [load] begins: what has come on before.
    [[nodiscard]] Eigen::VectorXd at_start() const;

    [[nodiscard]] bool is_dead(std::size_t k) const { return k < cases_.size() && cases_[k].constant; }
    /// Factors of dead loads alone.
    [[nodiscard]] Eigen::VectorXd dead() const;

    /// Load cases with blocks have these factors where a leg ends: not where a history has ended and another goes on.
    [[nodiscard]] bool ends_leg_at(std::size_t leg, const Eigen::VectorXd& factors) const;

    /// All loads where [load] turns back at the end of a leg and has gone back by a part of its way. `scale`: as in
    /// LoadPlace. Of no history with pressures that travel.
    [[nodiscard]] LoadFactors turning_back(std::size_t leg, double way, double scale) const;

    /// What `of_unit` of each unit load can add up to: no less than the largest of the history. `scale`: as in
    /// LoadPlace.
    [[nodiscard]] double largest_sum(const std::vector<double>& of_unit, double scale) const;

private:
    void put_first(const Leg& leg);
    /// The least and the largest factor.
    [[nodiscard]] std::pair<double, double> extremes(const LoadCaseSection& load_case, double scale) const;
    // `k`: of a load case.
    [[nodiscard]] double factor(std::size_t k, const LoadPlace& place) const;
    [[nodiscard]] double lagging(const LoadCaseSection& load_case, const LoadPlace& place) const;
    [[nodiscard]] double turning_back(std::size_t k, std::size_t leg, double way, double scale) const;
    [[nodiscard]] double of_blocks(std::size_t k, const LoadPlace& place) const;
    [[nodiscard]] double at_end_of(std::size_t k, std::size_t leg) const;
    [[nodiscard]] const CaseBlock& block_of_cycle(std::size_t k, int cycle) const;
    void put_travelling(const LoadPlace& place, Eigen::Index first, Eigen::VectorXd& factors) const;

    LoadSection load_;
    std::vector<LoadCaseSection> cases_;
    std::vector<std::vector<int>> ends_of_blocks_;  // the last cycle of each block, per load case
    Eigen::Index travelling_ = 0;                   // pressures
    int cycles_ = 0;
    std::vector<Leg> legs_;
    std::size_t put_first_ = 0;  // of them
};

/// Positions of a pressure that travels: it is at one of them where a whole increment ends.
[[nodiscard]] int positions_of_travel(const LoadSection& load);

/// One sentence where a pressure travels in increments that pass over what it does to a crack; else none.
[[nodiscard]] std::vector<std::string> travel_warnings(const Case& input);

}  // namespace stria::coarse
