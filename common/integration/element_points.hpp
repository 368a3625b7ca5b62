// Where an element is integrated: sub-quadrangles (Fig. 1), split along the crack and towards tips.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "common/integration/cut_element.hpp"

namespace stria {

struct IntegrationPoint {
    Vec2 x, xi;
    double weight;  // mm2
    int side;       // +1, -1 in a cut element; else 0
    int region;     // of mean dilatation: index into ElementOperator::mean
};

/// Which elements take mean dilatation. In plane stress nothing keeps a volume; tip functions are better without where
/// nothing locks, and plain elements better with it even then.
enum class MeanDilatation { Nowhere, WithoutTipFunctions, Everywhere };

/// How an element is integrated.
struct IntegrationRule {
    int subcells = 1;                      // sub-quadrangles per edge (the paper's fine scale: Fig. 1)
    std::optional<int> far_subcells = {};  // in a zone, of elements that no crack cuts or points at; absent: as many
    int singular_gauss = 2;  // points per direction in an uncut sub-quadrangle, with tip functions; without them 2
    int tip_points = 6;      // per direction in triangles that end at a tip
    MeanDilatation mean_dilatation = MeanDilatation::Everywhere;
};

/// Points of one element: Gauss points of its sub-quadrangles; where the crack or a tip's rays pass, of their
/// triangles. `cut`: the crack inside the element, or null. `tips`: singular points on or in the element; `singular`:
/// whether the element carries tip functions at all.
std::vector<IntegrationPoint> place_points(const std::array<Vec2, 4>& corners, const CutElement* cut,
                                           std::span<const Vec2> tips, bool singular, const IntegrationRule& rule);

}  // namespace stria
