// Which charts a study shows: what depends on what, one curve for each combination of the axes that are not along it.
#pragma once

#include <string>
#include <vector>

#include "app/study/report.hpp"

namespace stria::study {

/// Charts that belong together; those without a point are left out.
struct Figure {
    std::string title;
    std::string sentence = {};             // how to read them; may be empty
    std::vector<std::string> charts = {};  // SVG
};

/// Errors against time, results along each axis, openings, time by phase, sizes and traffic. None is empty.
std::vector<Figure> figures(const Report& report);

}  // namespace stria::study
