// The elements' share in the domain integrals about a tip. What the geometry says is worked out once: the interactions
// are linear in the displacement, and J weighs the energy momentum of each point alike in every increment.
#pragma once

#include <vector>

#include "coarse/elements/coarse_elements.hpp"
#include "common/fracture/domain_integral.hpp"

namespace stria::coarse {

class RingForms {
public:
    /// Of coarse elements, and of no other.
    RingForms(const CoarseElements& elements, int tip);

    [[nodiscard]] const std::vector<Annulus>& rings() const { return rings_; }

    /// One a ring, of a displacement alone. `elements`: on the same scene, some of those that the forms are of. `u`: of
    /// the whole mesh; near elements are read.
    [[nodiscard]] std::vector<DomainIntegral> values(const CoarseElements& elements, const Eigen::VectorXd& u) const;

    /// The same with the initial stress: summed point by point.
    [[nodiscard]] std::vector<DomainIntegral> values_with_initial_stress(const CoarseElements& elements,
                                                                         const Eigen::VectorXd& u) const;

private:
    template <class Operator>
    void append_forms(const Operator& op, std::span<const RingWeights::Entered> entered,
                      const AuxiliaryFields& auxiliary, const Scene& scene);

    int tip_;
    std::vector<Annulus> rings_;
    RingWeights weights_;
    // Element by element, ring by ring: I, then II, then T of each value of the element; the same of a rotation by 1.
    std::vector<double> forms_;
    std::vector<std::size_t> first_;  // of each element
};

}  // namespace stria::coarse
