// Curves over one axis as SVG text. Nothing but numbers in, nothing but text out.
#pragma once

#include <string>
#include <vector>

namespace stria::charts {

struct Curve {
    std::string name;
    std::vector<double> x = {}, y = {};    // points with a value that is not finite are left out, and end the line
    bool markers = true;                   // at each point, where there are no more than can be told apart
    bool line = true;                      // from point to point
    bool filled = false;                   // an area: the line closes and bears no marker
    std::vector<std::string> points = {};  // their names, one each; none: only the pointer shows what they are
};

/// One of several states that a chart shows in turn.
struct Frame {
    std::string name;
    std::vector<Curve> curves;
};

struct LineChart {
    std::string title;  // what is on the vertical axis
    std::string x_label = {};
    std::vector<std::string> words = {};  // where x is no number but stands for these: 0, 1, 2, ...
    bool log_x = false, log_y = false;    // points that are not positive are left out
    bool from_zero = false;               // the vertical axis, where it is not logarithmic
    std::vector<Curve> curves = {};       // always shown
    std::vector<Frame> frames = {};       // their curves follow those; the axes enclose all of them
    std::size_t shown = 0;                // the frame that is shown first
};

/// Empty where no point can be shown. Each SVG has a title that names it for who cannot see it, and a legend where it
/// has more than one curve; curves differ in colour, marker and dash. A frame is a group of the class "frame" with its
/// number in data-k; the one shown has the class "shown" as well.
std::string svg(const LineChart& chart);

}  // namespace stria::charts
