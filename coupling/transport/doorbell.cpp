#include "coupling/transport/doorbell.hpp"

#include <linux/futex.h>
#include <mpi.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <climits>
#include <ctime>
#include <numeric>

#include "common/index.hpp"

namespace stria::coupling {
namespace {

/// Of each rank of MPI_COMM_WORLD on this machine; MPI_UNDEFINED elsewhere.
std::vector<int> ranks_on(MPI_Comm machine) {
    int size = 0;
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    std::vector<int> world(at(size)), here(at(size));
    std::iota(world.begin(), world.end(), 0);
    MPI_Group all{}, some{};
    MPI_Comm_group(MPI_COMM_WORLD, &all);
    MPI_Comm_group(machine, &some);
    MPI_Group_translate_ranks(all, size, world.data(), some, here.data());
    MPI_Group_free(&all);
    MPI_Group_free(&some);
    return here;
}

std::uint32_t* count_of(MPI_Win window, int rank) {
    MPI_Aint bytes = 0;
    int unit = 0;
    void* place = nullptr;
    MPI_Win_shared_query(window, rank, &bytes, &unit, static_cast<void*>(&place));
    return static_cast<std::uint32_t*>(place);
}

}  // namespace

struct Doorbell::Shared {
    MPI_Comm machine = MPI_COMM_NULL;
    MPI_Win window = MPI_WIN_NULL;
    void* own = nullptr;

    Shared() {
        constexpr MPI_Aint cache_line = 64;
        MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &machine);
        MPI_Win_allocate_shared(cache_line, 1, MPI_INFO_NULL, machine, static_cast<void*>(&own), &window);
    }
    Shared(const Shared&) = delete;
    Shared& operator=(const Shared&) = delete;
    ~Shared() {
        if (window != MPI_WIN_NULL) MPI_Win_free(&window);
        MPI_Comm_free(&machine);
    }
};

Doorbell::Doorbell() : shared_(std::make_unique<Shared>()) {
    const std::vector<int> here = ranks_on(shared_->machine);
    counts_.assign(here.size(), nullptr);
    if (shared_->own == nullptr) return;
    own_ = static_cast<std::uint32_t*>(shared_->own);
    std::atomic_ref(*own_).store(0);
    MPI_Barrier(shared_->machine);
    for (std::size_t rank = 0; rank < here.size(); ++rank)
        if (here[rank] != MPI_UNDEFINED) counts_[rank] = count_of(shared_->window, here[rank]);
}

Doorbell::~Doorbell() = default;

bool Doorbell::reaches(int rank) const { return counts_[at(rank)] != nullptr; }

void Doorbell::ring(int rank) const {
    std::uint32_t* count = counts_[at(rank)];
    if (count == nullptr) return;
    std::atomic_ref(*count).fetch_add(1);
    syscall(SYS_futex, count, FUTEX_WAKE, INT_MAX, nullptr, nullptr, 0);
}

std::uint32_t Doorbell::rung() const { return std::atomic_ref(*own_).load(); }

void Doorbell::sleep(std::uint32_t before, std::chrono::microseconds longest) const {
    using namespace std::chrono;
    const timespec limit{.tv_sec = 0, .tv_nsec = duration_cast<nanoseconds>(longest).count()};
    syscall(SYS_futex, own_, FUTEX_WAIT, before, &limit, nullptr, 0);
}

}  // namespace stria::coupling
