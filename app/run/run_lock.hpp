// One run at a time in a folder of results.
#pragma once

#include <chrono>
#include <filesystem>

namespace stria {

/// Holds the folder until it is destroyed or the process ends, however that may be.
class RunLock {
public:
    /// Throws CaseError where another run holds the folder. A file system that knows no locks lets everybody in.
    explicit RunLock(const std::filesystem::path& folder);
    RunLock(const RunLock&) = delete;
    RunLock& operator=(const RunLock&) = delete;
    ~RunLock();

private:
    int descriptor_;
};

/// Until no run holds the folder, or so much time has passed.
void wait_until_free(const std::filesystem::path& folder, std::chrono::milliseconds longest);

}  // namespace stria
