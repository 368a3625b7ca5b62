// The jumps across all faces with contact in the zone, weighted by the multipliers: interface stations, and the
// operators B of the gaps and T of the slips.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "common/case/case.hpp"
#include "common/index.hpp"
#include "common/integration/crack_faces.hpp"
#include "common/linear/sparse.hpp"
#include "fine/contact/multiplier_space.hpp"
#include "fine/growth/frozen_tips.hpp"

namespace stria::fine {

class FaceOperators {
public:
    /// `boundary`: unknowns of the zone's boundary, ascending; every multiplier gets jumps that are not among them.
    /// `subcells`: interface elements are the crack's pieces cut by the s x s sub-quadrangles. `frozen`: adds to the
    /// jump.
    FaceOperators(const EnrichedMesh& mesh, const std::vector<int>& boundary, const std::vector<CrackSection>& cracks,
                  int subcells, const FrozenTips& frozen);

    /// Pressures, one per multiplier. Multipliers of cracks with friction transmit a shear besides; a vector of all
    /// tractions, MPa, has the pressures first and then those shears, in the order of their multipliers.
    [[nodiscard]] int multipliers() const { return static_cast<int>(weight_.size()); }
    [[nodiscard]] int tractions() const { return multipliers() + static_cast<int>(with_shear_.size()); }
    /// Place of a multiplier's shear among the tractions; -1: it has none.
    [[nodiscard]] int shear_of(int k) const { return shear_of_[at(k)]; }

    /// B, one row per multiplier, one column per unknown of the mesh: B_k = integral of Phi_k n . N, lumped: Phi_k is
    /// taken at the centroid s_i of each node's share of the crack, which is exact for linear pressures. Where the
    /// crack follows the rows of the mesh each multiplier then holds the jump at its own node alone, and closed faces
    /// do not overlap between nodes. What is frozen counts as it did when it was of unknowns.
    [[nodiscard]] const SparseRows& operator_B() const { return B_; }
    /// The same of the slip, with the tangent in place of n; rows of multipliers without shear are empty.
    [[nodiscard]] const SparseRows& operator_T() const { return T_; }

    /// Of a multiplier: the integral of its Phi_k, mm, and Coulomb's coefficient.
    [[nodiscard]] double weight(int k) const { return weight_[k]; }
    [[nodiscard]] const Eigen::VectorXd& weights() const { return weight_; }
    [[nodiscard]] double friction(int k) const { return friction_[k]; }
    [[nodiscard]] bool is_stable(int k) const { return space_of(keys_[at(k)].crack).space.is_stable(); }
    /// Multipliers with a shear, ascending.
    [[nodiscard]] const std::vector<int>& with_shear() const { return with_shear_; }

    /// Weighted gaps g = (B u + g_0) / w, mm, with g_0 of the fixed jumps, and slips likewise: of all multipliers, or
    /// of one. A gap that is no more than rounding is none.
    [[nodiscard]] Eigen::VectorXd gaps(const Eigen::VectorXd& u) const;
    [[nodiscard]] Eigen::VectorXd slips(const Eigen::VectorXd& u) const;
    [[nodiscard]] double gap(int k, const Eigen::VectorXd& u) const;
    [[nodiscard]] double slip(int k, const Eigen::VectorXd& u) const;

    /// Adds -B^T p + T^T tau to a vector over the zone's unknowns: the faces push each other apart and brake each
    /// other.
    void add_force(const Eigen::VectorXd& traction, Eigen::VectorXd& force) const;

    /// What pressures would do by a trapezoid on the way from one state to another, N per mm of thickness. It is not
    /// zero where faces part or meet, and those do no work: either the pressure or the gap is none all the way.
    struct End {
        const Eigen::VectorXd& u;
        const Eigen::VectorXd& traction;
    };
    [[nodiscard]] double work_by_trapezoid(const End& from, const End& to) const;

    /// The unknowns of the mesh that a multiplier acts on: those of its row of B, then the others of its row of T.
    [[nodiscard]] std::vector<int> acts_on(int k) const;

    /// The at most two multipliers that act at a station, with their shares; -1: none.
    using Acting = std::array<MultiplierSpace::Value, 2>;
    [[nodiscard]] Acting functions_at(const FaceStation& station) const {
        return functions_at(station.crack, station.s);
    }

    [[nodiscard]] const std::vector<FaceStation>& stations() const { return stations_; }
    /// The multipliers that act at each of them.
    [[nodiscard]] const std::vector<Acting>& acting() const { return acting_; }
    /// Of faces without contact: of cracks that have none, and of notches.
    [[nodiscard]] const std::vector<FaceStation>& free_stations() const { return free_stations_; }
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
    /// Of a multiplier: its crack, and where on it what it says is said, as in MultiplierSpace.
    [[nodiscard]] int crack(int k) const { return keys_[at(k)].crack; }
    [[nodiscard]] double middle(int k) const { return middle_[at(k)]; }
    /// Of each multiplier the one at its place among those of other faces, -1: none. Both go along the cracks, so that
    /// most are found at once.
    [[nodiscard]] std::vector<int> places_in(const FaceOperators& others) const;

private:
    struct CrackSpace {
        int crack;
        int first_multiplier;
        MultiplierSpace space;
    };
    [[nodiscard]] const CrackSpace& space_of(int crack) const;
    [[nodiscard]] Acting functions_at(int crack, double s) const;
    [[nodiscard]] MultiplierSpace space_on(const EnrichedMesh& mesh, const std::vector<int>& boundary, int crack,
                                           const CrackSection& section) const;
    void number_shears(const std::vector<CrackSection>& cracks);
    /// Per multiplier: of the faces that it acts on the part that is not smooth.
    [[nodiscard]] Eigen::VectorXd rough_shares(const std::vector<CrackSection>& cracks) const;
    class Shares;
    void assemble(const EnrichedMesh& mesh, const Shares& shares);
    void add_frozen(const EnrichedMesh& mesh, const Shares& shares, const FrozenTips& frozen);
    void keep_open_without_faces();

    std::vector<CrackSpace> spaces_;
    std::vector<FaceStation> stations_, free_stations_;
    std::vector<Acting> acting_;  // at stations_
    std::vector<Key> keys_;
    std::vector<double> middle_;
    std::vector<int> with_shear_, shear_of_;  // multiplier of each shear, and back
    SparseRows B_, T_;
    Eigen::VectorXd weight_, friction_;
    Eigen::VectorXd fixed_gap_, fixed_slip_;  // times the weight
};

}  // namespace stria::fine
