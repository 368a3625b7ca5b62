#include "coupling/transport/mpi_transport.hpp"

#include <mpi.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>

#include <fmt/format.h>

#include "common/error.hpp"
#include "common/index.hpp"
#include "coupling/transport/protocol.hpp"

namespace stria::coupling {

namespace {

void check(int code) {
    if (code == MPI_SUCCESS) return;
    std::array<char, MPI_MAX_ERROR_STRING> text{};
    int length = 0;
    MPI_Error_string(code, text.data(), &length);
    throw ComponentLost(fmt::format("MPI: {}", text.data()));
}

using std::chrono::microseconds;

/// Waits until `there()`: at first by asking again and again, then asleep, until the peer rings. Then it may be there
/// in some tens of microseconds. Where no bell reaches, it sleeps for a tenth of what it has waited: the core is
/// somebody else's, and the answer hardly later.
class Patience {
public:
    Patience(const Doorbell& bell, int peer) : bell_(bell), by_bell_(bell.reaches(peer)) {}

    /// Until `there()`, anybody has rung, or a moment has passed.
    template <class There> void wait_a_moment(There there) const {
        using namespace std::chrono;
        for (const auto start = steady_clock::now(); steady_clock::now() < start + for_answer;)
            if (there()) return;
        const std::uint32_t rung = bell_.rung();
        if (!there()) bell_.sleep(rung, longest_sleep(by_bell_ ? milliseconds(5) : milliseconds(0)));
    }

    /// `leaves()`: the peer may be taking something large, perhaps in parts, each of which needs both sides awake.
    template <class There, class Leaves> void wait_until(There there, Leaves leaves) const {
        using namespace std::chrono;
        const auto start = steady_clock::now();
        auto awake_since = start;
        bool takes = !by_bell_;
        for (;;) {
            const std::uint32_t rung = bell_.rung();
            if (there()) return;
            const auto now = steady_clock::now();
            if (now < awake_since + (takes && leaves() ? for_transfer : for_answer)) continue;
            bell_.sleep(rung, longest_sleep(duration_cast<microseconds>(now - start)));
            if (bell_.rung() == rung) continue;
            awake_since = steady_clock::now();
            takes = true;
        }
    }

private:
    static constexpr microseconds for_answer{30}, for_transfer{3000};

    // What nobody rings for is asked for again after a while.
    [[nodiscard]] microseconds longest_sleep(microseconds waited) const {
        return std::clamp(waited / 10, microseconds(50), microseconds(500)) * (by_bell_ ? 20 : 1);
    }

    const Doorbell& bell_;
    bool by_bell_;
};

/// A header, then the bytes it announces. A message leaves when the peer takes it, and nobody waits for that but who
/// sends the next one: a peer that has to be woken first would keep the others from being asked. Destroying an end says
/// goodbye and waits for the other's goodbye, so that no message is left behind when MPI ends, and the other end, if it
/// still waits for a message, gets ComponentLost.
class MpiTransport final : public Transport {
public:
    MpiTransport(int peer, const Doorbell& bell) : peer_(peer), bell_(bell), patience_(bell, peer) {}

    ~MpiTransport() override {
        const auto try_to = [](auto what) {
            try {
                what();
            } catch (...) {  // nobody left to say goodbye to
            }
        };
        try_to([&] { begin_sending(goodbye, {}); });
        try_to([&] {
            while (peer_present_) receive();
        });
        try_to([&] { finish_sending(); });
    }

    void send(Tag tag, std::vector<std::byte> bytes) override {
        if (!peer_present_) throw_ended();
        begin_sending(static_cast<std::uint64_t>(tag), std::move(bytes));
    }

    Message receive() override {
        if (!peer_present_) throw_ended();
        const Header header = receive_header();
        if (header.tag == goodbye) {
            peer_present_ = false;
            throw_ended();
        }
        Message message{static_cast<Tag>(header.tag), std::vector<std::byte>(header.size)};
        for (std::span<std::byte> rest = message.bytes; !rest.empty(); rest = rest.subspan(chunk(rest.size())))
            receive_exactly(rest.first(chunk(rest.size())), payload);
        return message;
    }

    [[nodiscard]] bool has_message() override { return !peer_present_ || has_arrived(announcement); }

    void wait_a_moment() override {
        patience_.wait_a_moment([this] { return has_message(); });
    }

private:
    struct Header {
        std::uint64_t tag;
        std::uint64_t size;
    };

    static constexpr int announcement = 1, payload = 2;  // MPI tags
    static constexpr std::uint64_t goodbye = 0;          // no Tag has this number

    /// MPI counts in int: longer messages go in pieces.
    static std::size_t chunk(std::size_t size) { return std::min(size, std::size_t{1} << 30); }

    [[noreturn]] static void throw_ended() { throw ComponentLost("the other component has ended"); }

    void begin_sending(std::uint64_t tag, std::vector<std::byte> bytes) {
        finish_sending();
        bytes_ = std::move(bytes);
        header_ = {.tag = tag, .size = bytes_.size()};
        begin_piece(std::as_bytes(std::span(&header_, 1)), announcement);
        for (std::span<const std::byte> rest = bytes_; !rest.empty(); rest = rest.subspan(chunk(rest.size())))
            begin_piece(rest.first(chunk(rest.size())), payload);
        bell_.ring(peer_);
    }

