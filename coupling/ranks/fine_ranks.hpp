// The zone shared out among several fine components that look like one: each is a subtree of the zone's tree of
// substructures, and the merge above them stands here (docs/method.md, section 1).
#pragma once

#include <optional>
#include <vector>

#include "common/predictor.hpp"
#include "coupling/fine_scale.hpp"
#include "coupling/ranks/seam_tree.hpp"
#include "coupling/ranks/zone_sharing.hpp"

namespace stria::coupling {

/// Ranks meet on seams: unknowns that several of them see and the structure does not. They are eliminated in a tree of
/// fronts whose elements are the ranks, so that Gamma is all that the coarse component knows of, and the iterates are
/// those of one rank. Elements keep their rank, for their history lives there; where a crack that has grown ties
/// together those of several, the zone is shared out anew: history moves first and the geometry changes then.
class FineRanks final : public FineScale {
public:
    /// `ranks` must outlive this. `remembered`: increments, for predictors (predictor.hpp).
    FineRanks(std::vector<FineScale*> ranks, std::size_t remembered);

    void set_patch(const Patch& patch) override;
    void begin_set_patch(const Patch& patch) override;
    [[nodiscard]] Eigen::MatrixXd increments() override;
    void request(const PatchDisplacement& displacement) override;
    PatchResponse collect() override;
    StepReport commit(const Commit& what) override;
    void rollback() override;
    ZoneState state() override;
    ZoneSnapshot snapshot() override;
    void keep() override;
    ZoneSnapshot kept() override;
    void restore(const Patch& patch, const ZoneSnapshot& snapshot) override;

    /// The last report of each rank. Those of ranks without an element hold only what they have done so far.
    [[nodiscard]] const std::vector<StepReport>& reports() const { return reports_; }

    /// How often history has moved.
    [[nodiscard]] int history_moves() const { return history_moves_; }

private:
    void move_history();
    struct Kept {  // of a state, beside what the ranks have
        EnrichedMesh mesh;
        std::vector<RankPart> parts;
        std::vector<double> flow;
        double weighed_cost = 0.0;
    };
    /// Of all ranks; `give`: asks one.
    [[nodiscard]] ZoneSnapshot together(const Kept& of, ZoneSnapshot (FineScale::*give)()) const;
    [[nodiscard]] Eigen::VectorXd known_displacement(const Patch& next) const;
    [[nodiscard]] MovedIncrements moved_to(const EnrichedMesh& next);
    [[nodiscard]] std::vector<Patch> take(const Patch& patch, const Eigen::VectorXd& displacement,
                                          const MovedIncrements& moved = {});
    void go_on_from(const Patch& patch, const ZoneSnapshot& snapshot);
    [[nodiscard]] FineScale& scale_of(const RankPart& part) const { return *scales_[at(part.rank)]; }
    [[nodiscard]] std::vector<FineScale*> asked() const;
    [[nodiscard]] std::vector<PatchResponse> answers_of_ranks();
    using Wanted = PatchDisplacement::Wanted;

    std::vector<FineScale*> scales_;
    Patch patch_;
    ZoneSharing sharing_;
    std::vector<RankPart> parts_;
    std::vector<Patch> given_;  // to the parts, and they may not have it yet
    Kept kept_;
    Seams seams_;
    std::optional<SeamTree> tree_;
    Eigen::VectorXd committed_, trial_;  // displacement of Seams::kept, mm
    Eigen::VectorXd correction_;         // likewise, the last one, taken whole
    PatchDisplacement question_;         // the last one
    bool opens_faces_ = false;           // some rank did when it was asked last
    IncrementMemory<Eigen::VectorXd> increments_;
    std::vector<StepReport> reports_;
    int history_moves_ = 0;
};

}  // namespace stria::coupling
