// Where Newton's method starts an increment from: what was committed plus a multiple of an increment taken before.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <utility>

#include "common/index.hpp"
#include "common/or_auto.hpp"

namespace stria {

/// committed + factor * the increment `back` commits ago (1: the last one; 0: an attempt that was put aside).
struct Predictor {
    Predictor(double factor_ = 0.0, int back_ = 1, bool goes_on_ = false)
        : factor(factor_), back(back_), goes_on(goes_on_) {}
    bool operator==(const Predictor&) const = default;

    double factor;
    int back;
    bool goes_on;        // instead of what is committed: from where the last attempt has got
    bool apart = false;  // faces that may touch do so only where they overlap then
};

/// How many increments are remembered: a cycle and a cycle's worth of halvings, or as many as a cycle may have.
inline std::size_t remembered_increments(const OrAuto<int>& steps_per_cycle) {
    return steps_per_cycle.is_auto() ? 48 : 2 * at(steps_per_cycle.value());
}

/// The last increments of something. `Increment`: what a scalar multiplies.
template <class Increment> class IncrementMemory {
public:
    explicit IncrementMemory(std::size_t capacity) : capacity_(capacity) {}

    void push(Increment increment) {
        aside_.reset();
        increments_.push_front(std::move(increment));
        if (increments_.size() > capacity_) increments_.pop_back();
    }
    /// Of an attempt that leads from what is committed, until the next commit.
    void put_aside(Increment attempt) { aside_ = std::move(attempt); }
    void clear() {
        increments_.clear();
        aside_.reset();
    }

    /// All that are remembered, the last one first.
    [[nodiscard]] const std::deque<Increment>& all() const { return increments_; }

    /// Null where it is not known, or not wanted.
    [[nodiscard]] const Increment* find(const Predictor& predictor) const {
        if (predictor.factor == 0.0) return nullptr;
        if (predictor.back == 0) return aside_ ? &*aside_ : nullptr;
        const auto place = at(predictor.back) - 1;
        return place < increments_.size() ? &increments_[place] : nullptr;
    }

private:
    std::size_t capacity_;
    std::deque<Increment> increments_;
    std::optional<Increment> aside_;
};

}  // namespace stria
