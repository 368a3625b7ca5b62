#include "app/study/run_files.hpp"

#include <charconv>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string_view>

namespace stria::study {

namespace {

void collect(const nlohmann::json& object, const std::string& prefix, JsonObject& into) {
    for (const auto& [key, value] : object.items()) {
        if (value.is_object())
            collect(value, prefix + key + '.', into);
        else if (value.is_number())
            into.numbers[prefix + key] = value.get<double>();
        else if (value.is_string())
            into.words[prefix + key] = value.get<std::string>();
    }
}

std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t comma = line.find(','); comma != std::string_view::npos; comma = line.find(',')) {
        cells.push_back(line.substr(0, comma));
        line.remove_prefix(comma + 1);
    }
    cells.push_back(line);
    return cells;
}

double number_in(std::string_view cell) {
    double number = 0.0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    const bool whole = error == std::errc{} && end == cell.data() + cell.size();
    return whole ? number : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

JsonObject read_json(const std::filesystem::path& path) {
    JsonObject object;
    std::ifstream file(path);
    const nlohmann::json parsed = nlohmann::json::parse(file, nullptr, false);
    if (parsed.is_object()) collect(parsed, "", object);
    return object;
}

NumberTable read_table(const std::filesystem::path& path) {
    NumberTable table;
    std::ifstream file(path);
    std::string line;
    if (!std::getline(file, line)) return table;
    std::vector<std::vector<double>*> columns;
    for (const std::string_view name : cells_of(line)) columns.push_back(&table.columns[std::string(name)]);
    while (std::getline(file, line)) {
        const std::vector<std::string_view> cells = cells_of(line);
        if (cells.size() != columns.size()) break;
        for (std::size_t k = 0; k < cells.size(); ++k) columns[k]->push_back(number_in(cells[k]));
        ++table.rows;
    }
    return table;
}

}  // namespace stria::study
