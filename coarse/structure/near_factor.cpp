#include "coarse/structure/near_factor.hpp"

#include <algorithm>

#include "common/linear/symmetric_assembly.hpp"

namespace stria::coarse {
namespace {

bool same_bits(const SparseMatrix& a, const SparseMatrix& b) {
    if (a.rows() != b.rows() || a.nonZeros() != b.nonZeros()) return false;
    return std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.rows() + 1, b.outerIndexPtr()) &&
           std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr()) &&
           std::equal(a.valuePtr(), a.valuePtr() + a.nonZeros(), b.valuePtr());
}

}  // namespace

SparseMatrix near_stiffness(const CoarseElements& elements, const IndexLists& of_elements, int unknowns,
                            const FarBody* far) {
    const Scene& scene = elements.scene();
    SparseMatrix lower = lower_pattern(of_elements, unknowns);
    std::size_t k = 0;
    elements.for_each(elements.near(), [&](const auto& op) {
        add_to_lower(lower, of_elements[k++], op.stiffness(scene.stiffness(op.element)));
    });
    if (far != nullptr) add_to_lower(lower, of_elements[k], far->tangent());
    return lower;
}

std::shared_ptr<const NearFactor> factor_near(SparseMatrix lower, int boundary,
                                              std::shared_ptr<const NearFactor> known) {
    if (known && known->boundary == boundary && same_bits(known->matrix, lower)) return known;
    auto leaf = std::make_shared<const SparseLeaf>(boundary, SparseMatrix(lower));
    return std::make_shared<const NearFactor>(std::move(lower), boundary, std::move(leaf));
}

}  // namespace stria::coarse
