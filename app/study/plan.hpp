// What a study will run: the variants, the reference of each, and where each goes; checked before anything is run.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/study/study_options.hpp"
#include "app/study/table.hpp"

namespace stria::study {

struct Plan {
    std::vector<Axis> axes;
    std::vector<Row> references;  // runs of their own, in reference/ or reference-1/ ...
    std::vector<Row> variants;
    bool with_errors = false;
    std::string reference_folder;                    // an existing run instead
    std::map<std::string, double> reference_values;  // these win over a run's
};

/// Throws CaseError where an option or a variant's case is wrong.
Plan make_plan(const StudyOptions& options);

/// The options of `stria run` for these settings: a case key becomes an override, after those all variants share.
RunOptions run_options(const RunOptions& shared, const Settings& settings);

}  // namespace stria::study
