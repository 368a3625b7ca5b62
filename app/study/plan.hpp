// What a study will run: the variants, the reference of each, and where each goes; checked before anything is run.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/run/run_options.hpp"
#include "app/study/variants/table.hpp"

namespace stria::study {

/// How its runs are to be made.
struct StudyOptions {
    RunOptions run;                  // case, folder, --set, --force; mode and fine_ranks are in the lists below
    std::vector<std::string> over;   // key=v1,v2,...
    std::vector<std::string> modes;  // more than one: an axis
    std::vector<std::string> fine_ranks;
    std::string reference;                      // key=value,... or the folder of a run; empty: none
    std::vector<std::string> reference_values;  // result=value,...
    bool resume = false;                        // keep variants that are done, go on with those that are begun
    int jobs = 1;                               // variants at a time; 0: none is run
    std::string commands;                       // "lines" or "slurm": print them, run nothing; empty: run
};

struct Plan {
    std::vector<Axis> axes;
    std::vector<Row> references;  // runs of their own, in reference/ or reference-1/ ...
    std::vector<Row> variants;
    bool with_errors = false;
    std::string reference_folder;                    // an existing run instead
    Outcome reference_run;                           // what that gave
    std::map<std::string, double> reference_values;  // these win over a run's
};

/// Throws CaseError where an option or a variant's case is wrong.
Plan make_plan(const StudyOptions& options);

/// The options of `stria run` for these settings: a case key becomes an override, after those all variants share.
RunOptions run_options(const RunOptions& shared, const Settings& settings);

}  // namespace stria::study
