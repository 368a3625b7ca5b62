// A hard limit on the time of a test that could wait for ever.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>

namespace stria::test {

/// Ends the whole process where it still stands after the given time.
class Deadline {
public:
    explicit Deadline(std::chrono::seconds limit)
        : watch_([this, limit] {
              std::unique_lock lock(mutex_);
              if (over_.wait_for(lock, limit, [this] { return done_; })) return;
              std::fputs("deadline passed: a conversation hangs\n", stderr);
              std::_Exit(124);
          }) {}
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

    ~Deadline() {
        {
            const std::lock_guard lock(mutex_);
            done_ = true;
        }
        over_.notify_all();
        watch_.join();
    }

private:
    std::mutex mutex_;
    std::condition_variable over_;
    bool done_ = false;
    std::thread watch_;  // last: it uses the others
};

}  // namespace stria::test
