#include "coupling/ranks/answers.hpp"

#include <algorithm>
#include <exception>
#include <numeric>

#include "common/error.hpp"

namespace stria::coupling {

void for_each_answer(const std::vector<FineScale*>& asked, const std::function<void(std::size_t)>& read) {
    std::vector<std::exception_ptr> failures(asked.size());
    std::vector<std::size_t> due(asked.size());
    std::iota(due.begin(), due.end(), std::size_t{0});
    while (!due.empty()) {
        const auto next = std::ranges::find_if(due, [&](std::size_t k) { return asked[k]->has_answered(); });
        if (next == due.end()) {
            asked[due.front()]->wait_a_moment();
            continue;
        }
        try {
            read(*next);
        } catch (const NumericalFailure&) {
            failures[*next] = std::current_exception();
        }
        due.erase(next);
    }
    for (const std::exception_ptr& failure : failures)
        if (failure) std::rethrow_exception(failure);
}

}  // namespace stria::coupling
