// The jump of the displacement across a crack: rows of the jump operator at stations along it.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "common/enrichment/enriched_mesh.hpp"

namespace stria {

/// Jump operator at one station: jump = fixed jump + sum over terms of value * (u[unknown], u[unknown + 1]), plus side
/// minus minus side; `slope` instead of `value` gives its derivative along the tangent.
struct FaceStation {
    struct Term {
        int unknown;
        double value, slope;
    };
    int crack = 0;
    int element = 0;      // of the enriched mesh
    double s = 0.0;       // arc length, mm
    double weight = 0.0;  // length that the station stands for, mm
    Vec2 x = Vec2::Zero(), tangent = Vec2::UnitX(),
         normal = Vec2::UnitY();                      // normal from minus to plus: left of the tangent
    Eigen::Vector4d shape = Eigen::Vector4d::Zero();  // standard functions of the element's corners
    std::vector<Term> terms;
    Vec2 fixed_jump = Vec2::Zero();  // that is not of the unknowns, mm

    [[nodiscard]] Vec2 jump(const Eigen::VectorXd& u) const;
    [[nodiscard]] double opening(const Eigen::VectorXd& u) const { return jump(u).dot(normal); }
    /// Derivative along the tangent of the jump's component in a direction, but for the fixed one's.
    [[nodiscard]] double slope(const Eigen::VectorXd& u, const Vec2& direction) const;
    [[nodiscard]] double opening_slope(const Eigen::VectorXd& u) const { return slope(u, normal); }
    [[nodiscard]] double slip_slope(const Eigen::VectorXd& u) const { return slope(u, tangent); }
    [[nodiscard]] double slip(const Eigen::VectorXd& u) const { return jump(u).dot(tangent); }
};

/// Gauss points of the interface elements (crack pieces cut by the s x s sub-quadrangles, Fig. 2) of one crack, in
/// order. Where functions of its tip act they are those of sqrt(r): the jump of eq. (2) is a polynomial in it.
std::vector<FaceStation> face_stations(const EnrichedMesh& mesh, int crack, int subcells, int gauss);

/// The same interface elements of a tip's crack for integrands that are singular there: r^(-1/2) times a polynomial is
/// integrated exactly, being one in sqrt(r).
std::vector<FaceStation> face_stations_about(const EnrichedMesh& mesh, const Tip& tip, int subcells, int gauss);

/// The station at an arc length (weight 0); empty terms where no piece of the mesh holds it.
FaceStation face_station_at(const EnrichedMesh& mesh, int crack, double s);

/// Where a crack meets the boundary; empty terms where it has two tips, and where no piece of the mesh holds that end.
FaceStation face_station_at_mouth(const EnrichedMesh& mesh, int crack);

/// The station at a distance behind a tip, mm along the crack; empty terms where the mesh does not hold it, and where
/// the distance is none.
FaceStation face_station_behind(const EnrichedMesh& mesh, const Tip& tip, double distance);

/// The arc length at which a mesh's pieces of a crack hold a place, if they do. The crack of another mesh may run
/// beside them by what points are moved onto nodes (snap_fraction).
std::optional<double> arc_length_at(const EnrichedMesh& mesh, int crack, const Vec2& x);

/// Crack tip opening displacement at the 90 degree intercept: the opening where it equals twice the distance to the
/// tip. Negative where the mesh does not hold the intercept.
double opening_at_intercept(const EnrichedMesh& mesh, const Tip& tip, const Eigen::VectorXd& u);

/// The same where the opening at a station is not of the unknowns alone.
double opening_at_intercept(const EnrichedMesh& mesh, const Tip& tip,
                            const std::function<double(const FaceStation&)>& opening);

}  // namespace stria
