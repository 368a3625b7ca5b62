// What the user asked for where a study is made.
#pragma once

#include <string>
#include <vector>

#include "app/run/run_options.hpp"

namespace stria::study {

struct StudyOptions {
    RunOptions run;                  // case, folder, --set, --force; mode and fine_ranks are in the lists below
    std::vector<std::string> over;   // key=v1,v2,...
    std::vector<std::string> modes;  // more than one: an axis
    std::vector<std::string> fine_ranks;
    std::string reference;                      // key=value,... or the folder of a run; empty: none
    std::vector<std::string> reference_values;  // result=value,...
    bool resume = false;                        // keep variants that are done
};

}  // namespace stria::study
