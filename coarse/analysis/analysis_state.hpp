// What a run remembers between two increments: all that a checkpoint holds of an analysis.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "coarse/cycle/closure_measurement.hpp"
#include "coarse/cycle/cycle_meter.hpp"
#include "coarse/cycle/opening_swing.hpp"
#include "coarse/elements/coarse_elements.hpp"
#include "coarse/equilibrium/equilibrium.hpp"
#include "coarse/equilibrium/work_balance.hpp"
#include "coarse/fracture/fracture_parameters.hpp"
#include "coarse/growth/growth_increment.hpp"
#include "coarse/growth/rate_behind_turn.hpp"
#include "coarse/growth/tip_break.hpp"
#include "coarse/growth/tip_rates.hpp"
#include "coarse/load/load_controller.hpp"
#include "coarse/load/load_scale.hpp"
#include "coarse/model/mesh_refinement.hpp"
#include "coarse/structure/coarse_effort.hpp"
#include "common/index_set.hpp"
#include "coupling/zone_snapshot.hpp"

namespace stria::coarse {

/// Figure 3 (a) is to come at the load that is reached.
struct DueGrowth {
    bool due = false;
    int cycle = 0;
    double moment = 0.0;  // LoadStep::moment
};

/// The last maximum and the last minimum of a cycle that were reached.
struct ReachedExtremes {
    LoadFactors maximum, minimum;
    // One each; empty: there was no such extreme.
    std::vector<TipResult> tips = {}, tips_at_minimum = {};
    // Where faces touch and rings do not tell K of every tip; else none.
    FaceTractions faces = {}, faces_at_minimum = {};
};

/// Of CrackGrowth.
struct GrowthMemory {
    bool ended = false;  // growth has ended the run
    GrowthIncrementMemory increment;
    TipRatesMemory rates;
    std::vector<ReachedK> K_reached;  // one per tip
    std::vector<LengthAndK> before;   // what the tips had reached when they grew last
    ReachedExtremes extremes;
    TurningModes turning;
    bool turns_late = false;  // along an element edge, at the growth before: that has been said
    OpeningSwingMemory swing = {};
};

/// Figure 3 (b) under way: what holds the faces that the last growth has opened.
struct FaceRelease {
    int cycle = 0;        // in which the cracks have grown
    double moment = 0.0;  // LoadStep::moment of it
    double held = 0.0;    // share of the forces that is left; 0: nothing is under way
    double part = 1.0;    // share that is released next
    int cuts = 0;         // halvings of it in a row

    /// Share that is left once the next part is released.
    [[nodiscard]] double left() const { return std::max(held - part, 0.0); }
    /// That, at the load that has been reached.
    [[nodiscard]] LoadStep next(const Target& reached) const {
        LoadStep step;
        step.cycle = cycle;
        step.moment = moment;
        step.target = reached;
        step.target.held = left() / held;
        step.reversal = true;  // what flows while it grows is no part of the half cycles before and after
        step.releases = true;
        return step;
    }
    /// It is; after a halving the next part is twice as large.
    void advance() {
        held = left();
        if (cuts == 0) return;
        --cuts;
        part *= 2.0;
    }
    void halve() {
        ++cuts;
        part /= 2.0;
    }
};

/// Whatever else an analysis holds is a function of this and of the case. A run that goes on from it changes no digit.
struct AnalysisState {
    struct Polyline {
        std::vector<double> x, y;     // mm, one value per point
        double grown_at_start = 0.0;  // mm
    };
    std::vector<Polyline> cracks;    // one per crack of the case
    MeshSplits splits;               // of the mesh of the start, that it followed the tips with
    ElementSet settled;              // elements that are split no more
    ElementSet in_zone;              // elements inside the zone
    StillElements still;             // of the structure; the choice shows in the last bits
    StillElements still_of_nominal;  // likewise of the nominal solution's body
    Eigen::VectorXd displacement;    // of all unknowns of the mesh, mm; zero inside the zone
    double load_factor = 0.0;        // committed
    double largest_force = 0.0;      // largest scale of a residual up to now, N/mm
    ClosureMemory closure;
    CycleMemory cycle;                    // of the present cycle
    std::vector<CycleResult> last_cycle;  // one per tip, of the last cycle that ended
    std::vector<TipResult> nominal;       // one per tip, of the present crack lengths
    UnitDisplacement unit_displacement;   // of the same body
    RunCounts counts;
    GrowthMemory growth;
    std::vector<int> said_of_mesh;  // MeshJudge
    DueGrowth due_growth;
    FaceRelease release;
    LoadPosition load;
    WorkBalance work;
    EquilibriumState equilibrium;
    coupling::ZoneSnapshot zone;  // empty without a zone
};

}  // namespace stria::coarse
