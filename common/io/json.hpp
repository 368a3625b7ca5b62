// JSON of results: objects keep the order of their members, numbers that are not finite become null.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace stria {

using Json = nlohmann::ordered_json;

/// With an indent of two spaces, one member per line, ended by a line break. What is no UTF-8 in it is replaced: it may
/// hold the name of a file.
inline std::string text_of(const Json& value) {
    return value.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace stria
