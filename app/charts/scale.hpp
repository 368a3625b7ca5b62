// Axes of a chart: from values to pixels, and the round numbers that stand at their ticks.
#pragma once

#include <string>
#include <vector>

namespace stria::charts {

struct Range {
    double low, high;
};

/// Round numbers (1, 2 or 5 times a power of ten apart) that enclose the range but for a thousandth of their distance,
/// about `wanted` of them. A range of less than a millionth of its values is rounding and is widened.
std::vector<double> linear_ticks(Range range, int wanted);

/// Powers of ten that enclose the range, some eight at most; with 2 and 5 times them where it spans less than two
/// decades. Throws std::logic_error unless the range is positive.
std::vector<double> log_ticks(Range range);

/// "0.002", "20000", "3e+06": short, with as many digits as it takes to tell them apart.
std::vector<std::string> tick_labels(const std::vector<double>& ticks);

class Scale {
public:
    /// From the first tick to the last onto the pixels.
    Scale(std::vector<double> ticks, bool logarithmic, Range pixels);

    [[nodiscard]] double operator()(double value) const;
    [[nodiscard]] const std::vector<double>& ticks() const { return ticks_; }

private:
    std::vector<double> ticks_;
    bool logarithmic_;
    Range pixels_;
};

}  // namespace stria::charts
