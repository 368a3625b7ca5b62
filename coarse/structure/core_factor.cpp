#include "coarse/structure/core_factor.hpp"

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

SparseMatrix core_stiffness(const CoarseElements& elements, const IndexLists& of_elements, int unknowns,
                            const BodyPart* below) {
    const Scene& scene = elements.scene();
    SparseMatrix lower = lower_pattern(of_elements, unknowns);
    std::size_t k = 0;
    elements.for_each(elements.core(), [&](const auto& op) {
        add_to_lower(lower, of_elements[k++], op.stiffness(scene.stiffness(op.element)));
    });
    if (below != nullptr) add_to_lower(lower, of_elements[k], below->tangent());
    return lower;
}

std::shared_ptr<const CoreFactor> factor_core(SparseMatrix lower, int boundary,
                                              std::shared_ptr<const CoreFactor> known) {
    if (known && known->boundary == boundary && same_bits(known->matrix, lower)) return known;
    auto leaf = std::make_shared<const SparseLeaf>(boundary, SparseMatrix(lower));
    return std::make_shared<const CoreFactor>(std::move(lower), boundary, std::move(leaf));
}

}  // namespace stria::coarse
