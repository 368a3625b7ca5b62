// `stria study`: a case with every combination of some values, in one table and one page of charts.
#pragma once

#include <string>
#include <vector>

#include "app/run.hpp"

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

/// Runs all variants, each as a program of its own in a folder of its own, and writes study.csv and study.html. The
/// exit code is 0 if all are done, else the worst of theirs. Throws CaseError before anything is run where a variant's
/// case is wrong.
int run_study(StudyOptions options);

}  // namespace stria::study
