// The grid of a study: axes of settings, and every combination of their values.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stria::study {

/// A value for a case key, as `--set` takes it, or for one of the two run options `mode` and `fine_ranks`.
struct Setting {
    std::string key;
    std::string value;
    bool operator==(const Setting&) const = default;
};
using Settings = std::vector<Setting>;

struct Axis {
    std::string key;
    std::vector<std::string> values;
};

constexpr const char* mode_key = "mode";
constexpr const char* ranks_key = "fine_ranks";

/// Split at commas that stand outside brackets, braces and quotes; blanks around the parts are dropped.
std::vector<std::string> split_list(std::string_view text);

/// Nothing where the text is more than a number, or none.
std::optional<double> number_in(const std::string& text);

/// "fine.beta=1,2,4"; "load.blocks=[{max=50.0}],[{max=60.0}]". `option` is what complaints name. Throws CaseError.
Axis parse_axis(const std::string& text, const std::string& option = "--over");
Axis make_axis(const std::string& key, const std::vector<std::string>& values, const std::string& option);

/// "fine.beta=8,mesh.size=2". Throws CaseError.
Settings parse_settings(const std::string& text, const std::string& option);

/// Throws CaseError where a key has two axes, or an axis and a fixed value ("key=value").
void check_distinct(const std::vector<Axis>& axes, const std::vector<std::string>& fixed);

/// All combinations, the last axis fastest.
std::vector<Settings> combinations(const std::vector<Axis>& axes);

/// `settings` with the values of `by` where their keys agree; keys only in `by` follow.
Settings replaced(Settings settings, const Settings& by);

/// On the other axes.
Settings without(Settings settings, std::size_t axis);

/// "fine.beta=4, mesh.size=2"
std::string to_text(const Settings& settings);

/// What tells the values apart: without the text that all of them begin and end with, but no number or word is cut.
/// "[{max=50, ratio=0}]" and "[{max=50, ratio=0.5}]": "0" and "0.5".
std::vector<std::string> differing_parts(const std::vector<std::string>& values);

/// "03-fine.beta=4-mesh.size=2": the number with as many digits as `count` needs, at least two, and no character that
/// a shell or a file system minds.
std::string folder_name(int number, int count, const Settings& settings);

}  // namespace stria::study
