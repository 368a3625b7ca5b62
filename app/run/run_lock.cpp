#include "app/run/run_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <fmt/format.h>

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

}  // namespace stria
