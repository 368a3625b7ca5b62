// The fine components of a run, in this process or in others, behind the one port that the coarse component sees.
#pragma once

#include <memory>
#include <vector>

#include "common/case/case.hpp"
#include "coupling/ranks/fine_ranks.hpp"
#include "coupling/transport/mpi_transport.hpp"
#include "coupling/transport/remote_fine_scale.hpp"

namespace stria {

class FineSide {
public:
    /// All ranks live in this process.
    FineSide(const Case& input, int ranks);

    /// Each peer of the session is one rank. `own_rank`: one more lives in this process, which would otherwise sleep
    /// while the others work. It is the last one: the others are asked first.
    FineSide(const Case& input, const coupling::MpiSession& session, bool own_rank);

    /// The port. Several ranks look like one.
    [[nodiscard]] coupling::FineScale& scale() { return together_ ? *together_ : *scales_.front(); }

    /// Messages and bytes between the coarse component and the ranks, and the number of ranks.
    [[nodiscard]] coupling::WorkCounts traffic() const;

    /// How often history had to move from rank to rank.
    [[nodiscard]] int history_moves() const { return together_ ? together_->history_moves() : 0; }

    /// The last report of each rank. `whole`: the report of the zone, which is that of a single rank.
    [[nodiscard]] std::vector<coupling::StepReport> reports(const coupling::StepReport& whole) const;

private:
    void put_together(const Case& input);

    std::vector<std::unique_ptr<coupling::Transport>> transports_;
    std::vector<const coupling::RemoteFineScale*> remotes_;
    std::vector<std::unique_ptr<coupling::FineScale>> scales_;
    std::unique_ptr<coupling::FineRanks> together_;  // null for a single rank
};

}  // namespace stria
