// The port: all that the coarse component knows of the fine one. Direct object, thread, or MPI process: it cannot tell.
#pragma once

#include <utility>

#include "coupling/messages.hpp"
#include "coupling/zone_snapshot.hpp"

namespace stria::coupling {

class FineScale {
public:
    FineScale() = default;
    FineScale(const FineScale&) = delete;
    FineScale& operator=(const FineScale&) = delete;
    virtual ~FineScale() = default;

    /// A new zone (Fig. 3a, or an extension); what it shares with the old one keeps its points and history.
    virtual void set_patch(const Patch& patch) = 0;

    /// Lets the set_patch() of the same patch, which should follow, begin, where the transport allows: several rebuild
    /// their zones side by side, and the structure is busy meanwhile.
    virtual void begin_set_patch(const Patch& /*patch*/) {}

    /// What predictors start from: the last increments of the displacement of all unknowns of the patch's mesh, mm, a
    /// column each, the last of all first. They go along with the tips of growing cracks (MovedField).
    [[nodiscard]] virtual Eigen::MatrixXd increments() { return {}; }

    /// Asks for the response to boundary displacements; returns at once where the transport allows.
    virtual void request(const PatchDisplacement& displacement) = 0;

    /// The answer to the last request. Throws NumericalFailure where a return mapping or a factorisation failed.
    virtual PatchResponse collect() = 0;

    /// Whether collect() would not have to wait. Where it would: a moment of sleep, until something arrives.
    [[nodiscard]] virtual bool has_answered() { return true; }
    virtual void wait_a_moment() {}

    /// Lets the commit() that must follow begin, where the transport allows: several commit side by side.
    virtual void begin_commit(const Commit& /*what*/) {}

    /// Trial becomes committed.
    virtual StepReport commit(const Commit& what) = 0;

    /// Trial becomes what was committed.
    virtual void rollback() = 0;

    /// Committed states of all points.
    virtual ZoneState state() = 0;

    /// All that is committed and remembered. Between increments only.
    virtual ZoneSnapshot snapshot() = 0;

    /// A snapshot that stays where the zone is, until the next one; and the last that was kept.
    virtual void keep() { keep_snapshot(snapshot()); }
    virtual ZoneSnapshot kept() { return kept_; }

    /// In place of set_patch(), the same patch: goes on from a snapshot, bit for bit where as many ranks gave it.
    virtual void restore(const Patch& patch, const ZoneSnapshot& snapshot) = 0;

    /// As begin_set_patch().
    virtual void begin_restore(const Patch& /*patch*/, const ZoneSnapshot& /*snapshot*/) {}

protected:
    void keep_snapshot(ZoneSnapshot snapshot) { kept_ = std::move(snapshot); }

private:
    ZoneSnapshot kept_;
};

}  // namespace stria::coupling
