// The committed displacement of the whole mesh, found where somebody wants it: only a new structure, a growth and a
// checkpoint do, and on a large body it takes longer than all that is near.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "coarse/equilibrium/equilibrium.hpp"

namespace stria::coarse {

/// It falls behind with each increment that an equilibrium commits, and catches up where it is asked for. What far
/// elements do inside may stay open until somebody wants to know it.
class CommittedDisplacement {
public:
    /// `u`: of the whole mesh, mm. `solves`: counts how often far elements have been asked; it must outlive this.
    CommittedDisplacement(Eigen::VectorXd u, std::int64_t& solves) : u_(std::move(u)), solves_(&solves) {}

    void fall_behind() { is_behind_ = true; }

    /// `equilibrium`: its trial state is the committed one. `mesh`: the present one.
    void catch_up(const Equilibrium& equilibrium, const EnrichedMesh& mesh);
    /// The same, but for what is far, where that has not been asked for yet.
    void catch_up_beside_far(const Equilibrium& equilibrium, const EnrichedMesh& mesh);
    /// What is far is found, or where it is of some of these elements.
    void find_far(const EnrichedMesh& mesh);
    void find_far(const EnrichedMesh& mesh, const ElementSet& elements);
    [[nodiscard]] bool lacks_far_other_than(const BodyPart* part) const { return far_ && !far_->is_of(part); }

    /// Of the whole mesh, mm, once it has caught up; what is far may be lacking.
    [[nodiscard]] const Eigen::VectorXd& beside_far() const { return u_; }
    /// The mesh has changed, and the displacement has been carried to it.
    [[nodiscard]] Eigen::VectorXd& on_next_mesh() { return u_; }

    /// For a checkpoint, but for what is far; that of the present; and that of the time when keep_far() was called.
    [[nodiscard]] Eigen::VectorXd write_beside_far(const Equilibrium& equilibrium) const;
    void write_far(const EnrichedMesh& mesh, Eigen::VectorXd& u) const;
    void write_kept_far(Eigen::VectorXd& u) const;
    void keep_far() { kept_far_ = far_; }
    void forget_kept_far() { kept_far_.reset(); }

private:
    Eigen::VectorXd u_;
    std::int64_t* solves_;
    bool is_behind_ = false;
    // What u_ lacks, and what it lacked when that was kept; null: nothing.
    std::shared_ptr<const FarDisplacement> far_, kept_far_;
};

}  // namespace stria::coarse
