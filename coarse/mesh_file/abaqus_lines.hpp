// The lines of an .inp file: a keyword with its parameters, and the data behind it.
#pragma once

#include <cstdint>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace stria::coarse {

/// "*ELEMENT, TYPE=CPS4, ELSET=plate"; words without their case, values as they are.
struct Keyword {
    std::string word;                               // "*ELEMENT"
    std::map<std::string, std::string> parameters;  // "TYPE": "CPS4"; without a value: empty

    [[nodiscard]] std::string value(const std::string& parameter) const;
};

std::string upper_case(std::string text);

class AbaqusLines {
public:
    /// `name` stands before complaints.
    AbaqusLines(std::string text, std::string name);

    /// Comments and empty lines are left out. False at the end of the file.
    bool next_keyword(Keyword& keyword);

    /// The cells of the next line of data; false where a keyword or the end of the file comes.
    bool next_data(std::vector<std::string>& cells);

    [[nodiscard]] std::int64_t whole(const std::string& cell) const;
    [[nodiscard]] double real(const std::string& cell) const;

    /// Throws CaseError with the line read last.
    [[noreturn]] void complain(const std::string& what) const;

private:
    bool next_line();

    std::istringstream text_;
    std::string name_, line_;
    int number_ = 0;
    bool waits_ = false;  // line_ has been read, and not been used
};

}  // namespace stria::coarse
