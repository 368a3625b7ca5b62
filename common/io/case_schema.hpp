// The language of the case file: every key of Case with unit, default, range and sentence, declared once.
#pragma once

#include "common/io/case.hpp"
#include "common/io/known_keys.hpp"

namespace stria {

const schema::Section<Case>& case_schema();

/// What the language has and this version has not, in one place. A line goes when the thing is built.
const std::vector<schema::NotYet>& not_in_this_version();

/// Conditions that several keys must meet together. Each throws CaseError.
void check_grading(const Grading& grading, const schema::Value& table, const schema::Place& place);
void check_mesh(const MeshSection& mesh, const schema::Value& table, const schema::Place& place);
void check_growth(const GrowthSection& growth, const schema::Value& table, const schema::Place& place);
void check_crack(const CrackSection& crack, const schema::Value& table, const schema::Place& place);
void check_boundary(const BoundarySection& boundary, const schema::Value& table, const schema::Place& place);
void check_block(const LoadBlock& block, const schema::Value& table, const schema::Place& place);
void check_case(const Case& whole, const schema::Value& root, const schema::Place& place);

}  // namespace stria
