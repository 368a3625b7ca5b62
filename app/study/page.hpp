// The page of a study: one HTML file with its charts and tables, nothing to be fetched.
#pragma once

#include <string>
#include <vector>

#include "app/study/table.hpp"

namespace stria::study {

struct Report {
    std::string title;
    std::string case_path;
    std::string version;
    std::vector<std::string> fixed;  // key=value, the same in all variants
    std::vector<Axis> axes;
    std::vector<Row> rows;
    std::vector<Row> references;  // runs beyond the variants
    std::string reference;        // in words; empty: none
};

std::string page(const Report& report);

}  // namespace stria::study
