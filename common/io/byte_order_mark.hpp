// What some editors and spreadsheets put before the first letter of a text.
#pragma once

#include <string_view>

namespace stria {

inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // of UTF-8

}  // namespace stria
