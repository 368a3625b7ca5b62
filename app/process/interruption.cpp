#include "app/process/interruption.hpp"

#include <csignal>
#include <cstdlib>
#include <initializer_list>

#include "app/process/exit_code.hpp"

namespace stria {

namespace {

volatile std::sig_atomic_t asked = 0;

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
        asked = 1;
    });
}

bool interrupted() { return asked != 0; }

void ignore_interruption() { set_action(SIG_IGN); }

}  // namespace stria
