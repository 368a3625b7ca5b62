// The structure's share in the domain integrals about a tip. What the geometry says is worked out once: the
// interactions are linear in the displacement, and J weighs the energy momentum of each point alike in every increment.
#pragma once

#include <vector>

#include "coarse/elements/coarse_elements.hpp"
#include "common/fracture/domain_integral.hpp"
#include "common/index_lists.hpp"

namespace stria::coarse {

/// How often their values are asked for: to work out what the geometry says costs more than one answer.
enum class Asked { Once, InEachIncrement };

class RingForms {
public:
    RingForms(const CoarseElements& elements, int tip, Asked asked = Asked::InEachIncrement);

    [[nodiscard]] const std::vector<Annulus>& rings() const { return rings_; }

    /// One a ring, of a displacement alone. `u`: of the whole mesh; near elements are read.
    [[nodiscard]] std::vector<DomainIntegral> values(const CoarseElements& elements, const Eigen::VectorXd& u) const;

    /// The same with the initial stress: summed point by point.
    [[nodiscard]] std::vector<DomainIntegral> values_with_initial_stress(const CoarseElements& elements,
                                                                         const Eigen::VectorXd& u) const;

private:
    void weigh(const CoarseElements& elements);
    [[nodiscard]] std::vector<int> number_unknowns(const CoarseElements& elements);
    template <class Operator>
    void add_element(const Operator& op, const RingSums& geometry, const Scene& scene, const std::vector<int>& place);
    [[nodiscard]] std::vector<DomainIntegral> summed_up(const CoarseElements& elements, const Eigen::VectorXd& u,
                                                        bool with_initial_stress) const;

    int tip_;
    Asked asked_;
    std::vector<Annulus> rings_;
    std::vector<int> elements_;     // coarse ones on which q varies in some ring, ascending
    IndexLists entered_;            // of each: the rings in which it does
    std::vector<Vec2> weights_;     // element by element, point by point, ring by ring of these: weight times grad q
    std::vector<int> unknowns_;     // of the whole mesh, that these elements see, ascending
    Eigen::MatrixXd interactions_;  // a column for each of these; rows I, II, T of the first ring, of the second, ...
};

}  // namespace stria::coarse
