// How a run stands: the word for it in summary.json, in the tables of a study and on pages.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stria::coarse {

/// A summary says Done, Interrupted or Failed. The others are what one who starts runs knows of them.
enum class RunStatus {
    NotRun,
    Running,
    Done,
    Interrupted,
    Failed,      // it found no equilibrium
    WrongInput,  // the case or the command line is wrong
    Lost,        // a component is gone
    NoFile,      // a file could not be read or written
    Error        // a defect
};

[[nodiscard]] std::string to_text(RunStatus status);

/// Nothing where the text is the word of none.
[[nodiscard]] std::optional<RunStatus> run_status(std::string_view text);

}  // namespace stria::coarse
