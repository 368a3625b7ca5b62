// What one run gave, in the numbers that a study compares; and how far they are from those of another.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "app/study/variants/profile.hpp"
#include "coarse/results/run_status.hpp"

namespace stria::study {

/// A column of study.csv.
struct Quantity {
    const char* name;
    const char* unit;
};

/// Sizes, seconds of each phase, and work as a whole and for each Newton iteration: from summary.json.
std::span<const Quantity> sizes();
std::span<const Quantity> phases();  // the last is the total
std::span<const Quantity> work();

/// Results of the first tip: from history.csv, contact edge and openings from faces.csv. Those that can have an error.
std::span<const Quantity> results();

/// What fatigue asks of the end of a run, of the first tip: from the last row of cycles.csv, and life from
/// summary.json. They can have an error too.
std::span<const Quantity> endings();

using coarse::RunStatus;

struct Outcome {
    RunStatus status = RunStatus::NotRun;
    std::string message = {};  // why it is not done
    int exit_code = 0;
    std::map<std::string, double> values = {};  // by the name of the quantity; missing ones are absent
    Profile at_maximum = {}, at_minimum = {};   // of the first crack

    /// NaN where it is missing.
    [[nodiscard]] double value(const std::string& name) const;
};

/// Reads what a run left in `folder`. Results of a run that is not done are left out: they belong to other loads.
Outcome read_outcome(const std::filesystem::path& folder);

/// |value - reference| / |reference|; 0 where both are zero, NaN where only the reference is, or one is missing.
double relative_error(double value, double reference);

/// Relative errors by name of the result, the openings as profiles.
std::map<std::string, double> errors(const Outcome& outcome, const Outcome& reference);

}  // namespace stria::study
