// J and the interaction integrals in domain form about one tip: the sums over several rings in one pass. In each ring
// the weight q falls from 1 to 0.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "common/fem/shape_q4.hpp"
#include "common/fracture/auxiliary_fields.hpp"
#include "common/fracture/domain_sums.hpp"
#include "common/fracture/elastic_share.hpp"
#include "common/fracture/energy_momentum.hpp"
#include "common/fracture/ring_weights.hpp"
#include "common/fracture/williams.hpp"
#include "common/integration/crack_faces.hpp"
#include "common/integration/element_operator.hpp"

namespace stria {

/// Sums over the rings of one tip. Weights are worked out once, fields once a point, whatever the number of rings.
class RingSums {
public:
    /// `mesh` must outlive the sums. `among`: elements that are looked at, ascending. `with_inside`: an initial stress
    /// has something to add wherever q is not zero.
    RingSums(const EnrichedMesh& mesh, const Tip& tip, const Elasticity& elastic, std::vector<Annulus> rings,
             std::span<const int> among, bool with_inside = false);

    /// Sums start anew. The same elements come again: what the places of their points say is known by then.
    void clear() {
        sums_ = of_places_;
        next_place_ = 0;
    }

    /// Elements so far do not come again: what their places say is forgotten. The sums go on.
    void forget_points() {
        fields_.clear();
        weighted_.clear();
    }

    /// Turns to an element: false where it has nothing to add, as q is constant on it in every ring. All of its points
    /// follow, or its motion.
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

    /// While the element entered is elastic and has four functions its share follows from where its points stand. To
    /// stand elsewhere is to have another number. Whether it is known how:
    [[nodiscard]] bool knows_way_from(int stand) const { return known_[place_].stand == stand; }
    /// If not, it is to be told, and then point by point.
    void begin_way_from(int stand);
    void tell_way(const IntegrationPoint& point, const ElasticResponse& response);
    /// All points of the element at once. `motion`: from where they stand.
    void add_moved(const NodeMotion& motion);

    /// Tractions that the faces transmit at a station of the tip's crack: pressure p and shear tau, so that p n - tau t
    /// acts on the plus face and its opposite on the minus face. Slopes: of opening and slip along its tangent.
    struct FaceLoad {
        double pressure, shear;  // MPa
        double opening_slope, slip_slope;
        bool in_wake = false;  // of metal that has flowed
    };
    void add_faces(const FaceStation& station, const FaceLoad& load);

    [[nodiscard]] const Tip& tip() const { return tip_; }

    [[nodiscard]] std::span<const DomainIntegral> values() const { return sums_; }

private:
    /// Of the crack: a bent one leaves the tip's line, where the auxiliary fields jump.
    [[nodiscard]] int side_of(const IntegrationPoint& point) const;
    [[nodiscard]] int element() const { return elements()[place_]; }  // that was entered
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
    std::vector<ElasticShare> shares_;                   // of each element whose way was told, ring by ring

    struct Known {
        bool points = false;               // their places have been looked at
        std::size_t field, weighted;       // the first of its own, then
        std::optional<std::size_t> share;  // likewise, once its way was told
        int stand = -1;                    // from where
    };
    std::vector<Known> known_;  // of elements(), by their places

    // Of the element entered.
    std::span<const RingWeights::Entered> entered_;
    std::size_t place_ = 0, next_place_ = 0;  // among elements()
    bool points_are_known_ = false;
    std::size_t next_field_ = 0, next_weighted_ = 0;  // of its next point
};

}  // namespace stria
