// Functions that a tip has left behind, with the displacement that they had (docs/method.md, section 7).
#pragma once

#include <Eigen/Core>
#include <cstdint>

#include "common/enrichment/enriched_mesh.hpp"

namespace stria::coupling {

struct FrozenTip {
    EnrichedMesh mesh;             // the elements that see them
    Eigen::VectorXd displacement;  // of its unknowns, zero but for those of the functions, mm
    std::int32_t crack = 0;
};

}  // namespace stria::coupling
