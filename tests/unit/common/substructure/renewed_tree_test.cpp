// A later tree takes over the fronts of an earlier one that would be the same.
#include "common/substructure/front_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "common/error.hpp"
#include "common/index.hpp"
#include "tests/support/front_grid.hpp"

namespace stria {
namespace {

class RenewedFrontTree : public testing::TestWithParam<Symmetry> {};
INSTANTIATE_TEST_SUITE_P(Symmetries, RenewedFrontTree, testing::Values(Symmetry::Symmetric, Symmetry::General),
                         test::name_of_symmetry);

/// A tree over a part of a grid's elements, with all their unknowns numbered anew.
struct PartOfGrid {
    PartOfGrid(const test::FrontGrid& grid, std::vector<int> elements_) : elements(std::move(elements_)) {
        std::map<int, int> number;
        for (const int e : elements) {
            std::vector<int> unknowns;
            for (const int unknown : grid.layout.element_unknowns[at(e)])
                unknowns.push_back(number.try_emplace(unknown, static_cast<int>(number.size())).first->second);
            layout.element_unknowns.push_back(unknowns);
            layout.centres.push_back(grid.layout.centres[at(e)]);
            matrices.push_back(grid.matrices[at(e)]);
        }
        layout.unknowns = static_cast<int>(number.size());
        for (const int unknown : grid.layout.boundary)
            if (number.contains(unknown)) layout.boundary.push_back(number[unknown]);
    }
    /// Of each element: where it is in another part, if its matrix is the same; else -1.
    [[nodiscard]] std::vector<int> places_in(const PartOfGrid& other) const {
        std::vector<int> places;
        for (std::size_t k = 0; k < elements.size(); ++k) {
            const auto found = std::ranges::find(other.elements, elements[k]);
            const auto place = found - other.elements.begin();
            const bool same = found != other.elements.end() && other.matrices[at(place)] == matrices[k];
            places.push_back(same ? static_cast<int>(place) : -1);
        }
        return places;
    }

    std::vector<int> elements;
    FrontTree::Layout layout;
    std::vector<Eigen::MatrixXd> matrices;
};

std::vector<int> all_elements_but(const test::FrontGrid& grid, const std::vector<int>& left_out) {
    std::vector<int> elements;
    for (int e = 0; e < std::ssize(grid.matrices); ++e)
        if (std::ranges::find(left_out, e) == left_out.end()) elements.push_back(e);
    return elements;
}

// The bits are those of a tree that begins, in much less work: elements have come, one has another matrix.
TEST_P(RenewedFrontTree, ALaterTreeTakesOverTheFrontsThatAreTheSame) {
    test::FrontGrid grid(100, 4, GetParam());
    grid.ground();
    const PartOfGrid before(grid, all_elements_but(grid, {99, 199, 299, 399}));
    grid.matrices[3] *= 1.5;
    PartOfGrid after(grid, all_elements_but(grid, {}));
    FrontTree old(before.layout), fresh(after.layout);
    old.factor(before.matrices, std::vector<char>(before.matrices.size(), 1), grid.symmetry);
    FrontTree tree(after.layout, old, after.places_in(before));
    tree.factor(after.matrices, std::vector<char>(after.matrices.size(), 0), grid.symmetry);
    fresh.factor(after.matrices, std::vector<char>(after.matrices.size(), 1), grid.symmetry);
    EXPECT_EQ(tree.tangent(), fresh.tangent());
    const Eigen::VectorXd load = Eigen::VectorXd::LinSpaced(after.layout.unknowns, -1.0, 1.0);
    const ReducedLoad ours = tree.reduce(load), theirs = fresh.reduce(load);
    EXPECT_EQ(tree.expand(ours, ours.boundary), fresh.expand(theirs, theirs.boundary));
    EXPECT_LT(tree.refactored(), fresh.refactored() / 2);
    EXPECT_GT(tree.refactored(), 0);
}

TEST_P(RenewedFrontTree, ATreeTakesNothingFromOneThatWasNotFactored) {
    test::FrontGrid grid(9, 7, GetParam());
    grid.keep_outline();
    FrontTree old(grid.layout), fresh(grid.layout);
    std::vector<int> all(grid.matrices.size());
    std::iota(all.begin(), all.end(), 0);
    FrontTree tree(grid.layout, old, all);
    tree.factor(grid.matrices, grid.changed, grid.symmetry);
    fresh.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(tree.tangent(), fresh.tangent());
    EXPECT_EQ(tree.refactored(), fresh.refactored());
    FrontTree again(grid.layout, tree, all);
    again.factor(grid.matrices, grid.changed, grid.symmetry);
    EXPECT_EQ(again.tangent(), fresh.tangent());
    EXPECT_EQ(again.refactored(), 0);
}

}  // namespace
}  // namespace stria
