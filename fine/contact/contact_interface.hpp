// Contact and friction on the faces of all cracks in the zone: statuses of the multipliers, and their part of the
// semismooth system.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <vector>

#include "common/case/case.hpp"
#include "common/integration/crack_faces.hpp"
#include "common/integration/element_operator.hpp"
#include "common/linear/sparse.hpp"
#include "coupling/messages.hpp"
#include "fine/contact/contact_law.hpp"
#include "fine/contact/face_operators.hpp"
#include "fine/contact/faces_behind.hpp"
#include "fine/contact/resting_faces.hpp"
#include "fine/contact/status_search.hpp"

namespace stria::fine {

class ContactInterface {
public:
    /// As FaceOperators. `stiffness`: E', MPa, for the augmentation.
    ContactInterface(const EnrichedMesh& mesh, const std::vector<int>& boundary,
                     const std::vector<CrackSection>& cracks, int subcells, double stiffness,
                     const FrozenTips& frozen = {});

    [[nodiscard]] const FaceOperators& operators() const { return operators_; }
    [[nodiscard]] int multipliers() const { return operators_.multipliers(); }
    [[nodiscard]] int tractions() const { return operators_.tractions(); }
    [[nodiscard]] int shear_of(int k) const { return operators_.shear_of(k); }

    /// Weighted gaps, and weighted slips in excess of those of the displacement given to settle(), mm. Of faces that
    /// were apart there, and closing, the slip counts from where they would meet: until then nothing brakes it. They
    /// are taken to go on as approach() says (docs/equations.md).
    struct Jumps {
        Eigen::VectorXd gap, slip;  // per multiplier
    };
    [[nodiscard]] Jumps jumps(const Eigen::VectorXd& u) const;

    /// The same where faces may touch. A multiplier that is open and without pressure, and whose gap at settle() is
    /// wider than what jumps that have moved so far since can close, stays open: a gap above zero that is no wider than
    /// its own stands for it. `work` counts both. Slips of faces apart are left at zero. One at rest has what it had
    /// at settle().
    [[nodiscard]] Jumps jumps_that_matter(const Eigen::VectorXd& u, const Eigen::VectorXd& traction,
                                          coupling::WorkCounts& work) const;

    /// Chooses the statuses for the next Newton step from tractions and jumps: by the law, and as StatusSearch says.
    void choose_statuses(const Eigen::VectorXd& traction, const Jumps& jumps);
    /// From what was committed. `apart`: from open faces, which the first choice leaves so.
    void begin_increment(bool apart = false);

    /// All faces touch and none has been looked at: a part that nothing else holds would float if they were apart.
    void begin_touching();
    void commit(const Eigen::VectorXd& u, double next_over_this = 1.0);
    /// A half cycle ends.
    void note_half_cycle() { resting_.note_half_cycle(); }
    /// Takes the gaps of a committed displacement as those to start from, and its slips as those to hold.
    void settle(const Eigen::VectorXd& u);

    /// But for slips, which count from these, mm: functions have gone that had made a part of them.
    void hold_slips(Eigen::VectorXd slips) { settled_slip_ = std::move(slips); }
    [[nodiscard]] const Eigen::VectorXd& settled_slips() const { return settled_slip_; }

    [[nodiscard]] const std::vector<FaceStatus>& statuses() const { return status_; }
    [[nodiscard]] const std::vector<FaceStatus>& committed_statuses() const { return committed_status_; }
    /// How faces go that are apart: what their gaps and slips grew by in the last increment, and what those that close
    /// are to slide until they meet, mm. Others, and faces of which nothing is known, have zeros.
    struct Approach {
        Eigen::VectorXd widened, slid, until_met;  // per multiplier
    };
    [[nodiscard]] const Approach& approach() const { return approach_; }
    /// Where the way of the loads has a bend, how faces went tells nothing of how they go on.
    void forget_approach();
    /// What was committed; settle() is to follow.
    void restore(std::vector<FaceStatus> statuses, Approach approach);

    // What rests takes no part in choose_statuses(), residual(), right_hand_side() and awake(): who condenses it has
    // taken its matrix, and its unknowns follow the others.

    [[nodiscard]] const RestingFaces& resting() const { return resting_; }
    RestingFaces& resting() { return resting_; }
    /// A steady one that does not slide and has jumps of its own.
    [[nodiscard]] bool may_rest(int k) const { return resting_.is_steady(k) && !slides(k) && operators_.is_stable(k); }
    /// What those at rest do where they came to rest, at a displacement: minus their forces on the mesh, then their
    /// right_hand_side().
    [[nodiscard]] Eigen::VectorXd rest_load(const Eigen::VectorXd& displacement) const;
    /// Of those at rest, the ones whose status a state would change; their jumps there are written into `jumps`.
    [[nodiscard]] std::vector<int> would_change(const Eigen::VectorXd& u, const Eigen::VectorXd& traction,
                                                Jumps& jumps) const;
    /// Tractions of those awake, zero of the others.
    [[nodiscard]] Eigen::VectorXd awake(Eigen::VectorXd traction) const;
    /// As residual(), of what is left of the equations of those at rest.
    [[nodiscard]] double residual_at_rest(const Eigen::VectorXd& right_hand_side) const;
    [[nodiscard]] int status_changes() const { return changes_; }

