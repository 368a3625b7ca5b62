// What the monolithic system bears, on the unknowns of the whole mesh.
#pragma once

#include <algorithm>
#include <vector>

#include "coarse/equilibrium/largest_forces.hpp"
#include "coarse/structure/structure.hpp"
#include "coupling/messages.hpp"

namespace stria {

class MonolithicLoads {
public:
    /// `whole`: unknown of the whole mesh of each zone unknown. The zone carries the load on its own ones.
    MonolithicLoads(const coarse::Structure& structure, const coupling::Patch& patch, const std::vector<int>& whole)
        : largest_(structure.scene(), structure.elements().initial().load) {
        const coarse::Scene& scene = structure.scene();
        const auto outside_zone = [&](Eigen::VectorXd force) {
            for (int i = 0; i < std::ssize(whole); ++i)
                if (!std::ranges::binary_search(patch.boundary, i)) force[whole[at(i)]] = 0.0;
            return force;
        };
        const Eigen::VectorXd& initial = structure.elements().initial().load;
        initial_ = initial.size() > 0 ? initial : Eigen::VectorXd::Zero(scene.enriched.unknowns).eval();
        main_ = outside_zone(scene.unit_force);
        for (const Eigen::VectorXd& force : scene.case_forces) cases_.push_back(outside_zone(force));
    }

    [[nodiscard]] const Eigen::VectorXd& initial() const { return initial_; }

    /// On the structure's unknowns, that of the initial stress included, N/mm.
    [[nodiscard]] Eigen::VectorXd under(const coarse::LoadFactors& factors) const {
        Eigen::VectorXd load = factors.main * main_ + initial_;
        for (std::size_t k = 0; k < cases_.size(); ++k)
            load += factors.of_case(static_cast<Eigen::Index>(k)) * cases_[k];
        return load;
    }

    /// Largest of the forces of any unit load, N/mm.
    [[nodiscard]] double largest(const coarse::LoadFactors& factors) const { return largest_.under(factors); }

private:
    coarse::LargestForces largest_;
    Eigen::VectorXd initial_, main_;
    std::vector<Eigen::VectorXd> cases_;
};

}  // namespace stria
