// The conversation over MPI: mpirun -n 1 stria_mpi_conversation coarse : -n N stria_mpi_conversation fine. A fine rank
// may be one that dies in mid-conversation ("dying") instead.
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "coupling/transport/mpi_transport.hpp"
#include "tests/coupling/conversation.hpp"
#include "tests/support/deadline.hpp"

namespace stria::test {
namespace {

using coupling::MpiSession;
using coupling::Role;

void coarse_side(const MpiSession& session, int peer) {
    {
        const auto transport = session.transport(peer);
        hear_echo(*transport);
        send_many(*transport);
    }
    expect_end(*session.transport(peer));
    const auto transport = session.transport(peer);
    {
        FakeFineScale direct(0.3);
        coupling::RemoteFineScale remote(*transport, 7);
        compare(direct, remote, 40);
        expect_failure<NumericalFailure>(remote, "a spring broke");
    }
}

void fine_side(const MpiSession& session) {
    {
        const auto transport = session.transport();
        echo(*transport);
        receive_many(*transport);
        expect_end(*transport);
    }
    { const auto ended_at_once = session.transport(); }
    const auto transport = session.transport();
    FakeFineScale fine(0.3);
    fine.fails_in_rollback = 2;
    coupling::serve(*transport, fine, 7);
}

void dying_fine_side(const MpiSession& session) {
    (void)session.transport().release()->receive();  // no goodbye either
    std::_Exit(3);
}

int run(std::string_view role) {
    const Deadline deadline(std::chrono::seconds(40));
    const MpiSession session(role == "coarse" ? Role::Coarse : Role::Fine);
    try {
        for (int peer = 0; role == "coarse" && peer < session.peers(); ++peer) coarse_side(session, peer);
        if (role == "fine") fine_side(session);
        if (role == "dying") dying_fine_side(session);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", role.data(), error.what());
        session.abort(1);
    }
    return 0;
}

}  // namespace
}  // namespace stria::test

int main(int argc, char** argv) {
    try {
        return stria::test::run(argc > 1 ? argv[1] : "coarse");
    } catch (const stria::CaseError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
