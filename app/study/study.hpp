// `stria study`: a case with every combination of some values, in one table and one page of charts.
#pragma once

#include "app/study/plan.hpp"

namespace stria::study {

/// Runs all variants, each as a program of its own in a folder of its own, and writes study.csv and study.html. The
/// exit code is 0 if all are done, else the worst of theirs, and 130 where an interruption has left some. Throws
/// CaseError before anything is run where a variant's case is wrong.
int run_study(StudyOptions options);

}  // namespace stria::study
