#include "app/process/interruption.hpp"

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <initializer_list>
#include <limits>
#include <unistd.h>

#include "app/process/exit_code.hpp"

namespace stria {

namespace {

volatile std::sig_atomic_t asked = 0;
timespec asked_at{};                                             // of the monotonic clock; whole once `asked` is set
double time_is_up_at = std::numeric_limits<double>::infinity();  // of the same, s

pid_t parent = 0;  // whose end matters; 0: nobody's

timespec now() {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);  // as signal handlers may
    return time;
}

double seconds(const timespec& time) {
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
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

void interrupt_after(double limit) { time_is_up_at = seconds(now()) + limit; }

bool time_is_up() { return seconds(now()) >= time_is_up_at; }

void interrupt_with_parent() { parent = getppid(); }

// Who has lost its parent gets another one.
bool interrupted() { return asked != 0 || time_is_up() || (parent != 0 && getppid() != parent); }

double seconds_since_interruption() {
    const double time = seconds(now());
    return std::max({0.0, time - time_is_up_at, asked != 0 ? time - seconds(asked_at) : 0.0});
}

void ignore_interruption() { set_action(SIG_IGN); }

}  // namespace stria
