// Uniaxial cycles of a material point, told by their extremes.
#pragma once

#include <vector>

#include "app/material/cyclic_test.hpp"
#include "common/index.hpp"

namespace stria::test {

/// Of one cycle: stress and plastic strain at its minimum and at the maximum that ends it.
struct Turns {
    double stress_at_min, stress_at_max, plastic_at_min, plastic_at_max;
};

inline std::vector<Turns> turns_of(const Case& input) {
    std::vector<Turns> all;
    const std::vector<material::TestRow> rows = material::go_through_cycles(input);
    const int half = input.material_test->steps / 2;
    for (std::size_t end = at(3 * half); end < rows.size(); end += at(2 * half)) {
        const material::TestRow &minimum = rows[end - at(half)], &maximum = rows[end];
        all.push_back({minimum.stress, maximum.stress, minimum.plastic_strain, maximum.plastic_strain});
    }
    return all;
}

/// Backward Euler is of first order: twice as many increments halve the error, and twice theirs less these have none.
inline std::vector<Turns> extrapolated_turns(Case input) {
    const std::vector<Turns> some = turns_of(input);
    input.material_test->steps *= 2;
    std::vector<Turns> more = turns_of(input);
    for (std::size_t k = 0; k < more.size(); ++k)
        for (double Turns::*value :
             {&Turns::stress_at_min, &Turns::stress_at_max, &Turns::plastic_at_min, &Turns::plastic_at_max})
            more[k].*value = 2.0 * more[k].*value - some[k].*value;
    return more;
}

inline Case tested(const MaterialSection& material, PlaneState plane, TestControl control, LoadBlock block, int steps) {
    Case input;
    input.material = material;
    input.model.plane = plane;
    input.fine.substeps = 1;
    input.material_test = {.control = control, .mode = TestMode::Uniaxial, .blocks = {block}, .steps = steps};
    return input;
}

}  // namespace stria::test
