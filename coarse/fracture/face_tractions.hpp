// Tractions that crack faces transmit, as a zone has told them station by station: a load of a body whose faces
// transmit none.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "coarse/model/scene.hpp"
#include "common/fracture/domain_integral.hpp"
#include "coupling/messages.hpp"

namespace stria::coarse {

/// Of cracks as long as they were then. An entry per station, by crack and arc length; straight between them.
struct FaceTractions {
    std::vector<std::int32_t> crack;
    std::vector<double> s, pressure, shear;  // mm; MPa: p n - tau t acts on the plus face, its opposite on the other
    std::vector<std::int8_t> in_wake;        // of metal that has flowed

    struct Traction {
        double pressure = 0.0, shear = 0.0;  // MPa
    };
    /// None on a crack without stations; beyond the last one as there.
    [[nodiscard]] Traction at(int of_crack, double place) const;
};

/// Of stations in any order, with pressure and shear in MPa.
[[nodiscard]] FaceTractions tractions_of(std::vector<coupling::FaceSample> faces);

/// What presses in a wake where the body would be open without it goes: such a wedge presses against the metal that it
/// has stretched, and no load does that. `mesh`: of the displacement `u` of the body whose faces transmit nothing.
void leave_out_wedges(FaceTractions& tractions, const EnrichedMesh& mesh, const Eigen::VectorXd& u);

/// On all unknowns of a scene of these cracks, N/mm.
[[nodiscard]] Eigen::VectorXd forces_of(const FaceTractions& tractions, const Scene& scene);

/// Their own part of the interactions about a tip in a ring, beside that of the displacement: what they do on the jumps
/// of the auxiliary fields.
[[nodiscard]] DomainIntegral interactions_of(const FaceTractions& tractions, const Scene& scene, int tip,
                                             const Annulus& ring);

}  // namespace stria::coarse
