// What far elements do inside: found where somebody wants it, for on a large body it takes longer than all that is
// near. Growing cracks seldom ask.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "coarse/structure/body_part.hpp"

namespace stria::coarse {

/// At one state. It outlives the structure that had it.
class FarDisplacement {
public:
    /// `unknowns`: those inside, of the mesh at hand. `load`: on them, as ReducedLoad has it. `rim`: displacement, mm.
    FarDisplacement(std::shared_ptr<const BodyPart> far, std::vector<int> unknowns, Eigen::VectorXd load,
                    Eigen::VectorXd rim)
        : far_(std::move(far)), unknowns_(std::move(unknowns)), load_(std::move(load)), rim_(std::move(rim)) {}

    /// Puts it into a displacement of the mesh that it was found on, and of a later one, on which the far elements have
    /// the same functions.
    void put_into(Eigen::VectorXd& u) const { put(unknowns_, u); }
    void put_into(Eigen::VectorXd& u, const EnrichedMesh& later) const { put(far_->inner(later), u); }

    [[nodiscard]] bool is_of(const BodyPart* far) const { return far_.get() == far; }
    /// Of such elements.
    [[nodiscard]] bool is_of_some(const ElementSet& elements) const;

private:
    void put(const std::vector<int>& unknowns, Eigen::VectorXd& u) const;

    std::shared_ptr<const BodyPart> far_;
    std::vector<int> unknowns_;
    Eigen::VectorXd load_, rim_;
};

/// Of the whole mesh, mm, but for what `far`, where it is not null, puts into it.
struct DisplacementBesideFar {
    Eigen::VectorXd u;
    std::shared_ptr<const FarDisplacement> far;
};

}  // namespace stria::coarse
