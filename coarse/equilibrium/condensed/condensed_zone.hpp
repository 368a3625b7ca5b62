// The zone as the structure meets it on Gamma: one question and one answer per iterate.
#pragma once

#include <functional>

#include "coarse/equilibrium/condensed/gamma_states.hpp"
#include "coarse/equilibrium/equilibrium_sections.hpp"
#include "coarse/structure/coarse_effort.hpp"
#include "coupling/fine_scale.hpp"

namespace stria::coarse {

class CondensedZone {
public:
    /// `fine`: null where there is no zone. Then only begin(), the questions' settings, put_aside(), the two of a
    /// commit and rollback() may be called.
    CondensedZone(coupling::FineScale* fine, CouplingSection coupling) : fine_(fine), coupling_(std::move(coupling)) {}

    [[nodiscard]] bool exists() const { return fine_ != nullptr; }

    /// An increment begins; `held`: Target::held.
    void begin(const Predictor& predictor, double held);

    // Of the next questions.
    void look_at_rest() { request_.check_rest = true; }
    void set_elastic(bool elastic) { request_.elastic = elastic; }
    void settle_below(double factor_serves, double may_be_last);
    /// Gamma has moved by this part of a new correction or, `further`, of the last one once more.
    void move(double part, bool further);
    /// The trial state is wanted again as a predictor.
    void put_aside() { put_aside_ = true; }

    /// Does `meanwhile` what needs no answer. Throws as FineScale::collect().
    void ask(const GammaState& state, const std::function<void()>& meanwhile);
    [[nodiscard]] const coupling::PatchResponse& answer() const { return answer_; }
    /// False where the first iterate has failed.
    [[nodiscard]] bool has_answered() const { return exists() && answer_.force.size() > 0; }
    [[nodiscard]] bool is_first_iterate() const { return request_.iteration == 0; }

    /// Of the last answer that brought one, on all of Gamma.
    [[nodiscard]] const CondensedTangent& tangent() const { return tangent_; }
    /// Whether it is another one than at the last call.
    [[nodiscard]] bool has_new_tangent() { return std::exchange(new_tangent_, false); }

    void begin_commit(const coupling::Commit& what);
    coupling::StepReport commit(const coupling::Commit& what);
    void rollback();

    /// Time of the exchange, and what did not cross.
    [[nodiscard]] const CoarseEffort& effort() const { return effort_; }

private:
    coupling::FineScale* fine_;
    CouplingSection coupling_;
    coupling::PatchDisplacement request_;  // the next one; its boundary is put in when it leaves
    coupling::PatchResponse answer_;
    CondensedTangent tangent_;
    bool new_tangent_ = true;
    bool put_aside_ = false;  // the zone does not know yet
    CoarseEffort effort_;
};

}  // namespace stria::coarse
