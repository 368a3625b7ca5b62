// Specimens of the catalogue: how to mesh one, and what its handbook says of its stress intensity.
#pragma once

#include <span>
#include <string_view>

#include "common/fem/mesh.hpp"
#include "common/io/case.hpp"

namespace stria::coarse {

struct Specimen {
    std::string_view name;
    std::string_view sentence;
    Mesh (*mesh)(const MeshSection&);
    /// K_I (MPa sqrt(mm)) of an edge crack of length a under remote stress; null where no handbook formula applies.
    double (*handbook_K)(double width, double a, double stress);
};

/// All specimens; a new one is one more line in catalogue.cpp.
std::span<const Specimen> specimens();

/// Throws CaseError listing the available names.
const Specimen& find_specimen(std::string_view name);

/// Single-edge-notched plate under remote tension, any height above about one width: Tada, Paris, Irwin, The Stress
/// Analysis of Cracks Handbook, stated accuracy 0.5 % for every a / width.
double sent_handbook_K(double width, double a, double stress);

/// Mesh of the case's specimen. Validates the mesh section and that every crack meets the body; throws CaseError.
Mesh make_mesh(const Case& scene);

}  // namespace stria::coarse
