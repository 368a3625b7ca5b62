// The page of a study: one HTML file with its charts and tables, nothing to be fetched.
#pragma once

#include <string>

#include "app/study/variants/table.hpp"

namespace stria::study {

std::string page(const Report& report);

}  // namespace stria::study
