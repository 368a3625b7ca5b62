// Where the contact multipliers of one crack live: hats on a trace coarser than the mesh, which keeps the pressure free
// of oscillations for every position of the crack in it (docs/method.md, section 4).
#pragma once

#include <array>
#include <vector>

#include "common/crack/notch.hpp"
#include "common/enrichment/enriched_mesh.hpp"

namespace stria::fine {

/// Continuous piecewise-linear pressure p(s) = sum of p_k Phi_k(s) with a node at each *vital* crossing: walking along
/// the crack, a crossing of an element edge is vital if neither end of that edge belongs to a vital one before it
/// (Bechet, Moes, Wohlmuth 2009). So every multiplier has jump unknowns of its own, however the crack cuts the mesh.
/// The walk goes from the crack's origin to its tips: growth adds nodes and takes none away, and which end of the crack
/// is its first is no matter.
/// At a mouth a second one may share a node with the first, where a corner of the element is cut off: if it is half an
/// edge of that element away from both its neighbours and all their nodes have jumps of their own, they are independent
/// (docs/equations.md, two multipliers at a mouth). Else the hat at the mouth spans two elements, and faces that touch
/// at the mouth alone overlap there, for they meet in the mean over it.
/// Branches end at kinks and at a notch: at kinks the pressure may jump there. One that is much shorter than an element
/// has next to no jumps of its own, and goes with its neighbour, the one nearer to the origin. The pressure is constant
/// towards a tip, and straight on towards any other end that is no farther than the next node, unless that would leave
/// the multiplier there without a weight, or that is the one at a tip.
class MultiplierSpace {
public:
    /// One multiplier at each of `points`, ascending arc lengths, constant half way to the next: the paper's plain
    /// space. It has more conditions than the jump has freedom, and serves comparisons.
    explicit MultiplierSpace(const std::vector<double>& points);

    /// From the pieces of `crack` outside of its `notch`. `boundary`: unknowns, ascending, that are not the zone's own;
    /// crossings whose jumps are all among them carry no multiplier. `origin`: arc length, of a place that stays where
    /// it is in the body.
    MultiplierSpace(const EnrichedMesh& mesh, const std::vector<int>& boundary, int crack, const Notch& notch,
                    double origin = 0.0);

    [[nodiscard]] int size() const { return static_cast<int>(nodes_.size()); }
    /// Every multiplier has jump unknowns of its own.
    [[nodiscard]] bool is_stable() const { return stable_; }

    struct Value {
        int multiplier;
        double value;
    };
    /// The at most two multipliers that act at an arc length, adding up to one; -1: none.
    [[nodiscard]] std::array<Value, 2> acting_at(double s) const;

    /// Index of the branch that holds an arc length; -1: none.
    [[nodiscard]] int branch(double s) const;

    /// Arc length of each multiplier's node.
    [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }
    /// Arc length that stands for what a multiplier says of the faces: its node, or the middle of the branch that it
    /// has alone. A node is at a crossing, of a short branch at either end.
    [[nodiscard]] double middle(int multiplier) const;

private:
    struct Crossing {
        double s;
        double edge;             // mm, its length; 0: the crossing is at a node
        std::vector<int> nodes;  // whose unknowns make the jump there
    };
    struct Branch {
        double first_s, last_s;
        bool tip_at_start = false, tip_at_end = false;
        double element_size = 0.0;  // mm, where it begins
        std::vector<Crossing> crossings;
        int first_multiplier = 0, multipliers = 0;
    };
    void split_into_branches(const EnrichedMesh& mesh, int crack, const Notch& notch);
    void join_short_branches(double origin);
    void choose_vital(const EnrichedMesh& mesh, const std::vector<int>& boundary, double origin, Branch& branch);
    /// From the outer one of two multipliers or more to the branch's end; `inwards`: 1 from its start, -1 from its end.
    [[nodiscard]] bool goes_straight_on(const Branch& branch, int outer, int inwards) const;

    std::vector<Branch> branches_;
    std::vector<double> nodes_;
    bool stable_ = true;
};

}  // namespace stria::fine
