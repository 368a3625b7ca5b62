#include "coarse/equilibrium/condensed/gamma_states.hpp"

#include <ranges>
#include <utility>

namespace stria::coarse {

GammaStates::GammaStates(GammaState committed, std::size_t remembered)
    : committed_(std::move(committed)), trial_(committed_), increments_(remembered) {}

void GammaStates::begin(const Predictor& predictor, const Eigen::VectorXd& cases) {
    if (!predictor.goes_on) trial_ = committed_;
    if (const GammaState* earlier = increments_.find(predictor)) {
        trial_.displacement += predictor.factor * earlier->displacement;
        trial_.load_factor += predictor.factor * earlier->load_factor;
    }
    trial_.cases = cases;
}

GammaState GammaStates::increment() const {
    return {trial_.displacement - committed_.displacement, trial_.load_factor - committed_.load_factor};
}

void GammaStates::put_aside() { increments_.put_aside(increment()); }

void GammaStates::commit() {
    increments_.push(increment());
    committed_ = trial_;
}

void GammaStates::restore(GammaState committed, const std::deque<GammaState>& increments) {
    committed_ = trial_ = std::move(committed);
    increments_.clear();
    for (const GammaState& increment : increments | std::views::reverse) increments_.push(increment);
}

}  // namespace stria::coarse
