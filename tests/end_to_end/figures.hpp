// Figures that a README of a case gives, read from its tables.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/folders.hpp"

namespace stria::test {

/// The number that a cell begins with, NaN where it begins with none. Digits may stand in groups: "118 600 cycles".
inline double figure_in(std::string cell) {
    for (std::size_t i = 1; i + 1 < cell.size(); ++i)
        if (cell[i] == ' ' && std::isdigit(cell[i - 1]) != 0 && std::isdigit(cell[i + 1]) != 0) cell.erase(i--, 1);
    const char* text = cell.c_str();
    char* end = nullptr;
    const double figure = std::strtod(text, &end);
    return end == text ? std::nan("") : figure;
}

/// The cells behind `row` ("J | largest load") of the table that has it, in the README of a shipped case. Throws
/// std::out_of_range where no row begins so.
inline std::vector<double> figures_of(const std::string& name, const std::string& row) {
    std::ifstream readme(std::filesystem::path(source_folder) / "cases" / name / "README.md");
    const std::string begin = "| " + row + " |";
    for (std::string line; std::getline(readme, line);) {
        if (!line.starts_with(begin)) continue;
        std::istringstream rest(line.substr(begin.size()));
        std::vector<double> figures;
        for (std::string cell; std::getline(rest, cell, '|');) figures.push_back(figure_in(cell));
        return figures;
    }
    throw std::out_of_range(name + " has no row " + row);
}

}  // namespace stria::test
