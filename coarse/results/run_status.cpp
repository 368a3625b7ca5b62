#include "coarse/results/run_status.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace stria::coarse {

namespace {

constexpr std::array<std::pair<RunStatus, std::string_view>, 9> words_of_status = {
    {{RunStatus::NotRun, "not run"},
     {RunStatus::Running, "running"},
     {RunStatus::Done, "done"},
     {RunStatus::Interrupted, "interrupted"},
     {RunStatus::Failed, "failed"},
     {RunStatus::WrongInput, "wrong input"},
     {RunStatus::Lost, "lost"},
     {RunStatus::NoFile, "no file"},
     {RunStatus::Error, "error"}}};

}  // namespace

std::string to_text(RunStatus status) {
    const auto found = std::ranges::find(words_of_status, status, [](const auto& word) { return word.first; });
    return std::string(found->second);
}

std::optional<RunStatus> run_status(std::string_view text) {
    const auto found = std::ranges::find(words_of_status, text, [](const auto& word) { return word.second; });
    return found != words_of_status.end() ? std::optional(found->first) : std::nullopt;
}

}  // namespace stria::coarse
