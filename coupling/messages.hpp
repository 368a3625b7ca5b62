// What the two components say to each other: plain values. Layouts are packed in wire.cpp.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "common/enrichment/enriched_mesh.hpp"
#include "common/fracture/domain_sums.hpp"
#include "common/integration/moved_field.hpp"
#include "common/predictor.hpp"
#include "common/substructure/substructure.hpp"
#include "coupling/frozen_tip.hpp"
#include "coupling/work_counts.hpp"

namespace stria::coupling {

/// First words, both ways.
struct Hello {
    std::uint32_t protocol = 0;
    std::uint64_t case_digest = 0;
};

/// A ring of the domain integrals about a tip (domain_integral.hpp).
struct Ring {
    std::int32_t tip = 0, number = 0;               // of the tip's rings
    double inner_radius = 0.0, outer_radius = 0.0;  // mm
    double element = 0.0;                           // edge of the one that holds the tip, mm
};

/// The last increments as guesses about new tips (MovedField), on all unknowns of a new mesh, mm: a column each, the
/// last of all first.
struct MovedIncrements {
    TipMoves moves;
    Eigen::MatrixXd displacement;
};

/// The zone: sent once per geometry, and again when the zone is extended.
struct Patch {
    EnrichedMesh mesh;                // its elements only; ids refer to the whole mesh
    std::vector<int> boundary;        // unknowns of `mesh` shared with the structure or prescribed (Gamma), ascending
    Eigen::VectorXd unit_load;        // on the other unknowns of `mesh`, per unit load factor, N/mm; zero on Gamma
    Eigen::MatrixXd case_loads = {};  // likewise, a column per load case (load_factors.hpp); none where all are zero
    Eigen::VectorXd displacement;  // committed displacement of all unknowns of `mesh`; the fine component keeps its own
                                   // where it has one, and starts elements that are new to it from sigma = C eps(u)
    std::vector<Ring> rings;       // those that zone elements have a share in
    std::vector<double> opening_at;  // per tip: distance behind it, mm, at which the opening is asked for; or empty
    std::vector<std::vector<double>> contact_at;  // per tip: distances behind it, mm, beyond which contact is asked for
    std::vector<double> ahead;  // per tip: radius, mm, of the sector ahead of it whose normal stress is asked for;
                                // empty: nobody asks
    std::vector<std::vector<double>> slip_at;  // per tip: distances behind it, mm, at which is asked whether the faces
                                               // slide; empty: nobody asks
    bool anew = false;           // others have held its elements meanwhile: who gets it forgets all that it knows
    bool shared = false;         // by several ranks: none of them knows increments on both sides of a seam
    MovedIncrements moved = {};  // those of all of them; no columns: they are forgotten
    std::vector<int> part_of;    // per element of `mesh`: id in the whole mesh before of the element of which it is a
                                 // part, and therefore new; -1: of none; empty: no element has been split
};

/// Displacements of the zone's boundary, each Newton iteration.
struct PatchDisplacement {
    /// Several ranks keep their factors together or not at all: what is out of balance in each comes first, and the
    /// rest of the answers when it is known what they shall do. Of a question for the rest keeps_factor alone is new.
    enum class Wanted : std::int8_t { Whole, Residuals, Rest };
    Wanted wanted = Wanted::Whole;
    int iteration = 0;         // 0: first of an increment
    Predictor predictor = {};  // of the zone's interior, in that first iteration
    bool put_aside = false;    // in that first iteration: the trial state that it leaves is wanted as a predictor
    double load_factor = 0.0;
    Eigen::VectorXd cases = {};  // factors of the load cases
    bool further = false;        // Gamma has moved on, or back, along the correction before ...
    double step = 1.0;           // ... by this part of it, and the interior goes with it; 1: a new correction
    double held = 0.0;           // share of the forces on faces that growth has opened that still holds them
    double settled_below = 0.0;  // N/mm: where residuals are no larger the last factor serves once more
    bool keeps_factor = false;   // the same, where it has been decided
    double last_below = 0.0;     // N/mm: where it is not much larger this state may be the last of its increment
    bool check_rest = false;     // look at the elements at rest: this state may be the last
    bool elastic = false;        // no point flows in this iterate, whatever its stress
    bool opens_faces = false;    // a growth opens faces with some rank of a shared zone
    Eigen::VectorXd boundary;    // total displacement on Gamma, in the order of Patch::boundary
};

/// The contact nearest to a tip at or beyond a distance behind it, and how many there are.
struct NearestContact {
    double behind = std::numeric_limits<double>::infinity();  // the tip, mm; infinity: there is none
    double pressure = 0.0;                                    // MPa
    // |tau + c slip| - mu p, MPa, with the slip of this increment: zero or below where it sticks, above where it
    // slides; minus infinity without friction.
    double excess = -std::numeric_limits<double>::infinity();
    std::int32_t closed = 0, sliding = 0;  // multipliers at or beyond the distance

