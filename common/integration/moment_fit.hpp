// Weights of quadrature points that stay where they are while a crack newly cuts their element (docs/method.md, section
// 3).
#pragma once

#include <span>
#include <vector>

#include "common/integration/element_points.hpp"

namespace stria {

/// Gives the points of each side of a newly cut element weights >= 0 with which they integrate quadratic polynomials
/// over that side exactly, or linear ones; where neither can be, one more point inside the side makes up for what its
/// points miss of a linear polynomial. A side without points gets some, exact for quadratic ones. Sides whose weights
/// are exact already keep them. Sets the points' sides.
void fit_weights(const CutElement& cut, const std::array<Vec2, 4>& corners, std::vector<IntegrationPoint>& points);

/// Shares >= 0 that add up to one with which values at `points` make the value at `x`: that of a linear field where x
/// lies among them, of the nearest of them otherwise. States mixed so stay within a convex yield surface.
Eigen::VectorXd shares_at(const Vec2& x, std::span<const Vec2> points);

struct PointShare {
    std::size_t point;
    double share;
};

/// The points of an element before its crack grew whose states make that of point `q` now: itself, as old ones come
/// first and in their order; of one that is new those around it, on its side unless that had none.
std::vector<PointShare> history_of(std::span<const IntegrationPoint> now, std::size_t q,
                                   std::span<const IntegrationPoint> before);

/// min |A w - b| over w >= 0 (Lawson and Hanson, Solving Least Squares Problems, 1974, chapter 23), sought from
/// `first` >= 0 on.
Eigen::VectorXd non_negative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, Eigen::VectorXd first);

}  // namespace stria
