// What makes an equilibrium for a structure and a zone: the only thing that an analysis knows of modes.
#pragma once

#include <memory>

#include "coarse/equilibrium/equilibrium.hpp"
#include "coarse/structure/structure.hpp"
#include "coupling/zone_snapshot.hpp"

namespace stria::coarse {

/// How equilibrium is found once structure and zone are known: condensed over a port, or monolithic. Only app/ chooses.
class EquilibriumFactory {
public:
    EquilibriumFactory() = default;
    EquilibriumFactory(const EquilibriumFactory&) = delete;
    EquilibriumFactory& operator=(const EquilibriumFactory&) = delete;
    virtual ~EquilibriumFactory() = default;

    /// `patch`: null where the scene has no zone. `committed`: displacement of the whole mesh, reached at
    /// `factors`.
    virtual std::unique_ptr<Equilibrium> make(const Structure& structure, const coupling::Patch* patch,
                                              const Eigen::VectorXd& committed, const LoadFactors& factors) = 0;

    /// Lets the zone of the make() that must follow, with the same patch, get ready meanwhile, where somebody else has
    /// it.
    virtual void begin_zone(const coupling::Patch& /*patch*/) {}

    /// The zone takes more elements, with their functions as they are; make() is to follow before anyone asks it.
    virtual void extend_zone(const coupling::Patch& patch) = 0;

    /// Whether there is a zone's side, which takes its increments along with growing cracks.
    [[nodiscard]] virtual bool keeps_increments() const = 0;

    /// As make(), but the zone goes on from a snapshot; Equilibrium::restore() is to follow.
    virtual std::unique_ptr<Equilibrium> resume(const Structure& structure, const coupling::Patch* patch,
                                                const Eigen::VectorXd& committed,
                                                const coupling::ZoneSnapshot& zone) = 0;

    /// Full committed state of the zone.
    virtual coupling::ZoneState zone_state() = 0;

    /// All that the zone remembers; there must be one.
    virtual coupling::ZoneSnapshot zone_snapshot() = 0;
    /// Likewise, as coupling::FineScale.
    virtual void keep_zone() = 0;
    virtual coupling::ZoneSnapshot kept_zone() = 0;
};

}  // namespace stria::coarse
