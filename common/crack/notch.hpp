// The machined part of a crack.
#pragma once

#include "common/case/case.hpp"

namespace stria {

/// Its faces never touch. Arc lengths from the crack's present first point, mm; one and the same: there is none.
struct Notch {
    double from = 0.0, to = 0.0;

    [[nodiscard]] bool holds(double s) const { return s >= from && s < to; }
};

/// Of a crack whose first point growth has moved on by so much arc, mm. It stays where it was in the body: the new
/// faces before it may touch, like those behind it.
inline Notch notch_of(const CrackSection& crack, double grown_at_start) {
    return {grown_at_start, grown_at_start + crack.notch};
}

}  // namespace stria
