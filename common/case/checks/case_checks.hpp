// Conditions that several keys of a case must meet together. `table` is the section as the file gives it, `place` where
// it stands. Each throws CaseError with the line of the file.
#pragma once

#include "common/case/case.hpp"
#include "common/schema/schema.hpp"

namespace stria {

void check_grading(const Grading& grading, const schema::Value& table, const schema::Place& place);
void check_mesh(const MeshSection& mesh, const schema::Value& table, const schema::Place& place);
void check_growth(const GrowthSection& growth, const schema::Value& table, const schema::Place& place);
void check_crack(const CrackSection& crack, const schema::Value& table, const schema::Place& place);
void check_block(const LoadBlock& block, const schema::Value& table, const schema::Place& place);
void check_load(const Case& whole, const schema::Value& root, const schema::Place& place);  // spectrum included

/// Pins are those of specimens, groups those of a file.
void check_names_of_mesh(const Case& whole, const schema::Value& root, const schema::Place& place);
void check_case(const Case& whole, const schema::Value& root, const schema::Place& place);

}  // namespace stria
