#include "app/run/run_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fmt/format.h>
#include <thread>

#include "common/error.hpp"
#include "common/io/file_failure.hpp"

namespace stria {

RunLock::RunLock(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / ".lock";  // stays: who removed it could let a third run in
    descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) throw FileFailure::of_writing(file, errno);
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
    ::close(descriptor_);
    throw CaseError(fmt::format("{}: another run is writing into this folder; wait for its end, or -o DIR writes "
                                "elsewhere",
                                folder.string()));
}

RunLock::~RunLock() { ::close(descriptor_); }

void wait_until_free(const std::filesystem::path& folder, std::chrono::milliseconds longest) {
    using namespace std::chrono;
    for (const auto end = steady_clock::now() + longest; steady_clock::now() < end;) {
        try {
            const RunLock lock(folder);
            return;
        } catch (const CaseError&) {
            std::this_thread::sleep_for(milliseconds(20));
        } catch (const FileFailure&) {
            return;  // there is no folder to wait for
        }
    }
}

}  // namespace stria
