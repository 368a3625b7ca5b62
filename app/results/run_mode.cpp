#include "app/results/run_mode.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <utility>

#include "common/error.hpp"

namespace stria {
namespace {

constexpr std::array<std::pair<RunMode, std::string_view>, 3> words_of_mode = {
    {{RunMode::Mpi, "mpi"}, {RunMode::InProcess, "inprocess"}, {RunMode::Monolithic, "monolithic"}}};

}  // namespace

std::string to_text(RunMode mode) {
    return std::string(std::ranges::find(words_of_mode, mode, &std::pair<RunMode, std::string_view>::first)->second);
}

RunMode run_mode(std::string_view word, const std::string& option) {
    const auto known = std::ranges::find(words_of_mode, word, &std::pair<RunMode, std::string_view>::second);
    if (known == words_of_mode.end())
        throw CaseError(fmt::format("{}={}: must be mpi, inprocess or monolithic", option, word));
    return known->first;
}

}  // namespace stria
