// The fine component seen through a transport: each call is a question, and its answer or its failure comes back.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "coupling/fine_scale.hpp"
#include "coupling/transport/transport.hpp"

namespace stria::coupling {

/// Strictly question and answer, one question in flight. Failures on the other side arrive as the exception they were
/// there; a lost partner or a broken message is ComponentLost.
class RemoteFineScale final : public FineScale {
public:
    /// Shakes hands: throws ComponentLost where the protocols differ, CaseError where the two sides read different
    /// cases.
    RemoteFineScale(Transport& transport, std::uint64_t case_digest);

    /// Ends the conversation, so that serve() on the other side returns.
    ~RemoteFineScale() override;

    void set_patch(const Patch& patch) override;
    void begin_set_patch(const Patch& patch) override;
    [[nodiscard]] Eigen::MatrixXd increments() override;
    void request(const PatchDisplacement& displacement) override;
    PatchResponse collect() override;
    [[nodiscard]] bool has_answered() override { return !in_flight_ || transport_.has_message(); }
    void wait_a_moment() override { transport_.wait_a_moment(); }
    void begin_commit(const Commit& what) override;
    StepReport commit(const Commit& what) override;
    void rollback() override;
    ZoneState state() override;
    ZoneSnapshot snapshot() override;
    void keep() override;
    ZoneSnapshot kept() override;
    void restore(const Patch& patch, const ZoneSnapshot& snapshot) override;
    void begin_restore(const Patch& patch, const ZoneSnapshot& snapshot) override;

    /// What has crossed, both ways, and what had not to.
    [[nodiscard]] const WorkCounts& traffic() const { return traffic_; }

private:
    void send(Tag tag, std::vector<std::byte> bytes);
    void hear_what_is_left();
    Message receive();
    Message answer(Tag expected);
    void begin(Tag question, std::vector<std::byte> bytes);
    Message ask(Tag question, std::vector<std::byte> bytes, Tag expected);

    Transport& transport_;
    WorkCounts traffic_;
    std::int64_t bytes_with_tangent_ = 0;  // of the last answer that brought one
    bool in_flight_ = false;
    std::optional<Tag> begun_;  // the question in flight, where nobody waits for its answer yet
};

}  // namespace stria::coupling
