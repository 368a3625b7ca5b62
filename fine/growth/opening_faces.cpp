#include "fine/growth/opening_faces.hpp"

#include <algorithm>
#include <map>

#include "common/index.hpp"
#include "common/integration/element_operator.hpp"

namespace stria::fine {

std::vector<int> cracks_of_unknowns(const EnrichedMesh& mesh) {
    std::vector<int> cracks(at(mesh.unknowns), -1);
    for (const auto& [node, term, unknown] : mesh.own_unknowns()) {
        if (term == 0) continue;
        const Term& function = mesh.terms[at(node)][at(term - 1)];
        const bool jumps = function.kind == Term::Kind::Heaviside;
        cracks[at(unknown)] = cracks[at(unknown + 1)] = jumps ? function.owner : mesh.tip_of(function).crack;
    }
    return cracks;
}

OpeningFaces::OpeningFaces(const Eigen::VectorXd& held, const std::vector<int>& crack_of) {
    std::map<int, std::vector<int>> jumps;
    for (int i = 0; i < held.size(); ++i)
        if (held[i] != 0.0) jumps[crack_of[at(i)]].push_back(i);
    for (const auto& [crack, unknowns] : jumps) of_cracks_.push_back({unknowns, gather(held, unknowns), {}});
}

void OpeningFaces::open(const EnrichedMesh& before, const EnrichedMesh& next, const Eigen::VectorXd& held) {
    const Eigen::VectorXd still = this->held(before.unknowns);
    const std::vector<int> same = same_unknowns(next, before);
    Eigen::VectorXd all = Eigen::VectorXd::Zero(next.unknowns);
    for (const auto& [node, term, unknown] : next.own_unknowns()) {
        const int own = same[at(unknown)];
        if (own >= 0)
            all.segment<2>(unknown) = still.segment<2>(own);
        else if (term > 0)
            all.segment<2>(unknown) = held.segment<2>(unknown);
    }
    *this = OpeningFaces(all, cracks_of_unknowns(next));
}

void OpeningFaces::hold_changes(const EnrichedMesh& before, const Eigen::VectorXd& force, const EnrichedMesh& next,
                                const Eigen::VectorXd& now, const UnknownSet& changed) {
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(next.unknowns);
    const Eigen::VectorXd balanced = carry_over(before, force, next, zero);
    Eigen::VectorXd held = carry_over(before, this->held(before.unknowns), next, zero);
    for (int i = 0; i < next.unknowns; ++i)
        if (changed.contains(i)) held[i] += balanced[i] - now[i];
    *this = OpeningFaces(held, cracks_of_unknowns(next));
}

void OpeningFaces::follow(const EnrichedMesh& before, const EnrichedMesh& next) {
    if (!any()) return;
    const Eigen::VectorXd held =
        carry_over(before, this->held(before.unknowns), next, Eigen::VectorXd::Zero(next.unknowns));
    *this = OpeningFaces(held, cracks_of_unknowns(next));
}

void OpeningFaces::hold(double share, Eigen::VectorXd& load) const {
    if (share == 0.0) return;
    for (const NewFaces& faces : of_cracks_) load(faces.jumps) -= share * faces.held;
}

void OpeningFaces::begin(const Eigen::VectorXd& first_step) {
    for (NewFaces& faces : of_cracks_) faces.first_step = gather(first_step, faces.jumps);
}

double OpeningFaces::NewFaces::release(const Eigen::VectorXd& opening, double share) {
    const bool begun = first_step.size() == opening.size();
    const double opened = held.dot(opening);
    const auto [least, most] = std::minmax({0.0, 2.0 * opened});  // beyond them the parabola turns back
    const double first = begun ? std::clamp(held.dot(first_step), least, most) : opened;
    held *= share;
    first_step.resize(0);
    return share * opened + (1.0 - share) * (opened / 3.0 + first / 6.0);
}

double OpeningFaces::release(const Eigen::VectorXd& move, double share) {
    double released = 0.0;
    for (NewFaces& faces : of_cracks_) released += faces.release(gather(move, faces.jumps), share);
    if (share == 0.0) of_cracks_.clear();
    return released;
}

Eigen::VectorXd OpeningFaces::held(int unknowns) const {
    Eigen::VectorXd held = Eigen::VectorXd::Zero(unknowns);
    for (const NewFaces& faces : of_cracks_) held(faces.jumps) = faces.held;
    return held;
}

}  // namespace stria::fine
