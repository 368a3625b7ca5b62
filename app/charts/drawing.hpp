// The strokes that all charts are made of. Colours are classes: the page gives them their values, by day and by night.
#pragma once

#include <cstddef>
#include <string>

namespace stria::charts {

/// Pixels of the drawing's own; the page scales it.
inline constexpr double width = 460.0, left = 60.0, right = 14.0, top = 32.0, below = 44.0, legend_line = 17.0;
inline constexpr double letter = 6.2;  // about the width of one

/// With the characters replaced that have a meaning in SVG and HTML.
std::string escaped(const std::string& text);

/// `more`: further attributes, each after a blank.
std::string text_at(double x, double y, const char* anchor, const std::string& text, const std::string& more = "");

/// "c0", "c1", ...: the class that colours curve or part `number`. As many as can be told apart, then from the start.
std::string colour_class(std::size_t number);
inline constexpr std::size_t colour_count = 7;

/// The rules of these classes, for the style of a page: Okabe and Ito, told apart with every kind of colour vision. And
/// those of "l0" to "l5", levels of a field from a body at rest to the largest value.
std::string colour_rules();

/// The whole drawing under its title.
std::string framed(const std::string& title, double height, const std::string& body);

}  // namespace stria::charts
