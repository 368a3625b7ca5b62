// What a run says while it goes: one live line on a terminal, plain lines into a pipe, tables of iterations on request.
#pragma once

#include <chrono>
#include <string>

#include "coarse/analysis/fatigue_analysis.hpp"

namespace stria {

class Progress {
public:
    /// `terminal`: the user's own output is one, whatever lies between.
    Progress(const Case& input, bool quiet, bool verbose, bool terminal);

    void note(const std::string& text);
    /// The increments up to this one were made before.
    void resumed(int increment) { done_before_ = done_ = increment; }
    void attempted(const coarse::LoadStep& step, const coarse::NewtonReport& report);
    void accepted(const coarse::Increment& increment);
    void finished(const std::string& directory, double seconds);

private:
    void end_live_line();

    bool quiet_, verbose_, terminal_;
    bool live_ = false;
    int increments_;  // planned
    int done_before_ = 0, done_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace stria
