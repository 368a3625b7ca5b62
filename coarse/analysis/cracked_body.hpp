// The body with its cracks as long as they are now: its scene, its nominal solution, and its structure.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "coarse/analysis/nominal_body.hpp"
#include "coarse/fracture/structure_rings.hpp"
#include "coarse/zone/tip_refinement.hpp"

namespace stria::coarse {

/// What a growth of the cracks makes of a scene.
struct GrownScene {
    std::unique_ptr<Scene> longer;      // null: growth ends the run
    std::unique_ptr<FinerScene> finer;  // the present cracks on the mesh of `longer`; null: it is the present mesh
};

class CrackedBody {
public:
    /// Chooses the zone by eq. (3), or takes everything from a state of the same case. `scene`: of the cracks as they
    /// were at the start. `scene`, `effort` and `note` must outlive the body. Throws CaseError where cracks of the
    /// state have left functions that it does not hold (growth.retain = "all").
    CrackedBody(const Scene& scene, CoarseEffort& effort, const Note& note, const AnalysisState* from);

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] const Structure& structure() const { return *structure_; }
    [[nodiscard]] const ElementSet& in_zone() const { return in_zone_; }
    [[nodiscard]] bool has_zone() const;

    /// Of the structure; those of the nominal solution serve.
    [[nodiscard]] StructureRings take_rings() {
        std::vector<RingForms> known = nominal_.take_rings(in_zone_);
        return {structure_->elements(),
                known.empty() ? StructureRings::forms_of(structure_->elements()) : std::move(known)};
    }

    /// Elastic, traction-free stress intensities for the load factor 1, one per tip.
    [[nodiscard]] const std::vector<TipResult>& nominal() const { return nominal_.tips(); }
    /// What tractions on the faces add to that under loads (NominalBody).
    [[nodiscard]] std::vector<TipResult> K_of_faces(const LoadFactors& loads, const FaceTractions& tractions) const {
        return nominal_.K_of_faces(*scene_, loads, tractions, factors_);
    }
    /// That solution's displacement of the whole mesh, mm; empty where the guard knows this far body already.
    [[nodiscard]] const Eigen::VectorXd& nominal_displacement() const { return nominal_.displacement(); }
    /// The K of eq. (3), MPa sqrt(mm), one per tip: the largest of the load history.
    [[nodiscard]] const std::vector<double>& largest_K() const { return nominal_.largest_K(); }
    /// Of the cracks that the run began with.
    [[nodiscard]] const UnitResponse& nominal_at_start() const { return nominal_at_start_; }
    /// By that (K_behind_turns.hpp).
    [[nodiscard]] std::vector<double> K_of_closure() const;
    /// Of the present ones; and of that what the loaded boundary does.
    [[nodiscard]] UnitResponse nominal_response() const { return nominal_.response(*scene_); }
    [[nodiscard]] const UnitDisplacement& unit_displacement() const { return nominal_.unit_displacement(); }
    /// By which the first tip has grown so far, mm.
    [[nodiscard]] double grown() const { return nominal_.grown(); }
    /// A unit of the load history as a target (load_scale.hpp).
    [[nodiscard]] double load_scale() const;

    /// Condenses what is not in the zone onto the zone's boundary, with whatever serves of the factors before. `still`:
    /// null: as near_elements.hpp chooses.
    void condense_onto(const ElementSet& in_zone, const StillElements* still = nullptr);

    /// The present cracks on smaller elements, where the tips of longer ones come near to large ones. Null: they do
    /// not. Elements in which metal has flowed, or tips have been, stay whole.
    [[nodiscard]] std::unique_ptr<FinerScene> finer_about_ends_of(const std::vector<CrackSection>& longer) const;

    /// The same where elements outside the zone that would flow are larger than a small share of their distance from
    /// the tips. `inside`: elements of the zone that flow with them.
    [[nodiscard]] std::unique_ptr<FinerScene> finer_about_flow(const std::vector<int>& outside,
                                                               const ElementSet& inside) const;

    /// What take_finer() has turned from.
    struct Outgrown {
        std::unique_ptr<Scene> scene;  // null: that of the start
        std::unique_ptr<Structure> structure;
    };
    /// Turns to it. The displacement of the present mesh, mm, becomes that of the new one, the same field. What has
    /// been split joins the zone. There is no structure until take() or condense_onto().
    Outgrown take_finer(FinerScene finer, Eigen::VectorXd& displacement);

    /// Metal has flowed in an increment: points per element of the zone, ascending.
    void note_flow(const std::vector<std::int32_t>& yielding_points);

    /// What the zone holds now, and the elements whose functions longer cracks change.
    [[nodiscard]] ElementSet zone_with_changes(const Scene& longer) const;

    /// At least these, and what eq. (3) is expected to want about the tips of longer cracks.
    [[nodiscard]] ElementSet zone_expected_about(const Scene& longer, ElementSet at_least) const;

    /// `expected`: zone_expected_about() the same cracks. These, and what eq. (3) wants about the tips, whose nominal
    /// solution is that of the longer cracks from here on.
    [[nodiscard]] ElementSet zone_about(const Scene& longer, ElementSet expected);

    /// Longer cracks beside the functions of the tips that they leave (growth.retain = "all"); else null.
    [[nodiscard]] std::unique_ptr<Scene> keeping_functions(const Scene& longer) const;

    /// The present displacement, mm, on the mesh of longer cracks; zero for new functions.
    [[nodiscard]] Eigen::VectorXd carried_to(const Scene& longer, const Eigen::VectorXd& displacement) const;

    /// Figure 3 (a): the cracks are longer and nothing else changes. `keeping`: keeping_functions() of them, or null.
    /// condense_onto() is to follow.
    void take(std::unique_ptr<Scene> longer, std::unique_ptr<Scene> keeping);

    void write(AnalysisState& state) const;

private:
    [[nodiscard]] ElementSet whole_elements() const;
    [[nodiscard]] std::unique_ptr<FinerScene> finer(const std::vector<RefinedDisk>& disks,
                                                    const ElementSet& whole) const;
    [[nodiscard]] bool serves(const ElementSet& in_zone) const;
    void choose_behind(const Scene& longer);
    void go_on_from(const AnalysisState& state);

    const Scene* scene_;
    std::unique_ptr<Scene> grown_;  // the present one, once a crack has grown
    CoarseEffort& effort_;
    const Note& note_;
    ElementSet in_zone_;
    StillElements still_;  // near_elements.hpp
    ElementSet settled_;   // metal has flowed there, or a tip has left its functions
    MeshSplits splits_;    // of the mesh of the start
    StructureFactors factors_;
    std::unique_ptr<Structure> structure_;
    NominalBody nominal_;
    UnitResponse nominal_at_start_;
};

}  // namespace stria::coarse
