#include "common/io/json.hpp"

#include <cmath>
#include <fmt/format.h>

#include "common/io/whole_file.hpp"

namespace stria {
namespace {

std::string escaped(const std::string& text) {
    std::string result = "\"";
    for (const char c : text) {
        switch (c) {
        case '"':
            result += "\\\"";
            break;
        case '\\':
            result += "\\\\";
            break;
        case '\n':
            result += "\\n";
            break;
        case '\t':
            result += "\\t";
            break;
        default:
            if (static_cast<unsigned char>(c) < 0x20) {
                result += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
            } else {
                result += c;
            }
        }
    }
    return result + '"';
}

}  // namespace

void Json::append_to(std::string& text, const std::string& indent) const {
    const std::string inner = indent + "  ";
    const auto append_list = [&](char open, char close, const auto& list, const auto& append_item) {
        text += open;
        for (std::size_t k = 0; k < list.size(); ++k) {
            text += k > 0 ? ",\n" : "\n";
            text += inner;
            append_item(list[k]);
        }
        if (!list.empty()) text += '\n' + indent;
        text += close;
    };
    if (const auto* boolean = std::get_if<bool>(&value_)) {
        text += *boolean ? "true" : "false";
    } else if (const auto* integer = std::get_if<std::int64_t>(&value_)) {
        text += fmt::format("{}", *integer);
    } else if (const auto* number = std::get_if<double>(&value_); number && std::isfinite(*number)) {
        text += fmt::format("{}", *number);
    } else if (const auto* string = std::get_if<std::string>(&value_)) {
        text += escaped(*string);
    } else if (const auto* array = std::get_if<Array>(&value_)) {
        append_list('[', ']', *array, [&](const Json& item) { item.append_to(text, inner); });
    } else if (const auto* object = std::get_if<Object>(&value_)) {
        append_list('{', '}', *object, [&](const Member& member) {
            text += escaped(member.key) + ": ";
            member.value.append_to(text, inner);
        });
    } else {
        text += "null";
    }
}

std::string Json::text() const {
    std::string result;
    append_to(result, "");
    return result + '\n';
}

void write_json(const std::filesystem::path& path, const Json& value) { write_whole_text(path, value.text()); }

}  // namespace stria
