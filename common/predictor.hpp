// Where Newton's method starts an increment from: what was committed plus a multiple of an increment taken before.
#pragma once

#include <cstddef>
#include <deque>

#include "common/index.hpp"

namespace stria {

/// committed + factor * the increment `back` commits ago (1: the last one).
struct Predictor {
    Predictor(double factor_ = 0.0, int back_ = 1) : factor(factor_), back(back_) {}
    bool operator==(const Predictor&) const = default;

    double factor;
    int back;
};

/// How many increments are remembered: a cycle and a cycle's worth of halvings.
inline std::size_t remembered_increments(int steps_per_cycle) { return 2 * at(steps_per_cycle); }

/// The last increments of something. `Increment`: what a scalar multiplies.
template <class Increment> class IncrementMemory {
public:
    explicit IncrementMemory(std::size_t capacity) : capacity_(capacity) {}

    void push(Increment increment) {
        increments_.push_front(std::move(increment));
        if (increments_.size() > capacity_) increments_.pop_back();
    }
    void clear() { increments_.clear(); }

    /// All that are remembered, the last one first.
    [[nodiscard]] const std::deque<Increment>& all() const { return increments_; }

    /// Null where it is not known, or not wanted.
    [[nodiscard]] const Increment* find(const Predictor& predictor) const {
        const auto place = at(predictor.back) - 1;
        return predictor.factor != 0.0 && place < increments_.size() ? &increments_[place] : nullptr;
    }

private:
    std::size_t capacity_;
    std::deque<Increment> increments_;
};

}  // namespace stria
