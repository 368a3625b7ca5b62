// The numbers of a Gmsh file one after the other, as text or as bytes, with the place for complaints.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace stria::coarse {

class GmshInput {
public:
    /// `name` stands before complaints.
    GmshInput(std::string text, std::string name);

    /// From here on numbers of sections are bytes. The file must have the byte order of this machine.
    void be_binary();

    /// The name behind the next "$"; nothing at the end of the file.
    std::optional<std::string> next_section();

    /// Throws unless "$End<section>" comes next.
    void end_section(const std::string& section);
    void skip_section(const std::string& section);
    void skip_line();  // to where the next begins

    int integer();         // 4 bytes
    std::int64_t count();  // 8 bytes, not negative
    double real();

    /// Numbers and quoted words that are text in any file.
    int text_integer();
    double text_real();
    std::string quoted();

    /// Throws CaseError with the line, or with the byte of a binary file.
    [[noreturn]] void complain(const std::string& what) const;

private:
    std::string_view word();
    template <class T> T parsed();
    template <class T> T bytes();

    std::string text_, name_;
    std::size_t place_ = 0;
    bool binary_ = false;
};

}  // namespace stria::coarse
