// The conversation between two programs under one mpirun (MPMD). The only door to MPI besides its doorbell
// and the programs' launcher.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "common/error.hpp"
#include "coupling/transport/doorbell.hpp"
#include "coupling/transport/transport.hpp"

namespace stria::coupling {

/// What a program is: it knows this by itself, never from the order on the command line.
enum class Role : int { Coarse = 0, Fine = 1 };

/// Whether the case needs fine ranks; where it does not, whoever was started meets and parts.
enum class Cast { CoarseAndFine, Any };

/// The user's input is wrong, and another process of the run says so: this one ends without a word.
class ToldElsewhere : public CaseError {
public:
    using CaseError::CaseError;
};

/// mpirun has started this program, and expects it to start MPI.
bool under_mpirun();

/// MPI from its start to its end, and who is who in it. Make one, first thing in main; transports must die before it.
class MpiSession {
public:
    /// Starts MPI and agrees with all other ranks on the case and on the cast: one coarse and some fine. Otherwise
    /// every rank gets a CaseError that says what was started and what should have been, with MPI already ended; all
    /// but the first one a ToldElsewhere. The case comes first: ranks of different ones may not want the same cast.
    MpiSession(Role role, std::uint64_t case_digest, Cast cast = Cast::CoarseAndFine);

    [[nodiscard]] int peers() const { return static_cast<int>(peers_.size()); }

    /// The conversation with the peer of the given index: ranks of the other role, in ascending order.
    [[nodiscard]] std::unique_ptr<Transport> transport(int peer_index = 0) const;

    /// Ends every rank at once: nobody is left waiting for this one.
    [[noreturn]] void abort(int code) const;

private:
    struct Environment {
        Environment();
        Environment(const Environment&) = delete;
        Environment& operator=(const Environment&) = delete;
        ~Environment();
    };

    Environment environment_;
    Doorbell bell_;
    std::vector<int> peers_;  // ranks in MPI_COMM_WORLD
};

}  // namespace stria::coupling
