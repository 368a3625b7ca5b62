// The faces of all cracks with contact in the zone: interface stations, multipliers, weighted gaps, and their statuses.
#pragma once

#include <Eigen/Core>
#include <set>
#include <vector>

#include "common/case/case.hpp"
#include "common/integration/crack_faces.hpp"
#include "common/integration/element_operator.hpp"
#include "common/linear/sparse.hpp"
#include "coupling/messages.hpp"
#include "fine/contact/contact_law.hpp"
#include "fine/contact/multiplier_space.hpp"
#include "fine/growth/frozen_tips.hpp"

namespace stria::fine {

class ContactInterface {
public:
    /// `boundary`: unknowns of the zone's boundary, ascending; every multiplier gets jumps that are not among them.
    /// `subcells`: interface elements are the crack's pieces cut by the s x s sub-quadrangles. `stiffness`: E', MPa.
    /// `frozen`: adds to the jump.
    ContactInterface(const EnrichedMesh& mesh, const std::vector<int>& boundary,
                     const std::vector<CrackSection>& cracks, int subcells, double stiffness,
                     const FrozenTips& frozen = {});

    [[nodiscard]] int multipliers() const { return static_cast<int>(weight_.size()); }

    /// B, one row a multiplier, one column an unknown of the mesh: B_k = integral of Phi_k n . N, lumped: Phi_k is
    /// taken at the centroid s_i of each node's share of the crack, which is exact for linear pressures. Where the
    /// crack follows the rows of the mesh each multiplier then holds the jump at its own node alone, and closed faces
    /// do not overlap between nodes.
    [[nodiscard]] const SparseRows& operator_B() const { return B_; }

    /// Weighted gaps g = (B u + g_0) / w, mm, with g_0 of the fixed jumps.
    [[nodiscard]] Eigen::VectorXd gaps(const Eigen::VectorXd& u) const;

    /// The same where faces may touch. A multiplier that is open and without pressure, and whose gap at settle() is
    /// wider than what jumps that have moved so far since can close, stays open: a gap above zero that is no wider than
    /// its own stands for it. `work` counts both.
    [[nodiscard]] Eigen::VectorXd gaps_that_matter(const Eigen::VectorXd& u, const Eigen::VectorXd& pressure,
                                                   coupling::WorkCounts& work) const;

    /// Adds -B^T p to a vector over the zone's unknowns: the faces push each other apart.
    void add_force(const Eigen::VectorXd& pressure, Eigen::VectorXd& force) const;

    /// Chooses the statuses for the next Newton step from pressures and gaps. Where a set of statuses comes back within
    /// one increment, only the worst multiplier is flipped from then on (docs/method.md, section 4).
    void choose_statuses(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap);
    /// From what was committed.
    void begin_increment();
    void commit(const Eigen::VectorXd& u);
    /// Takes the gaps of a committed displacement as those to start from.
    void settle(const Eigen::VectorXd& u);

    [[nodiscard]] const std::vector<std::int8_t>& statuses() const { return status_; }
    [[nodiscard]] const std::vector<std::int8_t>& committed_statuses() const { return committed_status_; }
    void restore(std::vector<std::int8_t> statuses) { status_ = committed_status_ = std::move(statuses); }
    [[nodiscard]] int status_changes() const { return changes_; }

    /// Largest complementarity residual as a force per thickness, N/mm.
    [[nodiscard]] double residual(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) const;

    /// The semismooth system for the present statuses. Closed: -B_k du = w_k g_k;  open: -d_k dp = d_k p_k, with
    /// d_k = w_k / c_k.
    [[nodiscard]] Eigen::VectorXd right_hand_side(const Eigen::VectorXd& pressure, const Eigen::VectorXd& gap) const;
    /// -d_k of all multipliers, whether open or not.
    [[nodiscard]] Eigen::VectorXd open_diagonal() const { return -weight_.cwiseQuotient(augmentation_); }

    /// How far behind a tip the farthest closed multiplier of its crack lies, mm; negative: none is closed.
    [[nodiscard]] double reach_behind(const Tip& tip) const;

    /// Pressure at a station from the multipliers, MPa.
    [[nodiscard]] double pressure_at(const FaceStation& station, const Eigen::VectorXd& pressure) const;

    [[nodiscard]] const std::vector<FaceStation>& stations() const { return stations_; }
    [[nodiscard]] std::int64_t interface_elements() const;

    /// Identity of each multiplier across a change of zone: crack and place of its node.
    struct Key {
        int crack;
        double s;
        Vec2 x;
        [[nodiscard]] bool is_at(int other_crack, const Vec2& place) const {
            return crack == other_crack && (x - place).norm() < 1e-9 * (1.0 + place.norm());
        }
    };
    [[nodiscard]] const std::vector<Key>& keys() const { return keys_; }

private:
    struct CrackSpace {
        int crack;
        double notch;
        int first_multiplier;
        MultiplierSpace space;
    };
    [[nodiscard]] const CrackSpace* space_of(int crack) const;
    [[nodiscard]] std::array<MultiplierSpace::Value, 2> functions_at(int crack, double s) const;
    void assemble(const EnrichedMesh& mesh, double stiffness);
    void find_closing();
    [[nodiscard]] double gap_of(Eigen::Index k, const Eigen::VectorXd& u) const;

    std::vector<CrackSpace> spaces_;
    std::vector<FaceStation> stations_;
    std::vector<Key> keys_;
    std::vector<int> jump_unknowns_;  // that B acts on, ascending
    SparseRows B_;
    Eigen::VectorXd weight_, augmentation_, fixed_gap_;
    Eigen::VectorXd closing_;  // most that a gap closes by where no jump unknown moves more than one
    Eigen::VectorXd settled_jumps_, settled_gap_;  // of what was committed
    std::vector<std::int8_t> status_, committed_status_;
    std::set<std::vector<std::int8_t>> visited_;
    bool one_at_a_time_ = false;
    int changes_ = 0;
};

}  // namespace stria::fine
