#include "app/run/fine_side.hpp"

#include <exception>

#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "fine/zone/fine_model.hpp"

namespace stria {

FineSide::FineSide(const Case& input, int ranks) {
    for (int k = 0; k < ranks; ++k) scales_.push_back(std::make_unique<fine::FineModel>(input));
    put_together(input);
}

// Every peer is greeted before anything is refused: nobody is left waiting.
FineSide::FineSide(const Case& input, const coupling::MpiSession& session, bool own_rank) {
    std::exception_ptr refusal;
    for (int peer = 0; peer < session.peers(); ++peer) {
        transports_.push_back(session.transport(peer));
        try {
            auto remote = std::make_unique<coupling::RemoteFineScale>(*transports_.back(), digest(input));
            remotes_.push_back(remote.get());
            scales_.push_back(std::move(remote));
        } catch (const CaseError&) {
            refusal = std::current_exception();
        }
    }
    if (refusal) std::rethrow_exception(refusal);
    if (own_rank) scales_.push_back(std::make_unique<fine::FineModel>(input));
    put_together(input);
}

void FineSide::put_together(const Case& input) {
    if (scales_.size() == 1) return;
    std::vector<coupling::FineScale*> each;
    for (const auto& scale : scales_) each.push_back(scale.get());
    together_ = std::make_unique<coupling::FineRanks>(std::move(each), remembered_increments(input.load.steps));
}

coupling::WorkCounts FineSide::traffic() const {
    coupling::WorkCounts sum;
    sum.fine_ranks = std::ssize(scales_);
    for (const coupling::RemoteFineScale* remote : remotes_) sum += remote->traffic();
    return sum;
}

std::vector<coupling::StepReport> FineSide::reports(const coupling::StepReport& whole) const {
    return together_ ? together_->reports() : std::vector<coupling::StepReport>{whole};
}

}  // namespace stria
