#include "coarse/elements/support_forces.hpp"

#include <algorithm>

#include "coarse/elements/elastic_force.hpp"

namespace stria::coarse {

Eigen::VectorXd forces_on_prescribed(const CoarseElements& elements, const Eigen::VectorXd& u) {
    const Scene& scene = elements.scene();
    std::vector<int> row(at(scene.enriched.unknowns), -1);
    for (std::size_t k = 0; k < scene.prescribed.size(); ++k)
        row[at(scene.prescribed[k].unknown)] = static_cast<int>(k);
    Eigen::VectorXd forces = Eigen::VectorXd::Zero(std::ssize(scene.prescribed));
    elements.for_each(elements.supported(), [&](const auto& op) {
        const auto force = elastic_force(op, gather(u, op.unknowns), scene.stiffness(op.element));
        for (std::size_t k = 0; k < op.unknowns.size(); ++k) {
            const int own = row[at(op.unknowns[k])];
            if (own >= 0) forces[own] += force[static_cast<Eigen::Index>(k)];
        }
    });
    return forces;
}

Eigen::VectorXd loads_on_prescribed(const Scene& scene, const Eigen::VectorXd& load) {
    Eigen::VectorXd loads(std::ssize(scene.prescribed));
    std::ranges::transform(scene.prescribed, loads.begin(),
                           [&](const PrescribedUnknown& p) { return load[p.unknown]; });
    return loads;
}

Eigen::VectorXd load_of_imposed(const CoarseElements& elements, const Eigen::VectorXd& imposed) {
    const Scene& scene = elements.scene();
    Eigen::VectorXd load = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    elements.for_each(elements.supported(), [&](const auto& op) {
        const auto reaction = (op.stiffness(scene.stiffness(op.element)) * gather(imposed, op.unknowns)).eval();
        for (std::size_t i = 0; i < op.unknowns.size(); ++i)
            load[op.unknowns[i]] -= reaction[static_cast<Eigen::Index>(i)];
    });
    return load;
}

}  // namespace stria::coarse
