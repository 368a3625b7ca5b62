// The root of a falling function of one variable between two places.
#pragma once

namespace stria {

/// Regula falsi in its Illinois form (Dowell and Jarratt, BIT 11 (1971) 168). The function is 1 at 0; the first guess
/// is 1. The root stays between the two ends; one that stays twice counts half.
class RegulaFalsi {
public:
    [[nodiscard]] double guess() const { return guess_; }
    /// A place beyond the root has been met.
    [[nodiscard]] bool has_passed() const { return passed_; }

    /// `value`: of the function at the guess; the first one has to be below zero.
    void narrow(double value) {
        const int side = value > 0.0 ? 1 : -1;
        if (side > 0) {
            before_ = {guess_, value};
            if (last_side_ == side) beyond_.value *= 0.5;
        } else {
            passed_ = true;
            beyond_ = {guess_, value};
            if (last_side_ == side) before_.value *= 0.5;
        }
        last_side_ = side;
        guess_ = before_.place + (beyond_.place - before_.place) * before_.value / (before_.value - beyond_.value);
    }

private:
    struct End {
        double place, value;
    };
    double guess_ = 1.0;
    int last_side_ = 0;
    bool passed_ = false;
    End before_{0.0, 1.0}, beyond_{1.0, 0.0};
};

}  // namespace stria
