// The zone's tree of fronts: its elements are those of the bulk, then the multipliers. What of it is out of date, and
// what a later zone takes over.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "common/substructure/front_tree.hpp"
#include "coupling/work_counts.hpp"
#include "fine/zone/zone_system.hpp"

namespace stria::fine {

class ZoneTree {
public:
    /// `system`: must outlive it.
    explicit ZoneTree(const ZoneSystem& system) : system_(system) {}

    /// The zone is another one. Its tree is planted when it is wanted, for another zone may come first. It takes over
    /// those fronts of the last one that would be the same.
    void turn_to(const TakenOver& taken_over);
    void plant_where_due();
    /// A tree that has nothing of the last one.
    void plant();

    /// Tangents of the last evaluation and statuses of the faces: what differs from the last factor is out of date.
    void find_changes();
    /// In the ids of the tree.
    [[nodiscard]] const ElementSet& changed() const { return changed_; }
    [[nodiscard]] bool some_status_changed() const;
    /// Nothing has been factored since it was planted.
    [[nodiscard]] bool is_new() const { return new_; }

    /// Throws NumericalFailure.
    void factor();
    [[nodiscard]] const coupling::WorkCounts& work() const { return work_; }

    [[nodiscard]] FrontTree& fronts() { return *tree_; }
    [[nodiscard]] const FrontTree& fronts() const { return *tree_; }

    /// Ids of the tree, and what they are in the zone.
    [[nodiscard]] ElementSet ids_of(const Resting& some) const;
    [[nodiscard]] Resting resting() const;

private:
    [[nodiscard]] int elements() const { return system_.bulk().elements().count(); }
    void read_multipliers();
    void begin(const std::vector<int>& same);
    [[nodiscard]] std::vector<int> unchanged(const TakenOver& taken_over) const;

    const ZoneSystem& system_;
    std::unique_ptr<FrontTree> tree_;
    std::vector<Vec2> busy_;
    std::optional<TakenOver> due_;                      // of the zone whose tree this is
    std::vector<FaceStatus> statuses_;                  // of each multiplier in the last factor, or in the next one
    std::vector<Eigen::MatrixXd> multiplier_matrices_;  // with these
    ElementSet flows_;    // of the bulk: its matrix in the last factor is not the elastic one
    ElementSet changed_;  // its matrix is not that of the last factor
    bool new_ = true;
    coupling::WorkCounts work_;
};

}  // namespace stria::fine
