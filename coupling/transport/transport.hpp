// A conversation of byte messages: the only seam between in-process queues and MPI.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace stria::coupling {

enum class Tag : std::uint32_t {
    Hello = 1,
    Patch,
    Displacement,
    Response,
    Commit,
    Report,
    Rollback,
    State,
    Failure,
    Stop,
    Done,
    Snapshot,
    Restore,
    Keep,
    Kept,
    Increments
};

struct Message {
    Tag tag;
    std::vector<std::byte> bytes;
};

class Transport {
public:
    Transport() = default;
    Transport(const Transport&) = delete;
    Transport& operator=(const Transport&) = delete;
    virtual ~Transport() = default;

    /// Does not wait until the peer takes it: several may be asked before any of them listens.
    virtual void send(Tag tag, std::vector<std::byte> bytes) = 0;
    virtual Message receive() = 0;  // blocks; throws ComponentLost where the peer is gone

    /// Whether a message is there, where the transport can tell; where none is: a moment of sleep, until any peer sends
    /// something.
    [[nodiscard]] virtual bool has_message() { return true; }
    virtual void wait_a_moment() {}
};

}  // namespace stria::coupling
