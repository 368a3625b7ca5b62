// The conditions of case_checks.hpp that are about one metal: its hardening, and the test of one point of it.
#pragma once

#include "common/case/case.hpp"
#include "common/schema/schema.hpp"

namespace stria {

void check_hardening(const MaterialSection& material, const schema::Value& table, const schema::Place& place);
void check_material_test(const MaterialTestSection& test, const schema::Value& table, const schema::Place& place);

}  // namespace stria
