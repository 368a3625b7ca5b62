// The nominal body with the present cracks: elastic, whole, its crack faces free of traction. Its K is K_1(a).
#pragma once

#include <memory>
#include <vector>

#include "coarse/analysis/analysis_state.hpp"
#include "coarse/analysis/listener.hpp"
#include "coarse/fracture/nominal_solution.hpp"

namespace stria::coarse {

/// Beside the structure it is condensed anew where a crack has grown, on the far and middle parts that both share. What
/// is behind the tips, wakes included, is its own.
class NominalBody {
public:
    /// `effort` and `note` must outlive the body.
    NominalBody(CoarseEffort& effort, const Note& note) : effort_(effort), note_(note) {}

    /// Its response to the load factor 1. `zone`: elements that will be in the zone; of size zero: none. `shared`:
    /// factors of the structure; what of far and middle parts did not serve is made anew in them. Returns the body;
    /// null where it has functions of its own.
    [[nodiscard]] std::unique_ptr<Structure> solve(const Scene& scene, const ElementSet& zone,
                                                   StructureFactors& shared);

    /// What a state knows of it. `scene`: of its cracks; `is_other`: than that which has been solved.
    void go_on_from(const AnalysisState& state, const Scene& scene, bool is_other);
    void write(AnalysisState& state) const;

    /// Stress intensities for the load factor 1, one per tip.
    [[nodiscard]] const std::vector<TipResult>& tips() const { return tips_; }
    /// Displacement of the whole mesh, mm; empty where the far body was known before, and with it how it answers.
    [[nodiscard]] const Eigen::VectorXd& displacement() const { return displacement_; }
    /// Of the load history, of what is ahead as well, which a run that goes on may know better: MPa sqrt(mm), one per
    /// tip.
    [[nodiscard]] const std::vector<double>& largest_K() const { return largest_K_; }
    [[nodiscard]] UnitResponse response(const Scene& scene) const {
        return unit_response(scene, tips_, unit_displacement_);
    }
    [[nodiscard]] const UnitDisplacement& unit_displacement() const { return unit_displacement_; }

    /// What tractions on the faces of the present cracks add to the K of its tips, one each; without wedges
    /// (leave_out_wedges()). `loads`: under which they were told.
    [[nodiscard]] std::vector<TipResult> K_of_faces(const Scene& scene, const LoadFactors& loads,
                                                    FaceTractions tractions, StructureFactors shared) const;
    /// The growth of the first tip so far, mm.
    [[nodiscard]] double grown() const { return first_length_ > 0.0 ? tips_.front().a - first_length_ : 0.0; }

    /// Hands out those of the present scene; empty where they do not serve beside a zone.
    [[nodiscard]] std::vector<RingForms> take_rings(const ElementSet& in_zone);

    /// The parts that the structure stands on. `apart`: its own serve on where they are the same.
    void stand_on(const StillElements& still, bool apart);
    /// Whether it stands on them.
    [[nodiscard]] bool stands_on(const StillElements& still) const {
        return still_.far == still.far && still_.middle == still.middle;
    }
    /// What is behind the tips serves as long as none of its functions changes from one mesh to the next.
    void keep_behind(const Scene& from, const Scene& to);
    void forget_behind() { behind_.reset(); }
    [[nodiscard]] bool has_behind() const { return !still_.behind.none(); }
    void put_behind(ElementSet elements) { still_.behind = std::move(elements); }

    /// Elements have been split: the mesh has so many, and answers of the one before do not serve.
    void turn_to_finer(std::size_t elements);
    /// The same body with functions of more tips.
    void carry_over_to(const EnrichedMesh& from, const EnrichedMesh& to);

private:
    [[nodiscard]] NominalSolution solve_whole(const Scene& scene, bool far_known, const ElementSet& for_K,
                                              StructureFactors& shared);
    void find_largest_K(const Scene& scene);

    CoarseEffort& effort_;
    const Note& note_;
    std::unique_ptr<const Scene> own_;        // the scene of the last answer; null: that of the structure
    StillElements still_;                     // near_elements.hpp
    std::shared_ptr<const BodyPart> behind_;  // its factor
    std::vector<TipResult> tips_;
    std::vector<RingForms> rings_;  // of the present scene, until they are taken
    Eigen::VectorXd displacement_;
    UnitDisplacement unit_displacement_;
    std::vector<double> largest_K_;
    double first_length_ = 0.0;  // of the crack of the first tip at the start, mm
};

/// Condenses a structure or the whole body (structure_chain.hpp); the time counts.
[[nodiscard]] std::unique_ptr<Structure> timed_condense(const Scene& scene, const ElementSet& in_zone,
                                                        const StillElements& still, StructureFactors& factors,
                                                        CoarseEffort& effort);

/// Where a factor takes seconds, the user should know what is going on.
void note_if_large(const Scene& scene, const char* phase, const Note& note);

}  // namespace stria::coarse
