// The language of the case file as a whole: every key of Case with unit, default, range and sentence, declared once.
#pragma once

#include "common/case/case.hpp"
#include "common/schema/schema.hpp"

namespace stria {

const schema::Section<Case>& case_schema();

}  // namespace stria
