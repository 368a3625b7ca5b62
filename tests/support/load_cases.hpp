// Load cases and what they load, as a case file would have them.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "common/case/case.hpp"

namespace stria::test {

inline LoadCaseSection dead_load(const std::string& name, double constant) {
    LoadCaseSection load_case;
    load_case.name = name;
    load_case.constant = constant;
    return load_case;
}

inline LoadCaseSection lagging_load(const std::string& name, double factor, double phase = 0.0,
                                    LagPath path = LagPath::Sine) {
    LoadCaseSection load_case;
    load_case.name = name;
    load_case.factor = factor;
    load_case.phase = phase;
    load_case.path = path;
    return load_case;
}

inline LoadCaseSection own_load(const std::string& name, std::vector<CaseBlock> blocks) {
    LoadCaseSection load_case;
    load_case.name = name;
    load_case.blocks = std::move(blocks);
    return load_case;
}

inline BoundarySection pulled_in_case(const std::string& load_case, const std::string& on, const Vec2& traction) {
    BoundarySection section;
    section.on = on;
    section.traction = traction;
    section.load_case = load_case;
    return section;
}

inline BoundarySection held(const std::string& on) {
    BoundarySection section;
    section.on = on;
    section.displacement = {0.0, 0.0};
    return section;
}

inline BoundarySection under_wheel(const std::string& on, const TravellingPressure& wheel,
                                   const Vec2& origin = Vec2::Zero()) {
    BoundarySection section;
    section.on = on;
    section.origin = origin;
    section.travelling = wheel;
    return section;
}

}  // namespace stria::test
