// Stresses of the coarse elements against yield. Elements of inserts stay elastic at any stress: they are left out.
#pragma once

#include <vector>

#include "coarse/structure/structure.hpp"

namespace stria::coarse {

/// Coarse elements whose von Mises stress exceeds a limit at some point, ascending. `u`: of the whole mesh.
std::vector<int> elements_beyond(double stress, const Structure& structure, const Eigen::VectorXd& u);

/// Of near elements alone.
std::vector<int> near_elements_beyond(double stress, const Structure& structure, const Eigen::VectorXd& u);

/// Largest von Mises stress of far elements, MPa; 0 where there are none.
double largest_far_stress(const Structure& structure, const Eigen::VectorXd& u);

/// Smallest area that an integration point of these stands for, mm2; infinite where there are none.
double smallest_far_weight(const Structure& structure);

}  // namespace stria::coarse
