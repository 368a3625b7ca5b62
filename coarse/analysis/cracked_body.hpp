// The body with its cracks as long as they are now: its scene, its nominal solution, and its structure.
#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/analysis/listener.hpp"
#include "coarse/fracture/nominal_solution.hpp"
#include "coarse/fracture/structure_rings.hpp"
#include "coarse/zone/tip_refinement.hpp"

namespace stria::coarse {

class CrackedBody {
public:
    /// Chooses the zone by eq. (3), or takes everything from a state of the same case. `scene`: of the cracks as they
    /// were at the start. `scene`, `effort` and `note` must outlive the body.
    CrackedBody(const Scene& scene, CoarseEffort& effort, const Note& note, const AnalysisState* from);

    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] const Structure& structure() const { return *structure_; }
    [[nodiscard]] const ElementSet& in_zone() const { return in_zone_; }
    [[nodiscard]] bool has_zone() const;

    /// Of the structure; those of the nominal solution serve.
    [[nodiscard]] StructureRings take_rings() {
        std::vector<RingForms> known = std::exchange(rings_, {});
        const bool serve = !known.empty() && std::ranges::all_of(known, [&](const RingForms& rings) {
            return rings.serve_beside(in_zone_);
        });
        return {structure_->elements(), serve ? std::move(known) : StructureRings::forms_of(structure_->elements())};
    }

    /// Elastic, traction-free stress intensities for the load factor 1, one per tip.
    [[nodiscard]] const std::vector<TipResult>& nominal() const { return nominal_; }
    /// That solution's displacement of the whole mesh, mm; empty where the guard knows this far body already.
    [[nodiscard]] const Eigen::VectorXd& nominal_displacement() const { return nominal_displacement_; }
    /// The K of eq. (3), MPa sqrt(mm), one per tip: the largest of the load history.
    [[nodiscard]] const std::vector<double>& largest_K() const { return largest_K_; }
    /// Of the cracks that the run began with.
    [[nodiscard]] const UnitResponse& nominal_at_start() const { return nominal_at_start_; }
    /// Of the present ones; and the growth of the first tip so far, mm.
    [[nodiscard]] UnitResponse nominal_response() const { return unit_response(*scene_, nominal_, unit_displacement_); }
    [[nodiscard]] double grown() const;
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
    [[nodiscard]] bool knows_far_part() const;
    [[nodiscard]] bool serves(const ElementSet& in_zone) const;
    [[nodiscard]] std::unique_ptr<Structure> condense(const Scene& scene, const ElementSet& in_zone,
                                                      const StillElements& still);
    void choose_behind(const Scene& longer);
    /// What is behind lies on the parts that the structure lies on.
    [[nodiscard]] bool lies_behind_middle() const {
        return still_of_nominal_.far == still_.far && still_of_nominal_.middle == still_.middle;
    }
    void keep_behind(const EnrichedMesh& on);
    [[nodiscard]] std::unique_ptr<Structure> take_nominal_of(const Scene& scene, const ElementSet& zone);
    [[nodiscard]] NominalSolution nominal_solution(const Scene& scene, bool far_known, const ElementSet& zone);
    [[nodiscard]] bool nominal_serves(const Scene& scene) const;
    void go_on_from(const AnalysisState& state);
    void find_largest_K(const Scene& scene);
    void note_if_large(const char* phase) const;

    const Scene* scene_;
    std::unique_ptr<Scene> grown_;  // the present one, once a crack has grown
    CoarseEffort& effort_;
    const Note& note_;
    ElementSet in_zone_;
    StillElements still_, still_of_nominal_;  // near_elements.hpp
    ElementSet settled_;                      // metal has flowed there, or a tip has left its functions
    MeshSplits splits_;                       // of the mesh of the start
    StructureFactors factors_;
    std::unique_ptr<Structure> structure_;
    std::vector<TipResult> nominal_;
    std::vector<RingForms> rings_;  // of the present scene, until they are taken
    Eigen::VectorXd nominal_displacement_;
    struct FieldsBesideFar {
        NominalFields fields;
        StillElements still;  // with which they were found
    };
    std::optional<FieldsBesideFar> nominal_fields_;  // of the present scene; none: not known near the tips alone
    UnitDisplacement unit_displacement_;             // of the nominal body
    std::vector<double> largest_K_;
    UnitResponse nominal_at_start_;
    double first_length_ = 0.0;  // of the crack of the first tip at the start, mm
};

}  // namespace stria::coarse
