#include "coarse/analysis/committed_displacement.hpp"

#include <utility>

namespace stria::coarse {

void CommittedDisplacement::catch_up(const Equilibrium& equilibrium, const EnrichedMesh& mesh) {
    if (!std::exchange(is_behind_, false)) return find_far(mesh);
    u_ = equilibrium.structure_displacement();
    far_.reset();
}

void CommittedDisplacement::catch_up_beside_far(const Equilibrium& equilibrium, const EnrichedMesh& mesh) {
    if (!std::exchange(is_behind_, false)) return find_far(mesh);
    DisplacementBesideFar known = equilibrium.displacement_beside_far();
    u_ = std::move(known.u);
    far_ = std::move(known.far);
}

void CommittedDisplacement::find_far(const EnrichedMesh& mesh) {
    if (const auto far = std::exchange(far_, nullptr)) {
        far->put_into(u_, mesh);
        ++*solves_;
    }
}

void CommittedDisplacement::find_far(const EnrichedMesh& mesh, const ElementSet& elements) {
    if (far_ && far_->is_of_some(elements)) find_far(mesh);
}

Eigen::VectorXd CommittedDisplacement::write_beside_far(const Equilibrium& equilibrium) const {
    return is_behind_ ? equilibrium.structure_displacement() : u_;
}

void CommittedDisplacement::write_far(const EnrichedMesh& mesh, Eigen::VectorXd& u) const {
    if (far_ && !is_behind_) far_->put_into(u, mesh);
}

void CommittedDisplacement::write_kept_far(Eigen::VectorXd& u) const {
    if (kept_far_) kept_far_->put_into(u);
}

}  // namespace stria::coarse
