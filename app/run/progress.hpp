// What a run prints on its way: one live line on a terminal, plain lines into a pipe, tables of iterations on request.
#pragma once

#include <chrono>
#include <string>

#include "app/run/pace.hpp"
#include "coarse/analysis/fatigue_analysis.hpp"

namespace stria {

class Progress {
public:
    /// `terminal`: the user watches on a terminal, even if a pipe lies between.
    Progress(const Case& input, bool quiet, bool verbose, bool terminal);

    void note(const std::string& text);
    void attempted(const coarse::LoadStep& step, const coarse::NewtonReport& report);
    /// `N`: cycles so far, with all that the computed ones stand for.
    void accepted(const coarse::Increment& increment, double N);
    /// `passed`: what the run has come to, in words; may be empty.
    void finished(const std::string& directory, double seconds, const std::string& passed);

private:
    void end_live_line();

    bool quiet_, verbose_, terminal_;
    bool live_ = false;
    Pace pace_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace stria