    [[nodiscard]] bool slides() const { return excess > 0.0; }
    [[nodiscard]] bool operator==(const NearestContact&) const = default;
};

/// Digest of the internal-variable state: crosses at every Newton step.
struct Digest {
    std::vector<std::int32_t> yielding_points;  // per zone element
    double largest_plastic_increment = 0.0;
    std::vector<std::int8_t> status;  // per multiplier: 0 open, 1 stick or frictionless, 2 and 3 slip on and back
    std::vector<double> multiplier;   // per multiplier: pressure, MPa
    std::int32_t status_changes = 0;  // against the iteration before
    std::vector<std::vector<double>> contact;  // per tip and distance, where the patch asks: largest p - c g at or
                                               // beyond it, MPa: above zero where faces touch; -infinity: no faces
    std::vector<double> opening;               // per tip, where the patch asks: mm; NaN: not in the zone
    std::vector<double> force_ahead;           // per tip, where the patch asks: integral of the normal stress ahead, N
    std::vector<std::vector<NearestContact>> nearest;  // per tip and distance, where the patch asks
};

/// The zone's answer: a nonlinear superelement.
struct PatchResponse {
    Eigen::VectorXd force;             // condensed internal force on Gamma, N/mm
    CondensedTangent tangent;          // on Gamma; empty where `same_tangent`
    bool same_tangent = false;         // the tangent is that of the last response
    bool may_keep_factor = false;      // no multiplier has changed its status since the last one
    bool keeps_factor = false;         // the correction takes it, whatever has changed since
    Eigen::VectorXd due;               // with the residuals: the zone's part of what is out of balance on Gamma, N/mm
    Eigen::VectorXd unit_load;         // the zone's own loads condensed onto Gamma: minus d force / d load factor
    double interior_residual = 0;      // largest interior force residual, N/mm
    double interior_force = 0;         // largest internal nodal force, the scale of that residual
    double contact_residual = 0;       // largest complementarity residual, as a force
    double interior_correction = 0;    // largest change of an interior displacement since the last call, mm
    double interior_displacement = 0;  // largest interior displacement, mm
    double along = 0;                  // work of all that is out of balance along the last correction, taken whole, N
    double along_before = 0;           // likewise, where that correction began
    bool provisional = false;          // elements at rest have not been looked at: one of them may yield
    bool woken = false;                // some would, which iterates before this one did not see
    bool opens_faces = false;          // a growth opens faces here: stress goes where it has not been
    Digest digest;
};

/// One station of the crack faces.
struct FaceSample {
    std::int32_t crack = 0;
    double s = 0, x = 0, y = 0, opening = 0, slip = 0, pressure = 0, shear = 0;
    std::int32_t status = 0;  // 0 open, 1 stick or frictionless contact, 2 slip
    bool in_wake = false;     // of metal that has flowed
};

/// The zone's share in the integrals over a ring: bulk and faces under pressure.
struct RingReport {
    std::int32_t tip = 0, number = 0;
    DomainIntegral sums;
};

/// Elements with metal that has flowed, by their distances from the tip that is nearest to it. Each begins less than an
/// element's size beyond those before it.
struct FlowShell {
    double begin = 0, end = 0;  // mm, of the elements, and how far flow may begin that goes on from there
    double reach = 0;           // mm, largest distance of a point that has flowed
    double axis = 0;            // mm, likewise, within 15 degrees of the crack's line ahead
};

/// What a tip shows inside the zone.
struct TipReport {
    double CTOD = -1;  // mm; negative: the 90 degree intercept is not in the zone
    // mm, at the distance behind it that the patch asks for; NaN: not in the zone
    double opening = std::numeric_limits<double>::quiet_NaN();
    // Ascending, apart from one another (flow_shells.hpp): in this half cycle but for the wake, and ever.
    std::vector<FlowShell> flow = {}, flow_ever = {};
};

/// The zone's share in the balance of work, N (per mm of thickness).
struct EnergyReport {
    double stored = 0;    // elastic and by hardening, in all points: a state
    double released = 0;  // in this increment by faces that a growth has opened (docs/equations.md, work balance)
    double friction = 0;  // dissipated in this increment by faces that slide
    // N: in this increment, what a trapezoid says that pressures do which faces gain or lose. They do none on the way.
    double contact = 0;
    double load_path = 0;             // mm: displacement in this increment that the zone's own unit loads do work on
    Eigen::VectorXd case_paths = {};  // likewise, one per load case; empty where none loads the zone itself
};

/// What a commit is to do and to tell.
struct Commit {
    bool reversal = false;        // the load turned after this increment: plastic zones start anew
    bool bends = false;           // the loads go on in another direction
    double next_over_this = 1.0;  // sizes of increments: not 1 where one has been halved
    bool brief = false;           // nobody reads rings
    bool no_faces = false;        // nor faces
    bool releases = false;        // faces that growth has opened, here or with another rank: no part of a half cycle
};

/// After commit.
struct StepReport {
    std::vector<TipReport> tips;
    std::vector<RingReport> rings;       // one per ring of the patch; empty in brief
    std::vector<FaceSample> faces;       // ordered by crack and s; empty where nobody reads them
    std::vector<double> contact_length;  // per crack, mm
    std::vector<double> mouth_opening;   // per crack: at its mouth; NaN where the zone does not hold that
    double dissipation = 0;              // N, per mm of thickness: by flow, in this increment
    EnergyReport energy;
    std::int64_t points = 0, unknowns = 0, multipliers = 0;
    WorkCounts work;
    double constitutive_s = 0, contact_s = 0, factor_s = 0;  // time so far per phase
};

/// Full internal-variable state and interior displacements: at commits that need them.
struct ZoneState {
    Eigen::VectorXd displacement;        // all unknowns of the patch's mesh
    std::vector<std::int32_t> element;   // per point: element of the patch's mesh
    std::vector<std::int8_t> side;       // per point: crack side, 0 in uncut elements
    std::vector<double> x, y, weight;    // per point
    std::vector<double> stress;          // 4 per point, Mandel
    std::vector<double> plastic_strain;  // 4 per point, Mandel
    std::vector<double> accumulated;     // per point
    std::vector<FrozenTip> frozen_tips;  // what `displacement` lacks
};

}  // namespace stria::coupling
