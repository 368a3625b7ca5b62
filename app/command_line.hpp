// What the user asked for on the command line; the same options for all three programs.
#pragma once

#include "app/run/run_options.hpp"
#include "app/study/plan.hpp"

#include <optional>
#include <string>

namespace stria {

struct Command {
    std::string name;  // run | check | study | report | material | explain
    RunOptions run;
    study::StudyOptions study;
    std::string key;        // of explain; empty: all keys
    bool markdown = false;  // of explain
};

/// Nothing where the answer is already printed (--help, --version). Throws CaseError on wrong usage.
std::optional<Command> parse_stria(int argc, const char* const* argv);

/// stria-coarse and stria-fine: CASE.toml and the options of `stria run`.
std::optional<Command> parse_component(const std::string& program, int argc, const char* const* argv);

}  // namespace stria
