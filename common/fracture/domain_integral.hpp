// J and the interaction integrals in domain form about one tip: their integrands at a point, and the sums over several
// rings in one pass. In each ring the weight q falls from 1 to 0.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/fem/shape_q4.hpp"
#include "common/fracture/auxiliary_fields.hpp"
#include "common/fracture/domain_sums.hpp"
#include "common/fracture/ring_weights.hpp"
#include "common/fracture/williams.hpp"
#include "common/integration/crack_faces.hpp"
#include "common/integration/element_operator.hpp"

namespace stria {

/// sigma_ij u_i,1 - W delta_1j with axis 1 along the tip: what the integrand of J dots with grad q.
inline Vec2 energy_momentum(const Tip& tip, const Mandel& stress, const Eigen::Matrix2d& gradient, double work) {
    return in_plane(stress) * (gradient * tip.direction) - work * tip.direction;
}

/// Its part that is mixed of the solution and an auxiliary field is linear in the solution. Dotted with grad q it is
/// xx sigma_xx + yy sigma_yy + xy sigma_xy + slope . u_,1.
struct MutualWeights {
    MutualWeights(const AuxiliaryField& field, const Vec2& along, const Vec2& dq)
        : slope(field.stress_xx * dq.x() + field.stress_xy * dq.y(),
                field.stress_xy * dq.x() + field.stress_yy * dq.y()) {
        const double ahead = along.dot(dq);
        xx = field.slope.x() * dq.x() - field.strain_xx * ahead;
        yy = field.slope.y() * dq.y() - field.strain_yy * ahead;
        xy = field.slope.y() * dq.x() + field.slope.x() * dq.y() - field.shear * ahead;
    }

    /// Of the stress, dotted with a strain in the plane.
    MutualWeights& operator+=(const Mandel& strain) {
        xx += strain[0];
        yy += strain[1];
        xy += std::numbers::sqrt2 * strain[3];
        return *this;
    }

    double xx, yy, xy;
    Vec2 slope;
};

/// The derivative along the tip of q times an auxiliary stress: xx, yy, 0, sqrt(2) xy. `ahead`: of q.
inline Mandel weighted_slope(const AuxiliaryField& field, const Mandel& stress_slope, double q, double ahead) {
    return q * stress_slope +
           ahead * Mandel(field.stress_xx, field.stress_yy, 0.0, std::numbers::sqrt2 * field.stress_xy);
}

/// What u_,1 is where the body turns by 1.
inline Vec2 turned(const Vec2& along) { return {-along.y(), along.x()}; }

/// (u_y,x - u_x,y) / 2.
inline double rotation(const Eigen::Matrix2d& gradient) { return 0.5 * (gradient(1, 0) - gradient(0, 1)); }

/// Sums over the rings of one tip. Weights are worked out once, fields once a point, whatever the number of rings.
class RingSums {
public:
    /// `mesh` must outlive the sums. `among`: elements that are looked at, ascending. `with_inside`: an initial stress
    /// has something to add wherever q is not zero.
    RingSums(const EnrichedMesh& mesh, const Tip& tip, const Elasticity& elastic, std::vector<Annulus> rings,
             std::span<const int> among, bool with_inside = false);

    /// Sums start anew. The same points come again, in the same order: what their places say is known by then.
    void clear() {
        sums_ = of_places_;
        visited_ = next_weighted_ = next_place_ = 0;
    }

    /// Points so far do not come again: what their places say is forgotten. The sums go on.
    void forget_points() {
        fields_.clear();
        weighted_.clear();
        visited_ = next_weighted_ = 0;
    }

    /// Turns to an element: false where it has nothing to add, as q is constant on it in every ring.
    bool enter(int element);

    /// Elements that have something to add, ascending.
    [[nodiscard]] const std::vector<int>& elements() const { return weights_.elements(); }

    /// A point of the element entered: stress, displacement gradient (row: component), and W, N/mm2.
    void add(const IntegrationPoint& point, const Mandel& stress, const Eigen::Matrix2d& gradient, double work);

    /// What an initial stress adds at the same point: its derivative along the tip, on the strains of the stress and of
    /// the auxiliary fields (docs/equations.md, initial stress).
    void add_initial(const IntegrationPoint& point, const Mandel& stress, const Mandel& slope);

    /// At the same point, of another material: what the tip's would be strained more there, Materials::mismatch(),
    /// dotted with the derivative of q sigma^aux along the tip (docs/equations.md). J has no such form.
    void add_mismatch(const IntegrationPoint& point, const Mandel& mismatch);

    /// Tractions that the faces transmit at a station of the tip's crack: pressure p and shear tau, so that p n - tau t
    /// acts on the plus face and its opposite on the minus face. Slopes: of opening and slip along its tangent.
    struct FaceLoad {
        double pressure, shear;  // MPa
        double opening_slope, slip_slope;
    };
    void add_faces(const FaceStation& station, const FaceLoad& load);

    [[nodiscard]] const Tip& tip() const { return tip_; }

    [[nodiscard]] std::span<const DomainIntegral> values() const { return sums_; }

private:
    /// Of the crack: a bent one leaves the tip's line, where the auxiliary fields jump.
    [[nodiscard]] int side_of(const IntegrationPoint& point) const;
    void look_at(const IntegrationPoint& point);

    const EnrichedMesh& mesh_;
    Tip tip_;
    Elasticity elastic_;
    std::vector<Annulus> rings_;
    std::vector<DomainIntegral> sums_;
    std::vector<DomainIntegral> of_places_;  // what does not depend on the solution, of the points in weighted_

    AuxiliaryFields auxiliary_;
    RingWeights weights_;
    std::vector<std::array<AuxiliaryField, 3>> fields_;  // of each point so far
    std::vector<Vec2> weighted_;                         // weight times grad q, of each point so far, ring by ring
    std::size_t visited_ = 0, next_weighted_ = 0;        // points since clear(), and their weighted_

    // Of the element entered.
    std::span<const RingWeights::Entered> entered_;
    int element_ = -1;            // that was entered
    std::size_t next_place_ = 0;  // behind it, among elements()
};

}  // namespace stria
