#include "app/study/variants/table.hpp"

#include <limits>

namespace stria::study {

double Row::error(const std::string& result) const {
    const auto found = errors.find(result);
    return found != errors.end() ? found->second : std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> columns(const std::vector<Axis>& axes, bool with_errors) {
    std::vector<std::string> names = {"variant"};
    for (const Axis& axis : axes) names.push_back(axis.key);
    names.insert(names.end(), {"status", "exit_code"});
    for (const Quantity& size : sizes()) names.emplace_back(size.name);
    for (const Quantity& phase : phases()) names.push_back(std::string(phase.name) + "_s");
    for (const Quantity& count : work()) names.emplace_back(count.name);
    for (const Quantity& result : results()) names.emplace_back(result.name);
    if (with_errors) {
        for (const Quantity& result : results()) names.push_back(std::string("error_") + result.name);
        names.emplace_back("reference");
    }
    names.insert(names.end(), {"folder", "message"});
    for (const Quantity& ending : endings()) names.emplace_back(ending.name);
    if (with_errors)
        for (const Quantity& ending : endings()) names.push_back(std::string("error_") + ending.name);
    return names;
}

std::vector<Cell> cells(const Row& row, bool with_errors) {
    std::vector<Cell> line = {std::int64_t{row.number}};
    for (const Setting& setting : row.settings) line.emplace_back(setting.value);
    line.emplace_back(to_text(row.outcome.status));
    line.emplace_back(std::int64_t{row.outcome.exit_code});
    for (const auto& group : {sizes(), phases(), work(), results()})
        for (const Quantity& quantity : group) line.emplace_back(row.outcome.value(quantity.name));
    if (with_errors) {
        for (const Quantity& result : results()) line.emplace_back(row.error(result.name));
        line.emplace_back(row.reference);
    }
    line.emplace_back(row.folder);
    line.emplace_back(row.outcome.message);
    for (const Quantity& ending : endings()) line.emplace_back(row.outcome.value(ending.name));
    if (with_errors)
        for (const Quantity& ending : endings()) line.emplace_back(row.error(ending.name));
    return line;
}

}  // namespace stria::study
