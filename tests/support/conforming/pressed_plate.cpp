#include "tests/support/conforming/pressed_plate.hpp"

namespace stria::test::conforming {

PressedPlate::PressedPlate(const Plate& plate, const Sizes& sizes)
    : plate_(plate), grid_(plate.width, plate.height, plate.crack, sizes), pairs_(grid_.pairs()), factor_(stiffness()) {
    if (factor_.info() != Eigen::Success) throw std::runtime_error("the stiffness is not positive");
    const std::vector<Vec>& points = plate_.crack.points;
    for (std::size_t k = 0; k < pairs_.size(); ++k)
        for (std::size_t segment = 0; segment + 1 < points.size(); ++segment)
            if (pairs_[k].x >= points[segment].x() && pairs_[k].x <= points[segment + 1].x())
                touching_.push_back({k, segment});
    compliance_.resize(std::ssize(touching_), std::ssize(touching_));
    for (std::size_t c = 0; c < touching_.size(); ++c)
        compliance_.col(Eigen::Index(c)) = gaps_of(factor_.solve(push_of(touching_[c])));
}

Eigen::SparseMatrix<double> PressedPlate::stiffness() const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(std::size_t(grid_.elements_across() * grid_.elements_up() * 324));
    const double mu = plate_.shear_modulus(), lambda = plate_.lame();
    for (int j = 0; j < grid_.elements_up(); ++j) {
        for (int i = 0; i < grid_.elements_across(); ++i) {
            const auto nodes = grid_.nodes_of(i, j);
            Eigen::Matrix<double, 18, 18> K = Eigen::Matrix<double, 18, 18>::Zero();
            for (const auto& [xi, by_xi] : gauss) {
                for (const auto& [eta, by_eta] : gauss) {
                    const Functions f(grid_.places_of(i, j), xi, eta);
                    const double weight = f.area * by_xi * by_eta;
                    for (int a = 0; a < 9; ++a) {
                        for (int b = 0; b < 9; ++b) {
                            const Eigen::Matrix2d product = f.gradient.row(a).transpose() * f.gradient.row(b);
                            K.block<2, 2>(2 * a, 2 * b) +=
                                weight * (lambda * product +
                                          mu * (product.transpose() + product.trace() * Eigen::Matrix2d::Identity()));
                        }
                    }
                }
            }
            for (int a = 0; a < 18; ++a)
                for (int b = 0; b < 18; ++b)
                    entries.emplace_back(2 * nodes[std::size_t(a / 2)] + a % 2, 2 * nodes[std::size_t(b / 2)] + b % 2,
                                         K(a, b));
        }
    }
    // The loads balance: three springs to the ground bear nothing.
    for (const int held : {0, 1, 2 * grid_.nodes_across() - 1}) entries.emplace_back(held, held, plate_.young);
    Eigen::SparseMatrix<double> K(unknowns(), unknowns());
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

Eigen::VectorXd PressedPlate::forces_of(const Load& load) const {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(unknowns());
    const auto pull = [&](int i, int j, const std::array<std::size_t, 3>& edge, const Vec& outward) {
        const auto nodes = grid_.nodes_of(i, j);
        const auto places = grid_.places_of(i, j);
        const Vec start = places[edge[0]], end = places[edge[2]];
        for (const auto& [t, weight] : gauss) {
            Eigen::Matrix2d stress = load.stress;
            stress(1, 1) += load.bending * (0.5 * (start + end + t * (end - start)).x() - 0.5 * plate_.width);
            const Eigen::Vector3d value(0.5 * t * (t - 1.0), 1.0 - t * t, 0.5 * t * (t + 1.0));
            for (std::size_t k = 0; k < 3; ++k)
                force.segment<2>(2 * nodes[edge[k]]) +=
                    0.5 * (end - start).norm() * weight * value[Eigen::Index(k)] * (stress * outward);
        }
    };
    for (int i = 0; i < grid_.elements_across(); ++i) {
        pull(i, 0, {0, 1, 2}, {0.0, -1.0});
        pull(i, grid_.elements_up() - 1, {6, 7, 8}, {0.0, 1.0});
    }
    for (int j = 0; j < grid_.elements_up(); ++j) {
        pull(0, j, {0, 3, 6}, {-1.0, 0.0});
        pull(grid_.elements_across() - 1, j, {2, 5, 8}, {1.0, 0.0});
    }
    return force;
}

Eigen::VectorXd PressedPlate::push_of(const Touching& touching) const {
    Eigen::VectorXd push = Eigen::VectorXd::Zero(unknowns());
    const Vec normal = plate_.crack.normal(touching.segment);
    push.segment<2>(2 * pairs_[touching.pair].plus) = normal;
    push.segment<2>(2 * pairs_[touching.pair].minus) = -normal;
    return push;
}

Eigen::VectorXd PressedPlate::gaps_of(const Eigen::VectorXd& u) const {
    Eigen::VectorXd gaps(std::ssize(touching_));
    for (std::size_t c = 0; c < touching_.size(); ++c) {
        const CrackedGrid::Pair& pair = pairs_[touching_[c].pair];
        gaps[Eigen::Index(c)] =
            plate_.crack.normal(touching_[c].segment).dot(u.segment<2>(2 * pair.plus) - u.segment<2>(2 * pair.minus));
    }
    return gaps;
}

// p >= 0, g = g_0 + F p >= 0, p g = 0. F is positive, so there is one solution. Changing all that is wrong at once
// finds it soon, or never; Murty's rule, the first one alone, finds it always.
Eigen::VectorXd PressedPlate::pressing_forces(const Eigen::VectorXd& gaps) const {
    constexpr int at_once = 30, at_most = 10'000;
    const Eigen::Index count = gaps.size();
    const Eigen::VectorXd own = compliance_.diagonal();
    const double rounding = 1e-9 * gaps.cwiseQuotient(own).cwiseAbs().maxCoeff();
    Eigen::VectorXi closed = Eigen::VectorXi::Zero(count);
    for (int round = 0; round < at_most; ++round) {
        std::vector<Eigen::Index> pressed;
        for (Eigen::Index c = 0; c < count; ++c)
            if (closed[c] != 0) pressed.push_back(c);
        Eigen::VectorXd p = Eigen::VectorXd::Zero(count);
        const Eigen::MatrixXd among = compliance_(pressed, pressed);
        const Eigen::VectorXd shut = -gaps(pressed);
        const Eigen::VectorXd pushing = among.llt().solve(shut);
        p(pressed) = pushing;
        const Eigen::VectorXd g = gaps + compliance_ * p;
        bool changed = false;
        for (Eigen::Index c = 0; c < count && !(changed && round >= at_once); ++c) {
            if ((closed[c] != 0 ? p[c] : g[c] / own[c]) >= -rounding) continue;
            closed[c] = 1 - closed[c];
            changed = true;
        }
        if (!changed) return p;
    }
    throw std::runtime_error("no pressing forces found");
}

Equilibrium PressedPlate::under(const Load& load) const {
    Eigen::VectorXd force = forces_of(load);
    const Eigen::VectorXd p = pressing_forces(gaps_of(factor_.solve(force)));
    std::vector<Touching> touching = touching_;
    for (std::size_t c = 0; c < touching.size(); ++c) {
        touching[c].force = p[Eigen::Index(c)];
        force += touching[c].force * push_of(touching[c]);
    }
    return {plate_, grid_, factor_.solve(force), touching};
}

double Equilibrium::force(std::size_t segment) const {
    double sum = 0.0;
    for (const Touching& t : touching_)
        if (t.segment == segment) sum += t.force;
    return sum;
}

double Equilibrium::contact_length(std::size_t segment) const {
    double start = 0.0, sum = 0.0;
    for (std::size_t k = 0; k < segment; ++k) start += plate_.crack.length(k);
    const double end = start + plate_.crack.length(segment);
    for (const Touching& t : touching_) {
        if (t.segment != segment || t.force <= 0.0) continue;
        const double here = pairs_[t.pair].s, before = t.pair > 0 ? pairs_[t.pair - 1].s : start,
                     after = t.pair + 1 < pairs_.size() ? pairs_[t.pair + 1].s : end;
        sum += std::min(0.5 * (here + after), end) - std::max(0.5 * (here + before), start);
    }
    return sum;
}

Vec Equilibrium::jump(double s) const {
    std::vector<double> at;  // corners and midpoints of edges in turn, from a corner to a corner
    std::vector<Vec> jumps;
    const auto add = [&](double place, const Vec& jump) { at.push_back(place), jumps.push_back(jump); };
    const Polyline& crack = plate_.crack;
    if (!crack.at_edge()) add(0.0, Vec::Zero());
    for (const CrackedGrid::Pair& pair : pairs_) add(pair.s, jump_of(pair));
    add(crack.arc_length(crack.points.back().x()), Vec::Zero());
    std::size_t k = 0;
    while (k + 4 < at.size() && at[k + 2] < s) k += 2;
    const double t = (s - at[k]) / (at[k + 2] - at[k]);
    return (1.0 - t) * (1.0 - 2.0 * t) * jumps[k] + 4.0 * t * (1.0 - t) * jumps[k + 1] +
           t * (2.0 * t - 1.0) * jumps[k + 2];
}

namespace {

/// Gradient of the displacement of K_I = 1 or K_II = 1 in the axes of a tip.
Eigen::Matrix2d singular_gradient(int mode, const Vec& x, const Plate& plate) {
    const double kappa = 3.0 - 4.0 * plate.poisson, r = x.norm(), t = std::atan2(x.y(), x.x()), c = std::cos(t / 2.0),
                 s = std::sin(t / 2.0), scale = std::sqrt(r / (2.0 * std::numbers::pi)) / (2.0 * plate.shear_modulus());
    // u = scale f(t), with f and its derivative by t
    const double cos_t = std::cos(t), sin_t = std::sin(t);
    Vec f, slope;
    if (mode == 1) {
        f = (kappa - cos_t) * Vec(c, s);
        slope = sin_t * Vec(c, s) + (kappa - cos_t) * Vec(-s, c) / 2.0;
    } else {
        f = Vec((kappa + 2.0 + cos_t) * s, -(kappa - 2.0 + cos_t) * c);
        slope = Vec(-sin_t * s + (kappa + 2.0 + cos_t) * c / 2.0, sin_t * c + (kappa - 2.0 + cos_t) * s / 2.0);
    }
    const Vec along_r = x / r, along_t(-along_r.y(), along_r.x());
    return scale / r * (0.5 * f * along_r.transpose() + slope * along_t.transpose());
}

}  // namespace

TipValues Equilibrium::tip(bool last, double radius) const {
    const Polyline& crack = plate_.crack;
    const std::size_t segment = last ? crack.segments() - 1 : 0;
    const Vec tip = last ? crack.points.back() : crack.points.front(),
              ahead = (last ? 1.0 : -1.0) * crack.tangent(segment);
    Eigen::Matrix2d axes;  // in rows
    axes << ahead.x(), ahead.y(), -ahead.y(), ahead.x();
    const auto weight_at = [&](const Vec& x) { return std::clamp(2.0 - 2.0 * (x - tip).norm() / radius, 0.0, 1.0); };
    double J = 0.0, M[2] = {0.0, 0.0};
    for (int j = 0; j < grid_.elements_up(); ++j) {
        for (int i = 0; i < grid_.elements_across(); ++i) {
            const auto places = grid_.places_of(i, j);
            const auto nodes = grid_.nodes_of(i, j);
            Eigen::Matrix<double, 9, 1> q;
            for (int k = 0; k < 9; ++k) q[k] = weight_at(places[std::size_t(k)]);
            if (q.minCoeff() == q.maxCoeff()) continue;
            for (const auto& [xi, by_xi] : gauss) {
                for (const auto& [eta, by_eta] : gauss) {
                    const Functions f(places, xi, eta);
                    Eigen::Matrix2d own = Eigen::Matrix2d::Zero();
                    Vec x = Vec::Zero();
                    for (int k = 0; k < 9; ++k) {
                        own += u_.segment<2>(2 * nodes[std::size_t(k)]) * f.gradient.row(k);
                        x += f.value[k] * places[std::size_t(k)];
                    }
                    own = axes * own * axes.transpose();
                    const Eigen::Matrix2d stress = plate_.stress_of(own);
                    const Vec slope = axes * (f.gradient.transpose() * q);
                    const double area = f.area * by_xi * by_eta;
                    const auto flow = [&](const Eigen::Matrix2d& sigma, const Eigen::Matrix2d& gradient) {
                        return gradient.col(0).dot(sigma * slope);
                    };
                    J += area * (flow(stress, own) - 0.5 * stress.cwiseProduct(own).sum() * slope[0]);
                    for (const int mode : {1, 2}) {
                        const Eigen::Matrix2d other = singular_gradient(mode, axes * (x - tip), plate_);
                        M[mode - 1] += area * (flow(stress, other) + flow(plate_.stress_of(other), own) -
                                               stress.cwiseProduct(other).sum() * slope[0]);
                    }
                }
            }
        }
    }
    // Pressed faces do work on the opening of the singular field. Up to the tip there is none.
    double by_faces = 0.0;
    for (const Touching& t : touching_) {
        const Vec x(pairs_[t.pair].x, crack.height(pairs_[t.pair].x));
        if (t.segment == segment)
            by_faces += weight_at(x) * t.force * 2.0 / std::sqrt(2.0 * std::numbers::pi * (x - tip).norm());
    }
    const Touching& nearest = last ? touching_.back() : touching_.front();
    const double K_I = nearest.force > 0.0 ? 0.0 : 0.5 * plate_.plane_modulus() * M[0] + by_faces;
    return {K_I, 0.5 * plate_.plane_modulus() * M[1], J};
}

}  // namespace stria::test::conforming
