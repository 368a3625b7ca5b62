#include "app/process/interruption.hpp"

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <initializer_list>

#include "app/process/exit_code.hpp"

namespace stria {

namespace {

volatile std::sig_atomic_t asked = 0;
timespec asked_at{};  // of the monotonic clock; whole once `asked` is set

timespec now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);  // as signal handlers may
    return time;
}

void set_action(void (*handler)(int)) {
    struct sigaction action {};
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;  // whoever reads or writes meanwhile goes on
    for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) sigaction(signal, &action, nullptr);
}

}  // namespace

void heed_interruption() {
    set_action([](int signal) {
        if (signal == SIGINT && asked != 0) std::_Exit(Interrupted);  // who asks twice does not want to wait
        if (asked == 0) asked_at = now();
        asked = 1;
    });
}

bool interrupted() { return asked != 0; }

double seconds_since_interruption() {
    if (!interrupted()) return 0.0;
    const timespec time = now();
    return static_cast<double>(time.tv_sec - asked_at.tv_sec) +
           1e-9 * static_cast<double>(time.tv_nsec - asked_at.tv_nsec);
}

void ignore_interruption() { set_action(SIG_IGN); }

}  // namespace stria
