// Charts as SVG text: curves over one axis, and stacked bars. Nothing but numbers in, nothing but text out.
#pragma once

#include <string>
#include <vector>

namespace stria::charts {

struct Curve {
    std::string name;
    std::vector<double> x = {}, y = {};  // points with a value that is not finite are left out
    bool markers = true;
};

struct LineChart {
    std::string title;  // what is on the vertical axis
    std::string x_label = {};
    std::vector<std::string> words = {};  // where x is no number but stands for these: 0, 1, 2, ...
    bool log_x = false, log_y = false;    // points that are not positive are left out
    bool from_zero = false;               // the vertical axis, where it is not logarithmic
    std::vector<Curve> curves = {};
};

struct Bar {
    std::string name;
    std::vector<double> lengths;  // one for each part
};

struct BarChart {
    std::string title;
    std::string x_label;
    std::vector<std::string> parts;
    std::vector<Bar> bars = {};
};

/// Empty where no point can be shown. Each SVG has a title that names it for who cannot see it, and a legend where it
/// has more than one curve; curves differ in colour, marker and dash.
std::string svg(const LineChart& chart);
std::string svg(const BarChart& chart);

/// With the characters replaced that have a meaning in SVG and HTML.
std::string escaped(const std::string& text);

}  // namespace stria::charts
