// Conditions on load cases, the loads beside the main one. As case_checks.hpp.
#pragma once

#include "common/case/case.hpp"
#include "common/schema/schema.hpp"

namespace stria {

/// It is loaded by [load]: neither by a load case nor by a pressure that travels.
[[nodiscard]] bool is_of_main_load(const BoundarySection& boundary);

void check_load_case(const LoadCaseSection& load_case, const schema::Value& table, const schema::Place& place);

/// Names of load cases, and who uses them.
void check_load_cases(const Case& whole, const schema::Value& root, const schema::Place& place);

/// Each case that has blocks has as many cycles as [load], those of the spectrum included.
void check_cycles_of_cases(const Case& whole, const schema::Value& root, const schema::Place& place);

}  // namespace stria
