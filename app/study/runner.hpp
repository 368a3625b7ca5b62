// Runs the variants of a study, each as a `stria run` of its own with a log of its own, and says how they went.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <sys/types.h>
#include <vector>

#include "app/process/children.hpp"
#include "app/run/run_options.hpp"
#include "app/study/variants/table.hpp"

namespace stria::study {

/// What a run says goes into this file of its folder.
inline constexpr const char* log_name = "stria.log";

class Runner {
public:
    /// `shared`: what all runs have in common; its folder is that of the study. With `resume`, a run that is done is
    /// kept, and one that is begun goes on from its checkpoint. `jobs`: how many run at a time, each on its share of
    /// the cores; with 0 none is run, and what they have left is read.
    Runner(RunOptions shared, bool resume, int jobs);

    /// Runs the settings of each row in the row's folder and fills in its outcome. A run that fails is an outcome, too.
    /// Begins none once one was interrupted. Calls `changed` before it waits, whenever an outcome has changed.
    void run(std::span<Row* const> rows, const std::function<void()>& changed);

    /// No more runs begin: this process or one of them was interrupted.
    [[nodiscard]] bool interrupted() const { return interrupted_; }

private:
    struct Job {
        Row* row;
        std::size_t number;  // from 1, in the order of the rows
        int part;            // of the cores
        std::chrono::steady_clock::time_point start;
    };

    void begin(Row& row, std::size_t number);
    void end(const EndedChild& child);
    [[nodiscard]] RunOptions options_of(const Row& row) const;
    [[nodiscard]] int free_part() const;
    void say(const Row& row, std::size_t number, const std::string& what) const;
    void say_how_far() const;

    RunOptions shared_;
    bool resume_;
    int jobs_;
    std::vector<int> cores_;
    std::size_t count_ = 0;
    std::map<pid_t, Job> running_;
    bool terminal_;
    bool interrupted_ = false;
};

}  // namespace stria::study
