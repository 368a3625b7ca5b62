// Whom an analysis tells what happens.
#pragma once

#include <functional>
#include <string>

#include "coarse/cycle/increment.hpp"
#include "coarse/structure/structure.hpp"

namespace stria::coarse {

/// Takes one line for the log.
using Note = std::function<void(const std::string&)>;

struct Listener {
    /// An increment has been committed.
    std::function<void(const Increment&, const Structure&)> accepted = [](const Increment&, const Structure&) {};
    /// The last increment accepted is that at which growth has ended the run.
    std::function<void(const Increment&, const Structure&)> growth_ended = [](const Increment&, const Structure&) {};
    Note note = [](const std::string&) {};
    /// Newton's method has ended, converged or not.
    std::function<void(const LoadStep&, const NewtonReport&)> attempted = [](const LoadStep&, const NewtonReport&) {};
    /// A load has been reached, and the cracks have grown where they do so there. False: stop here.
    std::function<bool(const LoadStep&)> reached = [](const LoadStep&) { return true; };
    /// Asked before each search for an equilibrium. False: the run is to end.
    std::function<bool()> goes_on = [] { return true; };
    /// Asked within one. False: it is to end there, and what it has found so far is lost; goes_on() is false, too.
    Waits waits = [] { return true; };
    /// The run ends between two loads: no equilibrium is found, or it is not to go on. The state is the last one that
    /// has converged.
    std::function<void()> breaks_off = [] {};
};

}  // namespace stria::coarse
