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
    /// A part of what holds the faces that a growth has opened. False: stop here.
    std::function<bool()> released_in_part = [] { return true; };
    /// No equilibrium has been found, and the run is about to fail: the state is the last one that has converged.
    std::function<void()> stuck = [] {};
};

}  // namespace stria::coarse
