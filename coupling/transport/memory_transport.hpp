// A conversation inside one process: two queues between two threads.
#pragma once

#include <memory>
#include <utility>

#include "coupling/transport/transport.hpp"

namespace stria::coupling {

class MessageQueue;

/// One end. Destroying it ends the conversation: the other end still reads what was sent before, then gets
/// ComponentLost.
class MemoryTransport final : public Transport {
public:
    MemoryTransport(std::shared_ptr<MessageQueue> outgoing, std::shared_ptr<MessageQueue> incoming);
    ~MemoryTransport() override;

    void send(Tag tag, std::vector<std::byte> bytes) override;
    Message receive() override;

private:
    std::shared_ptr<MessageQueue> outgoing_;
    std::shared_ptr<MessageQueue> incoming_;
};

/// The two ends of a new conversation.
[[nodiscard]] std::pair<std::unique_ptr<Transport>, std::unique_ptr<Transport>> make_memory_transports();

}  // namespace stria::coupling
