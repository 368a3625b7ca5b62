// A page of charts: one HTML file that needs nothing else, from a phone to paper, by day and by night.
#pragma once

#include <string>
#include <vector>

namespace stria::charts {

/// Charts that belong together; those without a point are left out.
struct Figure {
    std::string title;
    std::string sentence = {};             // how to read them; may be empty
    std::vector<std::string> charts = {};  // SVG, or what `captioned` and `slides` make of it
    std::string tables = {};               // HTML under them: links to what they show, or what is not drawn
};

/// A chart with what belongs under it, as HTML. Empty where the chart is.
std::string captioned(const std::string& svg, const std::string& caption);

/// Charts with the same frames under one slider: it shows the frame of that number in all of them, and its name.
std::string slides(const std::vector<std::string>& svgs, const std::vector<std::string>& names, std::size_t shown,
                   const std::string& caption);

/// With a heading; empty where the figure has neither a chart nor a table.
std::string section(Figure figure);

/// Under a heading that is the title too. `body`: HTML.
std::string page(const std::string& title, const std::string& body);

}  // namespace stria::charts
