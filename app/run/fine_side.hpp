// The fine components of a run, in this process or others, and what they look like to the coarse one.
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
    /// In this process. `input` must outlive this.
    FineSide(const Case& input, int ranks);

    /// One a peer of the session.
    FineSide(const Case& input, const coupling::MpiSession& session);

    /// One as it is, several as one.
    [[nodiscard]] coupling::FineScale& scale() { return together_ ? *together_ : *scales_.front(); }

    /// What has crossed between them and the coarse one, and how many there are.
    [[nodiscard]] coupling::WorkCounts traffic() const;

    /// How often history had to move from one of them to another.
    [[nodiscard]] int history_moves() const { return together_ ? together_->history_moves() : 0; }

    /// The last report of each; `whole`: that of all.
    [[nodiscard]] std::vector<coupling::StepReport> reports(const coupling::StepReport& whole) const;

private:
    void put_together(const Case& input);

    std::vector<std::unique_ptr<coupling::Transport>> transports_;
    std::vector<const coupling::RemoteFineScale*> remotes_;
    std::vector<std::unique_ptr<coupling::FineScale>> scales_;
    std::unique_ptr<coupling::FineRanks> together_;  // of several
};

}  // namespace stria
