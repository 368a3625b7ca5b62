// Stresses of the coarse elements against yield. They are measured against the yield stress of the weakest material:
// that of an element counts times Scene::stress_weight, so elements that stay elastic at any stress are left out.
#pragma once

#include <vector>

#include "coarse/structure/structure.hpp"

namespace stria::coarse {

/// With the initial stress, or of a displacement alone.
enum class StressPart { Whole, OfDisplacement };

/// Coarse elements whose whole von Mises stress exceeds a limit at some point, ascending. `u`: of the whole mesh.
std::vector<int> elements_beyond(double stress, const Structure& structure, const Eigen::VectorXd& u);

/// Of near elements alone.
std::vector<int> near_elements_beyond(double stress, const Structure& structure, const Eigen::VectorXd& u);

/// Largest von Mises stress of far elements, MPa; 0 where there are none.
double largest_far_stress(const Structure& structure, const Eigen::VectorXd& u, StressPart part);

/// Largest 3 G / w over far points that stand for the area w, stresses measured as above, MPa/mm2: the square of a
/// point's von Mises stress is at most this times twice the energy. 0 where there are none.
double largest_far_response(const Structure& structure);

}  // namespace stria::coarse
