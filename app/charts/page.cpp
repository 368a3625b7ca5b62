#include "app/charts/page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/charts/drawing.hpp"

namespace stria::charts {

namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; --ink: #222; --ground: #fff; --line: #ccc; --faint: #f4f5f7; --alarm: #fdf0e6; }
@media screen and (prefers-color-scheme: dark) {
  :root { --ink: #e4e6ea; --ground: #16181c; --line: #4a505a; --faint: #21252b; --alarm: #46301c; }
}
* { box-sizing: border-box; }
body { margin: 1.5rem auto; max-width: 76rem; padding: 0 1rem; font: 15px/1.45 sans-serif; color: var(--ink);
  background-color: var(--ground); }
h1 { font-size: 1.5rem; margin-bottom: .3rem; }
h2 { font-size: 1.15rem; margin: 2rem 0 .3rem; border-bottom: 1px solid var(--line); }
p { margin: .3rem 0; max-width: 60rem; }
.charts { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(22rem, 100%), 1fr)); gap: 1rem;
  align-items: start; }
.charts > .slides { grid-column: 1 / -1; }
.slides .charts { margin-top: .5rem; }
figure { margin: 0; }
svg, figure:not(.slides) { break-inside: avoid; }
figcaption { font-size: 13px; overflow-wrap: anywhere; }
svg { display: block; width: 100%; height: auto; }
input[type=range] { width: 100%; }
.frame { display: none; }
.frame.shown { display: inline; }
.facts { display: flex; flex-wrap: wrap; gap: .5rem; margin: .8rem 0; padding: 0; list-style: none; }
.facts li { background-color: var(--faint); border-radius: .3rem; padding: .3rem .7rem; }
.facts b { display: block; font-size: 1.1rem; }
.alarm { background-color: var(--alarm); padding: .5rem .8rem; border-radius: .3rem; }
.alarm ul { margin: .3rem 0; padding-left: 1.2rem; }
.wide { overflow-x: auto; }
pre { background-color: var(--faint); padding: .7rem; overflow: auto; max-height: 40rem; font-size: 12px; }
a { color: inherit; }
table { border-collapse: collapse; font-size: 13px; font-variant-numeric: tabular-nums; }
caption { text-align: left; padding: .3rem 0; }
th, td { padding: .2rem .6rem; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap; }
th { border-bottom: 1px solid var(--ink); vertical-align: bottom; }
td.word, th.word { text-align: left; }
tr.bad td { background-color: var(--alarm); }
@media print {
  @page { size: A4; margin: 14mm; }
  body { margin: 0; padding: 0; max-width: none; font-size: 10pt; }
  .charts { grid-template-columns: 1fr 1fr; }
  input[type=range], a.csv { display: none; }
  pre { max-height: none; white-space: pre-wrap; }
  h2 { break-after: avoid; }
}
)";

// Moves the sliders; without scripts a page shows one frame.
constexpr const char* script = R"(
for (const figure of document.querySelectorAll('.slides')) {
  const slider = figure.querySelector('input');
  const show = () => figure.querySelectorAll('.frame').forEach(
    frame => frame.classList.toggle('shown', frame.dataset.k === slider.value));
  slider.addEventListener('input', show);
  show();
}
)";

}  // namespace

std::string captioned(const std::string& svg, const std::string& caption) {
    return svg.empty() ? "" : fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", svg, caption);
}

std::string slides(const std::vector<std::string>& svgs, const std::vector<std::string>& names, std::size_t shown,
                   const std::string& caption) {
    std::string text = "<figure class=\"slides\">\n";
    if (names.size() > 1)
        text += fmt::format("<input type=\"range\" min=\"0\" max=\"{}\" value=\"{}\" aria-label=\"increment\">\n",
                            names.size() - 1, shown);
    for (std::size_t k = 0; k < names.size(); ++k)
        text += fmt::format("<span class=\"frame{}\" data-k=\"{}\">{}</span>\n", k == shown ? " shown" : "", k,
                            escaped(names[k]));
    return text + fmt::format("<div class=\"charts\">\n{}</div>\n<figcaption>{}</figcaption>\n</figure>\n",
                              fmt::join(svgs, ""), caption);
}

std::string section(Figure figure) {
    std::erase(figure.charts, "");
    if (figure.charts.empty() && figure.tables.empty()) return "";
    std::string text = fmt::format("<h2>{}</h2>\n", escaped(figure.title));
    if (!figure.sentence.empty()) text += fmt::format("<p>{}</p>\n", escaped(figure.sentence));
    text += fmt::format("<div class=\"charts\">\n{}</div>\n", fmt::join(figure.charts, ""));
    return figure.tables.empty() ? text : text + "<p>" + figure.tables + "</p>\n";
}

std::string page(const std::string& title, const std::string& body) {
    const bool slides = body.find("class=\"slides\"") != std::string::npos;
    return fmt::format("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
                       "<meta name=\"viewport\" content=\"width=device-width\">\n<title>{0}</title>\n"
                       "<style>{1}{2}</style>\n</head>\n<body>\n<h1>{0}</h1>\n{3}{4}</body>\n</html>\n",
                       escaped(title), style, colour_rules(), body,
                       slides ? fmt::format("<script>{}</script>\n", script) : "");
}

}  // namespace stria::charts
