#include "app/charts/drawing.hpp"

#include <array>
#include <fmt/format.h>

namespace stria::charts {

namespace {

constexpr std::array<const char*, colour_count> by_day = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                          "#e69f00", "#56b4e9", "#222222"};
// What is too dark on a dark ground gives way to the lighter colours of the same set.
constexpr std::array<const char*, colour_count> by_night = {"#56b4e9", "#e8732a", "#12b88a", "#cc79a7",
                                                            "#e69f00", "#f0e442", "#eeeeee"};

// From a body at rest to the largest value: one hue, told apart by how light it is.
constexpr std::array<const char*, 6> levels_by_day = {"#ececec", "#c6dbef", "#94c4df", "#4a98c9", "#1764ab", "#08306b"};
constexpr std::array<const char*, 6> levels_by_night = {"#2a2f36", "#1d4b7a", "#2a6fb0",
                                                        "#4a98c9", "#94c4df", "#e3f0fb"};

std::string rules(char letter_of_class, const auto& colours) {
    std::string text;
    for (std::size_t k = 0; k < colours.size(); ++k)
        text += fmt::format(".{}{} {{ color: {}; }}\n", letter_of_class, k, colours[k]);
    return text;
}

}  // namespace

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

std::string text_at(double x, double y, const char* anchor, const std::string& text, const std::string& more) {
    return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}>{}</text>\n", x, y, anchor, more,
                       escaped(text));
}

std::string colour_class(std::size_t number) { return fmt::format("c{}", number % colour_count); }

std::string colour_rules() {
    return rules('c', by_day) + rules('l', levels_by_day) +
           ".grid { color: #ddd; }\n@media screen and (prefers-color-scheme: dark) {\n" + rules('c', by_night) +
           rules('l', levels_by_night) + ".grid { color: #3a3f47; }\n}\n";
}

std::string framed(const std::string& title, double height, const std::string& body) {
    return fmt::format("<svg viewBox=\"0 0 {:.0f} {:.0f}\" role=\"img\" xmlns=\"http://www.w3.org/2000/svg\" "
                       "font-family=\"sans-serif\" font-size=\"11\" fill=\"currentColor\">\n<title>{}</title>\n{}{}"
                       "</svg>\n",
                       width, height, escaped(title),
                       text_at(left, 16.0, "start", title, " font-weight=\"bold\" font-size=\"12\""), body);
}

}  // namespace stria::charts
