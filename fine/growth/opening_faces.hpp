// Faces that a growth of the crack has opened, and what they release while equilibrium is found again (work balance,
// docs/equations.md).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/enrichment/enriched_mesh.hpp"
#include "common/index_set.hpp"

namespace stria::fine {

/// Until a crack grows the metal ahead of it transmits tractions. On the unknowns of the new jumps they are nodal
/// forces F = - integral of B^T sigma of the stresses that stay as they are (Fig. 3a). Finding equilibrium takes them
/// away while the jumps open by u (Fig. 3b), at once or in parts. On a path t from 0 to 1 on which they fade in
/// proportion to a share h of what they were, h F . u(1) + (1 - h) F . integral of u dt is released. Where metal flows
/// the jumps open late on it: u(t) is the parabola that ends at u(1) and begins with Newton's first step, which takes
/// the tangent before anything flows. Where faces come to press that step says little: no more than a parabola that
/// goes on from zero to u(1) is made of it. Each crack has a path of its own.
class OpeningFaces {
public:
    OpeningFaces() = default;

    /// `held`: as held() gave it. `crack_of`: per unknown, cracks_of_unknowns().
    OpeningFaces(const Eigen::VectorXd& held, const std::vector<int>& crack_of);

    /// `held`: on the unknowns of `next`, the forces in need of balance at the displacement that both meshes share;
    /// those of jumps that `before` lacks are held. May be called again before equilibrium.
    void open(const EnrichedMesh& before, const EnrichedMesh& next, const Eigen::VectorXd& held);

    /// Where stresses have changed with the functions: all that has come out of balance is held as well. `force`: of
    /// metal and faces, which were in equilibrium with it before, and `now`. `changed`: unknowns of what is not as it
    /// was.
    void hold_changes(const EnrichedMesh& before, const Eigen::VectorXd& force, const EnrichedMesh& next,
                      const Eigen::VectorXd& now, const UnknownSet& changed);

    /// The same faces on another mesh.
    void follow(const EnrichedMesh& before, const EnrichedMesh& next);

    /// Takes the share of the forces that still holds the faces from what is in need of balance, N/mm.
    void hold(double share, Eigen::VectorXd& load) const;

    /// Forces are held back.
    [[nodiscard]] bool any() const { return !of_cracks_.empty(); }

    /// Newton's first step on the way to an equilibrium, of all unknowns, mm.
    void begin(const Eigen::VectorXd& first_step);

    /// N per mm of thickness: released by a move to equilibrium with that share, which is all that is left then.
    double release(const Eigen::VectorXd& move, double share);

    /// What is yet to be released: on all unknowns of a mesh the forces that held its new jumps, zero elsewhere, N/mm.
    [[nodiscard]] Eigen::VectorXd held(int unknowns) const;

private:
    struct NewFaces {
        std::vector<int> jumps;            // unknowns of the new jumps
        Eigen::VectorXd held, first_step;  // on them; the step empty where none was taken

        double release(const Eigen::VectorXd& opening, double share);
    };

    std::vector<NewFaces> of_cracks_;  // of those that have some
};

/// Of each unknown of a mesh the crack that its function belongs to; -1: of a standard one.
std::vector<int> cracks_of_unknowns(const EnrichedMesh& mesh);

}  // namespace stria::fine
