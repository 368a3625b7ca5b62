// Jumps that strain little of the body: an equilibrium of their own within each iterate of Newton's method.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "fine/bulk/bulk.hpp"

namespace stria::fine {

/// The jump of a node strains what its elements have beyond the crack, and that may be slivers alone. Their metal flows
/// to and fro then from one iterate to the next, by more each time, for a plastic tangent goes too far by the ratio of
/// the tangents. So soft jumps are eliminated where metal flows: with all else as the iterate has it, they are in
/// equilibrium. What Newton's method goes on with is the problem that is left without them (nonlinear elimination:
/// Lanzkron, Rose and Wilkes, SIAM J. Sci. Comput. 17 (1996) 538; docs/equations.md).
class SoftJumps {
public:
    /// None.
    SoftJumps() = default;

    /// `boundary`: unknowns that are not the zone's own. `tolerance`: relative residual that Newton's method leaves.
    SoftJumps(const BulkElements& elements, const std::vector<int>& boundary, double tolerance);

    /// First unknowns of those that are soft, ascending.
    [[nodiscard]] std::vector<int> unknowns() const;

    /// Brings those in elements that flow to equilibrium with `load`, the forces on all unknowns but for those of the
    /// metal, N/mm. `u`: as the bulk was evaluated last, mm; their amplitudes change, and the bulk is evaluated there.
    /// `held`: unknowns that stay as they are.
    void settle(Bulk& bulk, Eigen::VectorXd& u, const Eigen::VectorXd& load, const UnknownSet& held) const;

private:
    struct Jump {
        int unknown;                // the first of its two
        std::vector<int> elements;  // in which it is not zero
    };
    /// An element, and where its unknowns that are a group's stand among its own and among the group's.
    struct Part {
        int element;
        std::vector<int> own, of_group;
    };
    /// Soft jumps that share elements which flow.
    struct Group {
        std::vector<int> unknowns;  // ascending
        std::vector<Part> parts;
    };
    struct Balance {
        Eigen::VectorXd residual;  // on a group's unknowns, N/mm
        double scale;              // the largest sum of nodal forces that add up to one of them
        [[nodiscard]] bool within(double share, double rounding) const;
    };

    [[nodiscard]] std::vector<Group> flowing(const Bulk& bulk, const UnknownSet& held) const;
    [[nodiscard]] Group group(std::vector<int> jumps, const Bulk& bulk) const;
    [[nodiscard]] static Balance balance(const Group& group, const Bulk& bulk, const Eigen::VectorXd& load);
    [[nodiscard]] static Eigen::VectorXd correction(const Group& group, const Bulk& bulk,
                                                    const Eigen::VectorXd& residual);
    void settle(const Group& group, Bulk& bulk, Eigen::VectorXd& u, const Eigen::VectorXd& load) const;

    double tolerance_ = 0.0;
    std::vector<Jump> jumps_;           // ascending
    std::vector<std::vector<int>> in_;  // of each element: its soft jumps, as numbers in jumps_
};

}  // namespace stria::fine
