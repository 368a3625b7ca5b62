// Specimens of the catalogue: where each lies, how to mesh it, and what its handbook says.
#pragma once

#include <span>
#include <string_view>

#include "coarse/specimen/regions.hpp"
#include "common/case/case.hpp"
#include "common/fem/mesh.hpp"

namespace stria::coarse {

/// Of the body: beside it edges and cracks that are smaller are lost in the rounding of the coordinates.
constexpr double smallest_edge = 1e-6;

/// The rectangle that a specimen fills, mm.
struct Body {
    Vec2 low, high;

    [[nodiscard]] bool holds(const Vec2& x) const {
        return (low.array() <= x.array()).all() && (x.array() <= high.array()).all();
    }
    [[nodiscard]] bool holds_inside(const Vec2& x) const {
        return (low.array() < x.array()).all() && (x.array() < high.array()).all();
    }
};

struct Specimen {
    std::string_view name;
    Body (*body)(const MeshSection&);
    Mesh (*mesh)(const MeshSection&, const MeshLines&);
    // Null where no handbook formula applies. Under the resultant `load`, N per mm of thickness; sources: handbook.hpp.
    double (*handbook_K)(double width, double a, double load);  // MPa sqrt(mm)
    double (*limit_load)(double width, double a, double yield_stress, PlaneState plane);
};

/// One of catalogue.cpp. Throws CaseError listing the available names.
const Specimen& find_specimen(std::string_view name);

/// Mesh of the case's file; or of its specimen, with node lines along the axis-parallel outlines of regions and through
/// the points of boundaries that would be no nodes. Validates the mesh section and that every crack meets the specimen
/// and spares the inserts around pins; throws CaseError.
Mesh make_mesh(const MeshSection& section, const std::vector<CrackSection>& cracks,
               const std::vector<RegionSection>& regions = {}, const std::vector<BoundarySection>& boundaries = {});

}  // namespace stria::coarse
