#include "fine/contact/faces_behind.hpp"

#include <algorithm>

namespace stria::fine {

std::vector<int> multipliers_of(const FaceOperators& operators, const FacesBehind& part) {
    std::vector<int> found;
    for (int k = 0; k < operators.multipliers(); ++k)
        if (part.contain(operators.crack(k), operators.middle(k))) found.push_back(k);
    if (!found.empty()) return found;
    for (const FaceStation& station : operators.stations())
        if (part.contain(station.crack, station.s))
            for (const auto& [multiplier, value] : operators.functions_at(station))
                if (multiplier >= 0) found.push_back(multiplier);
    std::ranges::sort(found);
    const auto twice = std::ranges::unique(found);
    found.erase(twice.begin(), twice.end());
    return found;
}

}  // namespace stria::fine
