// Stacked bars as SVG text.
#pragma once

#include <string>
#include <vector>

namespace stria::charts {

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

/// Empty where no bar has a length.
std::string svg(const BarChart& chart);

}  // namespace stria::charts