    void begin_piece(std::span<const std::byte> bytes, int mpi_tag) {
        check(MPI_Isend(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, peer_, mpi_tag, MPI_COMM_WORLD,
                        &leaving_.emplace_back()));
    }

    void finish_sending() {
        patience_.wait_until([&] { return has_left(); }, [] { return true; });
    }

    /// All of the message before.
    bool has_left() {
        int all = 0;
        check(MPI_Testall(static_cast<int>(leaving_.size()), leaving_.data(), &all, MPI_STATUSES_IGNORE));
        if (all != 0) leaving_.clear();
        return all != 0;
    }

    [[nodiscard]] Header receive_header() {
        Header header{};
        receive_exactly(std::as_writable_bytes(std::span(&header, 1)), announcement);
        return header;
    }

    [[nodiscard]] bool has_arrived(int mpi_tag, MPI_Status* status = MPI_STATUS_IGNORE) const {
        int arrived = 0;
        check(MPI_Iprobe(peer_, mpi_tag, MPI_COMM_WORLD, &arrived, status));
        return arrived != 0;
    }

    void receive_exactly(std::span<std::byte> bytes, int mpi_tag) {
        MPI_Status status{};
        int received = 0;
        patience_.wait_until([&] { return has_arrived(mpi_tag, &status); }, [&] { return !has_left(); });
        check(MPI_Get_count(&status, MPI_BYTE, &received));
        if (at(received) != bytes.size())
            throw ComponentLost("a message between the components is not as long as announced");
        if (mpi_tag == payload) bell_.ring(peer_);  // it leaves when we take it
        check(MPI_Recv(bytes.data(), received, MPI_BYTE, peer_, mpi_tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE));
    }

    int peer_;
    const Doorbell& bell_;
    Patience patience_;
    bool peer_present_ = true;
    Header header_{};  // of the last message
    std::vector<std::byte> bytes_;
    std::vector<MPI_Request> leaving_;  // its pieces
};

/// What each rank says of itself at first.
struct Card {
    std::uint64_t role;
    std::uint64_t case_digest;
};

std::vector<Card> gather_cards(Role role, std::uint64_t case_digest) {
    int size = 0;
    check(MPI_Comm_size(MPI_COMM_WORLD, &size));
    const Card mine{static_cast<std::uint64_t>(role), case_digest};
    std::vector<Card> cards(at(size));
    constexpr int numbers = sizeof(Card) / sizeof(std::uint64_t);
    check(MPI_Allgather(&mine, numbers, MPI_UINT64_T, cards.data(), numbers, MPI_UINT64_T, MPI_COMM_WORLD));
    return cards;
}

/// Every rank sees the same cards, so all of them refuse or none, and the first one says why.
[[noreturn]] void refuse(const std::string& why) {
    int rank = 0;
    check(MPI_Comm_rank(MPI_COMM_WORLD, &rank));
    if (rank == 0) throw CaseError(why);
    throw ToldElsewhere(why);
}

void check_cases(const std::vector<Card>& cards) {
    if (std::ranges::any_of(cards, [&](const Card& card) { return card.case_digest != cards.front().case_digest; }))
        refuse(different_cases);
}

void check_cast(const std::vector<Role>& roles) {
    const auto coarse = std::ranges::count(roles, Role::Coarse);
    const auto fine = std::ranges::count(roles, Role::Fine);
    if (coarse == 1 && fine >= 1) return;
    refuse(fmt::format("launch: {} coarse and {} fine ranks were started; one coarse and at least one fine are needed: "
                       "mpirun -n 1 stria-coarse CASE : -n 1 stria-fine CASE",
                       coarse, fine));
}

/// To the launcher of MPI every rank has a TCP connection over which it says that it starts and ends, each time in two
/// small pieces. The second one would wait until the first is acknowledged: 0.04 s at the end of every run.
void send_small_pieces_at_once() {
    constexpr int enough = 256, on = 1;
    for (int file = 0; file < enough; ++file) setsockopt(file, IPPROTO_TCP, TCP_NODELAY, &on, sizeof on);
}

}  // namespace

MpiSession::Environment::Environment() {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    send_small_pieces_at_once();  // of what is no such connection the kernel takes no notice
    MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN);  // errors become exceptions: check()
}

MpiSession::Environment::~Environment() { MPI_Finalize(); }

bool under_mpirun() { return std::getenv("OMPI_COMM_WORLD_SIZE") != nullptr; }

MpiSession::MpiSession(Role role, std::uint64_t case_digest, Cast cast) {
    const std::vector<Card> cards = gather_cards(role, case_digest);
    check_cases(cards);
    std::vector<Role> roles;
    for (const Card& card : cards) roles.push_back(static_cast<Role>(card.role));
    if (cast == Cast::CoarseAndFine) check_cast(roles);
    for (int rank = 0; rank < static_cast<int>(roles.size()); ++rank)
        if (roles[at(rank)] != role) peers_.push_back(rank);
}

std::unique_ptr<Transport> MpiSession::transport(int peer_index) const {
    return std::make_unique<MpiTransport>(peers_.at(at(peer_index)), bell_);
}

// NOLINTNEXTLINE(readability-convert-member-functions-to-static): only who has a session may end it
void MpiSession::abort(int code) const {
    MPI_Abort(MPI_COMM_WORLD, code);
    std::_Exit(code);  // MPI_Abort is not declared to stay away
}

}  // namespace stria::coupling
