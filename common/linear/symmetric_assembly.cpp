#include "common/linear/symmetric_assembly.hpp"

#include <algorithm>
#include <vector>

#include "common/index.hpp"

namespace stria {
namespace {

/// Calls visit(row, column) for each entry of the lower triangle that each element has, repeats included.
template <class Visit> void for_each_entry(const IndexLists& element_unknowns, Visit&& visit) {
    for (std::size_t e = 0; e < element_unknowns.size(); ++e) {
        for (const int column : element_unknowns[e]) {
            if (column < 0) continue;
            for (const int row : element_unknowns[e])
                if (row >= column) visit(row, column);
        }
    }
}

}  // namespace

SparseMatrix lower_pattern(const IndexLists& element_unknowns, int unknowns) {
    std::vector<int> first(at(unknowns) + 1, 0);
    for_each_entry(element_unknowns, [&](int, int column) { ++first[at(column) + 1]; });
    for (int column = 0; column < unknowns; ++column) first[at(column) + 1] += first[at(column)];
    std::vector<int> rows(at(first.back())), next(first.begin(), first.end() - 1);
    for_each_entry(element_unknowns, [&](int row, int column) { rows[at(next[at(column)]++)] = row; });

    SparseMatrix lower(unknowns, unknowns);
    int* const starts = lower.outerIndexPtr();
    int kept = 0;
    for (int column = 0; column < unknowns; ++column) {  // in place: what is kept never overtakes what is read
        const auto begin = rows.begin() + first[at(column)], end = rows.begin() + first[at(column) + 1];
        std::sort(begin, end);
        starts[column] = kept;
        kept += static_cast<int>(std::copy(begin, std::unique(begin, end), rows.begin() + kept) - rows.begin()) - kept;
    }
    starts[unknowns] = kept;
    lower.resizeNonZeros(kept);
    std::copy_n(rows.begin(), kept, lower.innerIndexPtr());
    std::fill_n(lower.valuePtr(), kept, 0.0);
    return lower;
}

void add_to_lower(SparseMatrix& lower, std::span<const int> unknowns, const Eigen::Ref<const Eigen::MatrixXd>& matrix) {
    for (std::size_t j = 0; j < unknowns.size(); ++j) {
        const int column = unknowns[j];
        if (column < 0) continue;
        const int* const begin = lower.innerIndexPtr() + lower.outerIndexPtr()[column];
        const int* const end = lower.innerIndexPtr() + lower.outerIndexPtr()[column + 1];
        for (std::size_t i = 0; i < unknowns.size(); ++i) {
            if (unknowns[i] < column) continue;
            const int* const place = std::lower_bound(begin, end, unknowns[i]);
            lower.valuePtr()[place - lower.innerIndexPtr()] +=
                matrix(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
        }
    }
}

}  // namespace stria
