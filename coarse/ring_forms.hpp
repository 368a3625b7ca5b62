// The structure's share in the domain integrals about a tip, made once: the interactions are linear in its
// displacement.
#pragma once

#include <array>
#include <vector>

#include "common/fem/domain_integral.hpp"

namespace stria::coarse {

class Structure;

class RingForms {
public:
    RingForms(const Structure& structure, int tip);

    [[nodiscard]] const std::vector<Annulus>& rings() const { return rings_; }

    /// One a ring. `u`: displacement of the whole mesh.
    [[nodiscard]] std::vector<DomainIntegral> values(const Structure& structure, const Eigen::VectorXd& u) const;

private:
    [[nodiscard]] RingSums sums(const Structure& structure) const;

    int tip_;
    std::vector<Annulus> rings_;
    std::vector<char> entered_;                                // per element: coarse, and in a ring
    std::vector<std::array<Eigen::VectorXd, 3>> interaction_;  // per ring: I, II, T per displacement of the whole mesh
};

}  // namespace stria::coarse
