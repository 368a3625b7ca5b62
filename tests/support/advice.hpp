// What is said of the mesh of a plate that flows.
#pragma once

#include <gtest/gtest.h>

#include "coarse/advice/mesh_adequacy.hpp"
#include "coarse/specimen/specimen.hpp"
#include "tests/support/plate_that_flows.hpp"

namespace stria::test {

class Advice : public testing::Test {
protected:
    [[nodiscard]] std::vector<std::string> at(double K_I) const {
        const BodyMesh mesh(coarse::make_mesh(input.mesh, input.cracks, input.regions));
        return coarse::mesh_warnings(coarse::make_scene(input, mesh), {K_I}, {closure_at});
    }
    Case input = plate_that_flows();
    double closure_at = 1.3;  // distance of closure, mm
};

}  // namespace stria::test
