// What a point, an edge or a pin may carry, and what of it goes together. As case_checks.hpp.
#pragma once

#include "common/case/case.hpp"
#include "common/schema/given.hpp"

namespace stria {

void check_boundary(const BoundarySection& boundary, const schema::Value& table, const schema::Place& place);

/// What only a boundary of a specimen must meet: names of a file's groups do not say what they are, its mesh does.
void check_boundary_of_specimen(const BoundarySection& boundary, const schema::Given& given);

}  // namespace stria
