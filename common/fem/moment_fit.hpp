// Weights of quadrature points that stay where they are while a crack newly cuts their element (NUMERICS 2).
#pragma once

#include <span>
#include <vector>

#include "common/fem/element_points.hpp"

namespace stria {

/// Gives the points of each side of a newly cut element weights >= 0 with which they integrate quadratic polynomials
/// over that side exactly, or linear ones; where neither can be, the side's points get none and one more point, at the
/// side's centroid, all of it. Sides whose weights are exact already keep them. Sets the points' sides.
void fit_weights(const CutElement& cut, const std::array<Vec2, 4>& corners, std::vector<IntegrationPoint>& points);

/// min |A w - b| over w >= 0 (Lawson and Hanson, Solving Least Squares Problems, 1974, chapter 23).
Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace stria
