#include "coupling/transport/memory_transport.hpp"

#include <condition_variable>
#include <deque>
#include <mutex>

#include "common/error.hpp"

namespace stria::coupling {

/// Messages on their way in one direction.
class MessageQueue {
public:
    void push(Message message) {
        const std::lock_guard lock(mutex_);
        if (closed_) throw ComponentLost("the other component has ended");
        messages_.push_back(std::move(message));
        changed_.notify_one();
    }

    [[nodiscard]] Message pop() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return closed_ || !messages_.empty(); });
        if (messages_.empty()) throw ComponentLost("the other component has ended");
        Message message = std::move(messages_.front());
        messages_.pop_front();
        return message;
    }

    void close() {
        const std::lock_guard lock(mutex_);
        closed_ = true;
        changed_.notify_all();
    }

private:
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<Message> messages_;
    bool closed_ = false;
};

MemoryTransport::MemoryTransport(std::shared_ptr<MessageQueue> outgoing, std::shared_ptr<MessageQueue> incoming)
    : outgoing_(std::move(outgoing)), incoming_(std::move(incoming)) {}

MemoryTransport::~MemoryTransport() {
    outgoing_->close();
    incoming_->close();
}

void MemoryTransport::send(Tag tag, std::vector<std::byte> bytes) { outgoing_->push({tag, std::move(bytes)}); }

Message MemoryTransport::receive() { return incoming_->pop(); }

std::pair<std::unique_ptr<Transport>, std::unique_ptr<Transport>> make_memory_transports() {
    const auto forth = std::make_shared<MessageQueue>();
    const auto back = std::make_shared<MessageQueue>();
    return {std::make_unique<MemoryTransport>(forth, back), std::make_unique<MemoryTransport>(back, forth)};
}

}  // namespace stria::coupling
