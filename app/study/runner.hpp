// Runs the variants of a study, each as a `stria run` of its own with a log of its own, and says how it went.
#pragma once

#include <cstddef>

#include "app/run/run_options.hpp"
#include "app/study/table.hpp"

namespace stria::study {

class Runner {
public:
    /// `shared`: what all `count` runs have in common; its folder is that of the study. With `resume`, a run that is
    /// done is kept.
    Runner(RunOptions shared, bool resume, std::size_t count);

    /// Runs the row's settings in the row's folder and fills in its outcome. A run that fails is an outcome, too.
    /// Does nothing once a run was interrupted.
    void run(Row& row);

private:
    void say(const std::string& text, const char* end) const;

    RunOptions shared_;
    bool resume_;
    std::size_t count_, begun_ = 0;
    bool terminal_;
    bool interrupted_ = false;
};

}  // namespace stria::study
