// The conversation over MPI: mpirun -n 1 stria_mpi_conversation coarse : -n N stria_mpi_conversation fine. A fine rank
// may be one that dies in mid-conversation ("dying") instead, or one that is late for a side that waits ("late",
// "waiting").
#include <cstdio>
#include <cstdlib>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <string_view>
#include <sys/resource.h>
#include <sys/socket.h>
#include <thread>

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
        speak_first(*transport);
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
        speak_first(*transport);
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

constexpr auto delay = std::chrono::seconds(1);

void late_fine_side(const MpiSession& session) {
    std::this_thread::sleep_for(delay);
    session.transport()->send(coupling::Tag::Stop, std::vector<std::byte>(1 << 21));
}

/// Who waits sleeps until the other one rings: it wakes a hundred times a second at most, and is there at once.
void waiting_coarse_side(const MpiSession& session) {
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    const auto transport = session.transport();
    const std::size_t size = transport->receive().bytes.size();
    getrusage(RUSAGE_SELF, &after);
    const long woken = after.ru_nvcsw - before.ru_nvcsw;
    std::printf("woken %ld times\n", woken);
    if (size != 1 << 21 || woken > 400) throw std::runtime_error("it has not slept");
}

/// What MPI tells its launcher does not wait for what it has told before: that costs 0.04 s at the end of every run.
void expect_that_small_pieces_leave_at_once() {
    for (int file = 0; file < 256; ++file) {
        int at_once = 0;
        socklen_t size = sizeof at_once;
        if (getsockopt(file, IPPROTO_TCP, TCP_NODELAY, &at_once, &size) == 0 && at_once == 0)
            throw std::runtime_error("a connection to the launcher holds small pieces back");
    }
}

int run(std::string_view role) {
    const Deadline deadline(std::chrono::seconds(40));
    const MpiSession session(role == "coarse" || role == "waiting" ? Role::Coarse : Role::Fine, 7);
    try {
        expect_that_small_pieces_leave_at_once();
        for (int peer = 0; role == "coarse" && peer < session.peers(); ++peer) coarse_side(session, peer);
        if (role == "fine") fine_side(session);
        if (role == "dying") dying_fine_side(session);
        if (role == "waiting") waiting_coarse_side(session);
        if (role == "late") late_fine_side(session);
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
