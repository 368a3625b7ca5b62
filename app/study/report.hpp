// A finished study: what its page and its charts are made of.
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

}  // namespace stria::study
