#include "fine/bulk/soft_jumps.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "common/regula_falsi.hpp"

namespace stria::fine {

namespace {

/// Of each unknown: the first one of a jump that is the zone's own.
UnknownSet own_jumps(const EnrichedMesh& mesh, const std::vector<int>& boundary) {
    UnknownSet jumps(mesh.unknowns);
    for (const auto& [node, term, unknown] : mesh.own_unknowns())
        if (term > 0 && mesh.terms[at(node)][at(term - 1)].kind == Term::Kind::Heaviside) jumps.insert(unknown);
    for (const int unknown : boundary) {
        jumps.erase(unknown);
        if (unknown > 0) jumps.erase(unknown - 1);
    }
    return jumps;
}

/// Integral of |grad phi|^2 over an element; phi is one of its functions.
double gradient_energy(const ElementOperator& op, int function) {
    double sum = 0.0;
    for (std::size_t q = 0; q < op.points.size(); ++q)
        sum += op.points[q].weight * op.gradients[q].row(function).squaredNorm();
    return sum;
}

}  // namespace

SoftJumps::SoftJumps(const BulkElements& elements, const std::vector<int>& boundary, double tolerance)
    : tolerance_(tolerance), in_(at(elements.count())) {
    constexpr double soft = 2.0;  // 0.57 of a row of squares beyond the crack: functions jump by two
    const UnknownSet candidates = own_jumps(elements.mesh(), boundary);
    std::vector<double> energy(at(elements.mesh().unknowns));
    std::vector<std::vector<int>> around(energy.size());
    for (int e = 0; e < elements.count(); ++e) {
        const ElementOperator& op = elements.op(e);
        for (int f = 0; f < std::ssize(op.unknowns) / 2; ++f) {
            const int unknown = op.unknowns[at(2 * f)];
            if (!candidates.contains(unknown)) continue;
            energy[at(unknown)] += gradient_energy(op, f);
            around[at(unknown)].push_back(e);
        }
    }
    for (const int unknown : candidates.members()) {
        if (energy[at(unknown)] > soft) continue;
        for (const int e : around[at(unknown)]) in_[at(e)].push_back(static_cast<int>(jumps_.size()));
        jumps_.push_back({unknown, std::move(around[at(unknown)])});
    }
}

std::vector<int> SoftJumps::unknowns() const {
    std::vector<int> unknowns;
    for (const Jump& jump : jumps_) unknowns.push_back(jump.unknown);
    return unknowns;
}

void SoftJumps::settle(Bulk& bulk, Eigen::VectorXd& u, const Eigen::VectorXd& load, const UnknownSet& held) const {
    const std::vector<Group> groups = flowing(bulk, held);
    for (const Group& group : groups) settle(group, bulk, u, load);
    if (!groups.empty()) bulk.sum_forces();
}

// From each element that flows on to those that share a soft jump with it.
std::vector<SoftJumps::Group> SoftJumps::flowing(const Bulk& bulk, const UnknownSet& held) const {
    std::vector<Group> groups;
    std::vector<char> met(jumps_.size());
    for (std::size_t first = 0; first < jumps_.size(); ++first) {
        std::vector<int> found;
        const auto meet = [&](int jump) {
            const auto& [unknown, elements] = jumps_[at(jump)];
            if (std::exchange(met[at(jump)], 1) == 0 && contains_any(bulk.softened(), elements) &&
                !contains_any(bulk.resting().elements(), elements) && !held.contains(unknown) &&
                !held.contains(unknown + 1))
                found.push_back(jump);
        };
        meet(static_cast<int>(first));
        for (std::size_t k = 0; k < found.size(); ++k)
            for (const int e : jumps_[at(found[k])].elements)
                if (bulk.softened().contains(e)) std::ranges::for_each(in_[at(e)], meet);
        if (!found.empty()) groups.push_back(group(std::move(found), bulk));
    }
    return groups;
}

SoftJumps::Group SoftJumps::group(std::vector<int> jumps, const Bulk& bulk) const {
    Group group;
    std::vector<int> elements;
    std::ranges::sort(jumps);
    for (const int jump : jumps) {
        const auto& [unknown, around] = jumps_[at(jump)];
        group.unknowns.insert(group.unknowns.end(), {unknown, unknown + 1});
        elements.insert(elements.end(), around.begin(), around.end());
    }
    std::ranges::sort(elements);
    elements.erase(std::ranges::unique(elements).begin(), elements.end());
    for (const int e : elements) {
        Part& part = group.parts.emplace_back(Part{.element = e, .own = {}, .of_group = {}});
        const std::vector<int>& unknowns = bulk.elements().op(e).unknowns;
        for (std::size_t k = 0; k < unknowns.size(); ++k) {
            const auto place = std::ranges::lower_bound(group.unknowns, unknowns[k]);
            if (place == group.unknowns.end() || *place != unknowns[k]) continue;
            part.own.push_back(static_cast<int>(k));
            part.of_group.push_back(static_cast<int>(place - group.unknowns.begin()));
        }
    }
    return group;
}

SoftJumps::Balance SoftJumps::balance(const Group& group, const Bulk& bulk, const Eigen::VectorXd& load) {
    Eigen::VectorXd residual = load(group.unknowns), scale = residual.cwiseAbs();
    for (const auto& [element, own, of_group] : group.parts) {
        const Eigen::VectorXd force = bulk.trial_force(element)(own);
        residual(of_group) -= force;
        scale(of_group) += force.cwiseAbs();
    }
    return {std::move(residual), scale.maxCoeff()};
}

bool SoftJumps::Balance::within(double share, double rounding) const {
    return residual.lpNorm<Eigen::Infinity>() <= std::max(share * scale, rounding);
}

Eigen::VectorXd SoftJumps::correction(const Group& group, const Bulk& bulk, const Eigen::VectorXd& residual) {
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(residual.size(), residual.size());
    for (const auto& [element, own, of_group] : group.parts) K(of_group, of_group) += bulk.tangent(element)(own, own);
    return K.partialPivLu().solve(residual);
}

// Newton's method, with the part of each correction that takes half of the residual's work along it.
void SoftJumps::settle(const Group& group, Bulk& bulk, Eigen::VectorXd& u, const Eigen::VectorXd& load) const {
    constexpr double enough = 0.01;  // of the nodal forces: the next iterate moves all else
    constexpr double little = 0.5;
    constexpr int corrections = 12, parts = 8;
    std::vector<int> elements;
    for (const Part& part : group.parts) elements.push_back(part.element);
    const double rounding = 1e-6 * tolerance_ * bulk.force_scale().maxCoeff();
    Balance state = balance(group, bulk, load);
    for (int k = 0; k < corrections && !state.within(enough, rounding); ++k) {
        const Eigen::VectorXd full = correction(group, bulk, state.residual), from = u(group.unknowns);
        const double work = full.dot(state.residual);
        if (!full.allFinite() || work <= 0.0) return;
        RegulaFalsi root;
        for (int tries = 0; tries < parts; ++tries) {
            u(group.unknowns) = from + root.guess() * full;
            bulk.evaluate_again(elements, u);
            state = balance(group, bulk, load);
            const double left = full.dot(state.residual) / work;
            if (std::abs(left) <= little || (left > 0.0 && !root.has_passed())) break;
            root.narrow(left);
        }
    }
}

}  // namespace stria::fine
