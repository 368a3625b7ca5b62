#include "coarse/model/rigid_motions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/LU>
#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

using Motions =
    Eigen::Matrix<double, 3, Eigen::Dynamic>;  // columns: amplitudes of the two translations and the rotation
using MotionRow = Eigen::RowVector3d;

constexpr double rounding = 1e-9;

/// Translations along x and y, and the rotation about the middle of the body, scaled to displacements of its own order.
struct Frame {
    Vec2 low, high;

    explicit Frame(const Mesh& mesh) : low(mesh.nodes.front()), high(mesh.nodes.front()) {
        for (const Vec2& node : mesh.nodes) {
            low = low.cwiseMin(node);
            high = high.cwiseMax(node);
        }
    }

    /// The three motions' displacement component at x.
    [[nodiscard]] MotionRow at(const Vec2& x, int component) const {
        const Vec2 arm = (x - 0.5 * (low + high)) / (0.5 * (high - low).norm());
        return component == 0 ? MotionRow(1.0, 0.0, -arm.y()) : MotionRow(0.0, 1.0, arm.x());
    }
};

Eigen::MatrixXd supported_motions(const Mesh& mesh, const Loads& loads, const Frame& frame) {
    const auto rows = static_cast<Eigen::Index>(loads.displacements.size());
    Eigen::MatrixXd supported = Eigen::MatrixXd::Zero(std::max<Eigen::Index>(rows, 3), 3);
    for (Eigen::Index row = 0; row < rows; ++row) {
        const PrescribedDisplacement& held = loads.displacements[at(row)];
        supported.row(row) = frame.at(mesh.nodes[at(held.node)], held.component);
    }
    return supported;
}

/// Orthonormal basis of the motions that no support feels.
Motions free_motions(const Eigen::MatrixXd& supported) {
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(supported, Eigen::ComputeThinV);
    const Eigen::VectorXd& values = svd.singularValues();
    const auto rank = (values.array() > rounding * std::max(1.0, values[0])).count();
    return svd.matrixV().rightCols(3 - rank);
}

bool is_free(int motion, const Eigen::MatrixXd& supported) {
    return supported.col(motion).cwiseAbs().maxCoeff() <= rounding;
}

/// A support holds one component, so free translations lie along the axes; what else is free turns the body.
std::vector<std::string> names_of(const Eigen::MatrixXd& supported, Eigen::Index count) {
    std::vector<std::string> names;
    if (is_free(0, supported)) names.emplace_back("translation along x");
    if (is_free(1, supported)) names.emplace_back("translation along y");
    if (static_cast<Eigen::Index>(names.size()) < count) names.emplace_back("rotation");
    return names;
}

void require_balance(const Mesh& mesh, const Loads& loads, const Frame& frame, const Motions& motions,
                     const Eigen::MatrixXd& supported) {
    Eigen::Vector3d work = Eigen::Vector3d::Zero();
    double magnitude = 0.0;
    for (const auto& [x, force] : applied_forces(mesh, loads)) {
        work += force.x() * frame.at(x, 0) + force.y() * frame.at(x, 1);
        magnitude += force.norm();
    }
    if ((motions.transpose() * work).norm() <= rounding * magnitude) return;
    const auto drive = [&](int motion) {
        return is_free(motion, supported) && std::abs(work[motion]) > rounding * magnitude;
    };
    // What is left of loads that were meant to balance: on chords a pressure pulls by less than on their arc.
    const auto moved = [&](int motion) {
        return fmt::format("translation along {} free and the loads drive it by {:.4g} N/mm, of {:.4g} that act",
                           motion == 0 ? "x" : "y", work[motion], magnitude);
    };
    throw CaseError(fmt::format("boundary: the supports leave the {}; support it or balance the loads",
                                drive(0)   ? moved(0)
                                : drive(1) ? moved(1)
                                           : "rotation free and the loads drive it"));
}

/// The mesh nodes nearest to the corners of the bounding box: far from each other, and seldom near a crack.
std::array<int, 4> corner_nodes(const Mesh& mesh, const Frame& frame) {
    const std::array<Vec2, 4> corners{frame.low, Vec2{frame.high.x(), frame.low.y()}, frame.high,
                                      Vec2{frame.low.x(), frame.high.y()}};
    std::array<int, 4> nodes{};
    std::array<double, 4> nearest{};  // squared
    nearest.fill(std::numeric_limits<double>::infinity());
    for (int node = 0; node < std::ssize(mesh.nodes); ++node) {
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const double distance = (mesh.nodes[at(node)] - corners[corner]).squaredNorm();
            if (distance < nearest[corner]) nearest[corner] = distance, nodes[corner] = node;
        }
    }
    return nodes;
}

/// Of all sets of corner displacements, as many as there are free motions, the one that feels them best.
std::vector<Pin> choose_pins(const Mesh& mesh, const Frame& frame, const Motions& motions) {
    const std::array<int, 4> corners = corner_nodes(mesh, frame);
    std::vector<Pin> best;
    double best_determinant = 0.0;
    for (unsigned set = 0; set < 256; ++set) {
        if (std::popcount(set) != motions.cols()) continue;
        std::vector<Pin> pins;
        Eigen::MatrixXd felt(motions.cols(), motions.cols());
        for (unsigned candidate = 0; candidate < 8; ++candidate) {
            if ((set >> candidate & 1U) == 0) continue;
            const Pin pin{corners[candidate / 2], static_cast<int>(candidate % 2)};
            felt.row(static_cast<Eigen::Index>(pins.size())) =
                frame.at(mesh.nodes[at(pin.node)], pin.component) * motions;
            pins.push_back(pin);
        }
        const double determinant = std::abs(felt.determinant());
        if (determinant > (1.0 + rounding) * best_determinant) {  // ties go to the first: same pins on every machine
            best = pins;
            best_determinant = determinant;
        }
    }
    require(best_determinant > 1e-6, "corner nodes feel every rigid motion");
    return best;
}

std::string describe(const Mesh& mesh, const FreeMotions& motions) {
    std::vector<std::string> held;
    for (const Pin& pin : motions.pins) {
        const Vec2& x = mesh.nodes[at(pin.node)];
        held.push_back(fmt::format("u_{} at ({:.6g}, {:.6g})", pin.component == 0 ? 'x' : 'y', x.x(), x.y()));
    }
    return fmt::format("the supports leave free: {}; the loads balance, so it is removed without stress by holding {}",
                       fmt::join(motions.names, ", "), fmt::join(held, ", "));
}

}  // namespace

FreeMotions analyse_rigid_motions(const Mesh& mesh, const Loads& loads) {
    const Frame frame(mesh);
    const Eigen::MatrixXd supported = supported_motions(mesh, loads, frame);
    const Motions motions = free_motions(supported);
    if (motions.cols() == 0) return {};
    require_balance(mesh, loads, frame, motions, supported);

    FreeMotions result{names_of(supported, motions.cols()), choose_pins(mesh, frame, motions), {}};
    result.text = describe(mesh, result);
    return result;
}

bool is_left_free(const std::vector<AppliedForce>& sum, const Mesh& mesh, const Loads& loads) {
    const Frame frame(mesh);
    MotionRow change = MotionRow::Zero();
    double magnitude = 0.0;
    for (const auto& [x, force] : sum) {
        for (const int component : {0, 1}) change += force[component] * frame.at(x, component);
        magnitude += force.norm();
    }
    const Motions motions = free_motions(supported_motions(mesh, loads, frame));
    return (change * motions).norm() > rounding * magnitude;
}

}  // namespace stria::coarse
