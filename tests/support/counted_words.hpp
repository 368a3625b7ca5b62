// How often a text says something.
#pragma once

#include <string>

namespace stria::test {

inline int count(const std::string& text, const std::string& word) {
    int found = 0;
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
    return found;
}

}  // namespace stria::test
