// An upper bound of the stresses in the far elements, from what the near ones do: the proof that they stay elastic
// without a look at them.
//
// A state of the far part is linear in the load factors and the displacement u of the rim. Learnt from states
// that were looked at element by element: a pivot p for the load factor 1, modes z_k without load, orthonormal in the
// energy of the far part, and the largest stresses of each. Then u = lambda p + sum a_k z_k + d with a remainder d,
// and by the triangle inequality the stress is at most |lambda| sigma_p + sum |a_k| sigma_k + sigma(d). Of d the far
// energy W is known, and a point that stands for the area w can have no more of it than W:
// sigma(d)^2 <= 6 G W / w, as the energy density is at least sigma^2 / (6 G). A state looked at before, scaled to the
// same load factor, may take the place of lambda p: the sum is then over what distinguishes the two. With an initial
// stress it may, unscaled, and only it: the stress is then affine in the load factor and u. Load cases have pivots of
// their own, each a state of the structure with Gamma at rest, and stand beside lambda p.
#pragma once

#include <vector>

#include "coarse/structure/structure.hpp"

namespace stria::coarse {

class FarStressBound {
public:
    /// `structure` must outlive the bound, or the turn to another one.
    explicit FarStressBound(const Structure& structure);

    /// Turns to another structure if it has the same far body: all that was learnt is true of it. Else false.
    [[nodiscard]] bool turn_to(const Structure& structure);

    /// Upper bound of the von Mises stress in far elements, measured as structure_stresses.hpp does, MPa. Infinite
    /// while nothing comparable has been learnt. `rim_displacement`: on Structure::rim(), of a state in equilibrium.
    [[nodiscard]] double at(const Eigen::VectorXd& rim_displacement, const LoadFactors& factors) const;

    /// The pivot: displacement and largest far stress of the load factor 1 without an initial stress.
    void learn_pivot(const Eigen::VectorXd& rim_displacement, double largest_stress);

    /// Learns from such a state and its largest far stress. Costs an expansion of the far body and a look at its
    /// elements; not for the first state under load, which is the pivot where there is none and no initial stress.
    void learn(const Eigen::VectorXd& rim_displacement, const LoadFactors& factors, double largest_stress);

private:
    struct Mode {
        Eigen::VectorXd displacement, far_force;  // on the rim
        double largest_stress;
    };
    struct Pivot {  // of the factor 1
        Eigen::VectorXd displacement;
        double largest_stress;
    };
    struct Coordinates {
        LoadFactors factors;
        std::vector<double> along;  // modes
        double remainder;           // bound of its stress
    };
    struct Known {
        Coordinates place;
        double largest_stress;
    };
    [[nodiscard]] Coordinates resolve(Eigen::VectorXd& displacement, const LoadFactors& factors) const;
    [[nodiscard]] double stress_of(const Eigen::VectorXd& remainder) const;
    [[nodiscard]] double bound_beside(const Known& known, double scale, const Coordinates& place) const;
    [[nodiscard]] double stress_of_mode(const Eigen::VectorXd& displacement) const;

    const Structure* structure_;
    std::shared_ptr<const BodyPart> far_;
    bool affine_;      // there is an initial stress
    double response_;  // of a far point's stress to energy (structure_stresses.hpp)
    Eigen::VectorXd pivot_;
    double pivot_stress_ = 0.0;
    std::vector<Pivot> pivots_of_cases_;
    std::vector<Mode> modes_;
    std::vector<Known> known_;
};

}  // namespace stria::coarse
