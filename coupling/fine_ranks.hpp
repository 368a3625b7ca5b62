// The zone shared out among several fine components that look like one: each is a subtree of the zone's tree of
// substructures, and the merge above them stands here (docs/method.md, section 1).
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "common/predictor.hpp"
#include "common/substructure/front_tree.hpp"
#include "coupling/fine_scale.hpp"

namespace stria::coupling {

/// Ranks meet on seams: unknowns that several of them see and the structure does not. They are eliminated in a tree of
/// fronts whose elements are the ranks, so that Gamma is all that the coarse component knows of, and the iterates are
/// those of one rank. Elements keep their rank, for their history lives there; where a crack that has grown ties
/// together those of several, the zone is shared out anew: history moves first and the geometry changes then.
class FineRanks final : public FineScale {
public:
    /// `ranks` must outlive this. `remembered`: increments, for predictors (predictor.hpp).
    FineRanks(std::vector<FineScale*> ranks, std::size_t remembered);
    ~FineRanks() override;

    void set_patch(const Patch& patch) override;
    void request(const PatchDisplacement& displacement) override;
    PatchResponse collect() override;
    StepReport commit(bool reversal) override;
    void rollback() override;
    ZoneState state() override;
    ZoneSnapshot snapshot() override;
    void restore(const Patch& patch, const ZoneSnapshot& snapshot) override;

    /// The last of each rank; of ranks without an element what they have done.
    [[nodiscard]] const std::vector<StepReport>& reports() const { return reports_; }

    /// How often history had to move.
    [[nodiscard]] int history_moves() const { return history_moves_; }

private:
    struct Rank;

    [[nodiscard]] Eigen::VectorXd known_displacement(const Patch& next) const;
    void move_history();
    [[nodiscard]] std::vector<EnrichedMesh> divide(const EnrichedMesh& zone);
    void find_seams();
    void take(const Patch& patch, const Eigen::VectorXd& displacement, const ZoneSnapshot* snapshot);
    void send(std::vector<EnrichedMesh> parts, const Eigen::VectorXd& displacement, const ZoneSnapshot* snapshot);
    void plant_tree();
    void advance_seams(const PatchDisplacement& displacement);
    [[nodiscard]] std::vector<PatchResponse> collect_all();

    std::vector<FineScale*> scales_;
    Patch patch_;
    std::map<int, int> owner_;        // rank by id of an element
    std::vector<Rank> ranks_;         // those with elements
    std::vector<int> kept_;           // seams and Gamma: unknowns of the patch's mesh, ascending
    std::vector<int> gamma_, seams_;  // places in kept_
    Eigen::VectorXd own_load_;        // on kept_, per unit load factor, N/mm: of the seams

    std::unique_ptr<FrontTree> tree_;
    std::vector<CondensedTangent> tangents_;  // per rank
    std::vector<char> changed_;               // per rank: since the last factor
    ReducedLoad reduced_, reduced_unit_;
    Eigen::VectorXd committed_, trial_;  // displacement of kept_
    double load_factor_ = 0.0;
    IncrementMemory<Eigen::VectorXd> increments_;
    std::vector<StepReport> reports_;
    int history_moves_ = 0;
};

}  // namespace stria::coupling
