// Lets a rank sleep until another rank of the same machine has sent it something: MPI itself can only be asked again
// and again. A count per rank in memory that they share, and the kernel to wait on it (futex).
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <vector>

namespace stria::coupling {

class Doorbell {
public:
    /// All ranks of MPI_COMM_WORLD together.
    Doorbell();
    Doorbell(const Doorbell&) = delete;
    Doorbell& operator=(const Doorbell&) = delete;
    /// All ranks together, before MPI ends.
    ~Doorbell();

    /// False for a rank on another machine: nobody hears it.
    [[nodiscard]] bool reaches(int rank) const;
    void ring(int rank) const;

    /// How often the own bell has been rung.
    [[nodiscard]] std::uint32_t rung() const;
    /// Until it has been rung more often than `before`, or this long.
    void sleep(std::uint32_t before, std::chrono::microseconds longest) const;

private:
    struct Shared;
    std::unique_ptr<Shared> shared_;      // memory of the ranks on this machine
    std::uint32_t own_alone_ = 0;         // where nothing can be shared
    std::uint32_t* own_ = &own_alone_;    // the own count
    std::vector<std::uint32_t*> counts_;  // per rank of MPI_COMM_WORLD; null: on another machine
};

}  // namespace stria::coupling