    /// Largest residual of the law as a force per thickness, N/mm.
    [[nodiscard]] double residual(const Eigen::VectorXd& traction, const Jumps& jumps) const;

    /// The semismooth system for the present statuses, one equation per traction, d_k = w_k / c_k. Closed:
    /// -B_k du = w_k g_k; stick: T_k du = -w_k slip_k; slip: -d_k (dtau -+ mu dp) = d_k (tau -+ mu p); open:
    /// -d_k dp = d_k p_k, likewise the shear.
    [[nodiscard]] Eigen::VectorXd right_hand_side(const Eigen::VectorXd& traction, const Jumps& jumps) const;

    /// A multiplier as an element of the semismooth system: the unknowns of the mesh that it acts on, then its
    /// tractions, numbered from `first_traction` on.
    [[nodiscard]] std::vector<int> unknowns_of(int k, int first_traction) const;
    /// Its matrix on them: symmetric unless it slides. Open multipliers push no more: their columns are left away.
    [[nodiscard]] Eigen::MatrixXd matrix_of(int k) const;
    [[nodiscard]] bool slides(int k) const { return fine::slides(status_[at(k)]); }

    /// Tractions as the statuses want them, to the last digit: none where faces are open, the bound where they slide.
    void clean(Eigen::VectorXd& traction) const;

    /// What sliding has dissipated on the way from one state to the next, N per mm of thickness: mean bound times slip,
    /// from where it was reached, as far as the faces touched.
    [[nodiscard]] double dissipated(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                                    const Jumps& jumps) const;

    /// Contact on a part of the faces behind a tip: above zero where a multiplier there is closed, the largest
    /// pressure; below where all are open, minus c times the smallest gap (MPa); minus infinity where there are none.
    /// So it passes zero where contact is lost or made. `jumps`: as jumps_that_matter() has them at `u`.
    [[nodiscard]] double contact_behind(const FacesBehind& part, const Eigen::VectorXd& traction, const Jumps& jumps,
                                        const Eigen::VectorXd& u) const;
    /// The multiplier nearest to the tip on that part that is pressed. It slides by more than `rounding`, mm: where
    /// faces transmit nothing any more rounding says whether they slide. A pressure that as small a gap would make up
    /// for is none: at the very load at which faces meet or part rounding says whether they touch.
    [[nodiscard]] coupling::NearestContact nearest_behind(const FacesBehind& part, const Eigen::VectorXd& traction,
                                                          const Jumps& jumps, double rounding) const;

    /// At a station from the multipliers: pressure and shear, MPa, and whether the one with the larger share slides.
    struct FaceTraction {
        double pressure = 0.0, shear = 0.0;
        bool slides = false;
    };
    [[nodiscard]] FaceTraction traction_at(const FaceStation& station, const Eigen::VectorXd& traction) const {
        return traction_of(operators_.functions_at(station), traction);
    }
    /// At each of operators().stations().
    [[nodiscard]] std::vector<FaceTraction> tractions_at_stations(const Eigen::VectorXd& traction) const;

private:
    [[nodiscard]] FaceTraction traction_of(const FaceOperators::Acting& acting, const Eigen::VectorXd& traction) const;
    [[nodiscard]] CoulombContact law(int k) const { return {operators_.friction(k), augmentation_[k]}; }
    [[nodiscard]] FaceStatus status_at(int k, const FaceState& state) const {
        return law(k).is_undecided(state) ? status_[at(k)] : law(k).status(state);
    }
    [[nodiscard]] FaceState state_of(int k, const Eigen::VectorXd& traction, const Jumps& jumps) const;

    FaceOperators operators_;
    Eigen::VectorXd augmentation_;
    std::vector<int> jump_unknowns_;  // that B acts on, ascending
    Eigen::VectorXd closing_;         // most that a gap closes by where no jump unknown moves more than one
    Eigen::VectorXd settled_jumps_, settled_gap_, settled_slip_;  // of what was committed
    Approach approach_;
    std::vector<FaceStatus> status_, committed_status_;
    RestingFaces resting_;
    StatusSearch search_;
    bool begins_apart_ = false;
    int changes_ = 0;
};

}  // namespace stria::fine
