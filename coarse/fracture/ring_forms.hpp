// The elements' share in the domain integrals about a tip. What the geometry says is worked out once: the interactions
// are linear in the displacement, and J weighs the energy momentum of each point alike in every increment.
#pragma once

#include <vector>

#include "coarse/elements/coarse_elements.hpp"
#include "common/fracture/domain_integral.hpp"

namespace stria::coarse {

class RingForms {
public:
    /// Of coarse elements, and of no other. `for_K`: of these of_K() asks alone; of size zero: there are none.
    RingForms(const CoarseElements& elements, int tip, const ElementSet& for_K = {});

    [[nodiscard]] const std::vector<Annulus>& rings() const { return rings_; }

    /// values() may be asked for beside a zone: it holds all elements that have told nothing but K.
    [[nodiscard]] bool serve_beside(const ElementSet& zone) const;

    /// One a ring, of a displacement alone. `elements`: on the same scene, some of those that the forms are of. `u`: of
    /// the whole mesh; near elements are read.
    [[nodiscard]] std::vector<DomainIntegral> values(const CoarseElements& elements, const Eigen::VectorXd& u) const;

    /// The same of the first ring that tells K (first_for_K()), of all elements that the forms are of, without J: no
    /// operator is asked for.
    [[nodiscard]] DomainIntegral of_K(const Eigen::VectorXd& u) const;

    /// The same with the initial stress: summed point by point.
    [[nodiscard]] std::vector<DomainIntegral> values_with_initial_stress(const CoarseElements& elements,
                                                                         const Eigen::VectorXd& u) const;

private:
    /// Of some elements, in all of the rings or in one.
    struct Part {
        std::size_t first_ring;  // among all of them
        RingWeights weights;
        // Element by element its rotation, of each of its values; then ring by ring I, then II, then T of each value,
        // and the same of a rotation by 1.
        std::vector<double> forms = {};
        std::vector<int> unknowns = {};
        std::vector<std::size_t> first = {}, first_unknown = {0};  // of each element, in these two
        std::vector<double> area = {};                             // of each element, mm2

        /// What the element at a place adds to the k-th ring that it enters, but for J.
        template <class Values>
        [[nodiscard]] DomainIntegral interactions(std::size_t place, std::size_t k, const Values& element_u) const;
        /// In one of all rings.
        [[nodiscard]] DomainIntegral interactions_in(std::size_t ring, const Eigen::VectorXd& u) const;
    };
    void find_forms(const CoarseElements& elements, Part& part) const;
    template <class Operator>
    void append_forms(const Operator& op, const AuxiliaryFields& auxiliary, const Scene& scene, Part& part) const;

    int tip_;
    std::vector<Annulus> rings_;
    Part all_, for_K_;
};

}  // namespace stria::coarse
