#include "app/run/progress.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace stria {

Progress::Progress(const Case& input, bool quiet, bool verbose, bool terminal)
    : quiet_(quiet), verbose_(verbose), terminal_(terminal),
      pace_(coarse::cycle_count(input.load), input.growth ? input.growth->until : std::nullopt) {}

void Progress::end_live_line() {
    if (live_) fmt::print("\n");
    live_ = false;
}

void Progress::note(const std::string& text) {
    if (quiet_) return;
    end_live_line();
    fmt::print("{}\n", text);
    std::fflush(stdout);
}

void Progress::attempted(const coarse::LoadStep& step, const coarse::NewtonReport& report) {
    if (!verbose_) return;
    end_live_line();
    fmt::print("cycle {} {}{}\n{}", step.cycle, to_text(step.target), report.converged ? "" : ": " + report.failure,
               report.table());
    std::fflush(stdout);
}

void Progress::accepted(const coarse::Increment& increment, double N) {
    if (quiet_) return;
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    double longest = 0.0;
    for (const coarse::TipResult& tip : increment.tips) longest = std::max(longest, tip.a);
    const double left = pace_.seconds_left(increment.step.moment, longest, elapsed);
    const double a = increment.tips.empty() ? 0.0 : increment.tips.front().a;
    const std::string line = fmt::format(
        "increment {:4}  cycle {:4}  N {:9.6g}  load factor {:9.4g}  a {:8.4f} mm  {:2} iterations  {:6.1f} s  "
        "{:>6} s left",
        increment.number, increment.step.cycle, N, increment.load_factor, a, increment.newton.count(), elapsed,
        std::isfinite(left) ? fmt::format("{:.1f}", left) : "?");
    if (terminal_) {
        fmt::print("\r{}", line);
        live_ = true;
    } else if (verbose_ || increment.step.reversal) {
        fmt::print("{}\n", line);
    }
    std::fflush(stdout);
}

void Progress::finished(const std::string& directory, double seconds, const std::string& passed) {
    if (quiet_) return;
    end_live_line();
    fmt::print("done in {:.1f} s: {}{}results in {}\n", seconds, passed, passed.empty() ? "" : "; ", directory);
    std::fflush(stdout);
}

}  // namespace stria
