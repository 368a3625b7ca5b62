// The equilibrium of a plate with a bent crack whose faces touch without friction: linear elastic, plane strain, pairs
// of nodes that cannot pass through each other. It shares nothing with the program.
#pragma once

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "tests/support/conforming/cracked_grid.hpp"

namespace stria::test::conforming {

struct Plate {
    double width = 0.0, height = 0.0;  // mm
    Polyline crack;
    double young = 0.0, poisson = 0.0;

    [[nodiscard]] double plane_modulus() const { return young / (1.0 - poisson * poisson); }
    [[nodiscard]] double shear_modulus() const { return young / (2.0 * (1.0 + poisson)); }
    [[nodiscard]] double lame() const { return 2.0 * shear_modulus() * poisson / (1.0 - 2.0 * poisson); }
    [[nodiscard]] Eigen::Matrix2d stress_of(const Eigen::Matrix2d& gradient) const {
        return lame() * gradient.trace() * Eigen::Matrix2d::Identity() +
               shear_modulus() * (gradient + gradient.transpose());
    }
};

/// Tractions on all sides, of a uniform stress and of bending: sigma_yy grows by `bending` along x from nothing in the
/// middle of the plate.
struct Load {
    Eigen::Matrix2d stress = Eigen::Matrix2d::Zero();  // MPa
    double bending = 0.0;                              // MPa/mm
};

/// Biquadratic functions at a place of the parent square.
struct Functions {
    Eigen::Matrix<double, 9, 1> value;
    Eigen::Matrix<double, 9, 2> gradient;
    double area;  // of the parent's unit

    Functions(const std::array<Vec, 9>& places, double xi, double eta) {
        const auto parabolas = [](double t) {
            return Eigen::Vector3d(0.5 * t * (t - 1.0), 1.0 - t * t, 0.5 * t * (t + 1.0));
        };
        const auto slopes = [](double t) { return Eigen::Vector3d(t - 0.5, -2.0 * t, t + 0.5); };
        Eigen::Matrix<double, 9, 2> by_parent;
        Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();
        for (int k = 0; k < 9; ++k) {
            value[k] = parabolas(xi)[k % 3] * parabolas(eta)[k / 3];
            by_parent.row(k) << slopes(xi)[k % 3] * parabolas(eta)[k / 3], parabolas(xi)[k % 3] * slopes(eta)[k / 3];
            jacobian += places[std::size_t(k)] * by_parent.row(k);
        }
        gradient = by_parent * jacobian.inverse();
        area = jacobian.determinant();
    }
};

struct GaussPoint {
    double place, weight;
};
constexpr std::array<GaussPoint, 3> gauss{
    GaussPoint{-0.7745966692414834, 5.0 / 9.0}, {0.0, 8.0 / 9.0}, {0.7745966692414834, 5.0 / 9.0}};

/// On one segment of the crack a pair of nodes that may push each other apart.
struct Touching {
    std::size_t pair = 0, segment = 0;
    double force = 0.0;  // N/mm
};

struct TipValues {
    double K_I = 0.0, K_II = 0.0;  // MPa sqrt(mm), by the interaction integral
    double J = 0.0;                // N/mm
};

/// In equilibrium under a load.
class Equilibrium {
public:
    Equilibrium(const Plate& plate, const CrackedGrid& grid, Eigen::VectorXd u, std::vector<Touching> touching)
        : plate_(plate), grid_(grid), pairs_(grid.pairs()), u_(std::move(u)), touching_(std::move(touching)) {}

    /// What the faces of a segment push with, N/mm.
    [[nodiscard]] double force(std::size_t segment) const;
    /// How much of a segment touches, mm: each pair stands for half the way to its neighbours.
    [[nodiscard]] double contact_length(std::size_t segment) const;
    /// Plus less minus, on the parabola of an element's edge.
    [[nodiscard]] Vec jump(double s) const;
    /// Of integrals over a disk about the last or the first point of the crack, which is straight in it.
    [[nodiscard]] TipValues tip(bool last, double radius) const;

private:
    [[nodiscard]] Vec jump_of(const CrackedGrid::Pair& pair) const {
        return u_.segment<2>(2 * pair.plus) - u_.segment<2>(2 * pair.minus);
    }

    const Plate& plate_;
    const CrackedGrid& grid_;
    std::vector<CrackedGrid::Pair> pairs_;
    Eigen::VectorXd u_;
    std::vector<Touching> touching_;
};

/// Made ready for any number of loads.
class PressedPlate {
public:
    PressedPlate(const Plate& plate, const Sizes& sizes);
    PressedPlate(const PressedPlate&) = delete;
    PressedPlate& operator=(const PressedPlate&) = delete;

    [[nodiscard]] Equilibrium under(const Load& load) const;
    [[nodiscard]] int unknowns() const { return 2 * grid_.nodes(); }

private:
    [[nodiscard]] Eigen::SparseMatrix<double> stiffness() const;
    [[nodiscard]] Eigen::VectorXd forces_of(const Load& load) const;
    [[nodiscard]] Eigen::VectorXd push_of(const Touching& pair) const;
    [[nodiscard]] Eigen::VectorXd gaps_of(const Eigen::VectorXd& u) const;
    /// Of the pairs, N/mm, for the gaps without any.
    [[nodiscard]] Eigen::VectorXd pressing_forces(const Eigen::VectorXd& gaps) const;

    Plate plate_;
    CrackedGrid grid_;
    std::vector<CrackedGrid::Pair> pairs_;
    std::vector<Touching> touching_;
    Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> factor_;
    Eigen::MatrixXd compliance_;  // gaps by forces
};

}  // namespace stria::test::conforming
