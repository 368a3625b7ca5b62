// Signals that ask a run to end: SIGINT and SIGTERM, and SIGUSR1, which mpirun passes on to its programs.
#pragma once

namespace stria {

/// From this call on the signals are noted.
void heed_interruption();

/// True once a signal has come.
bool interrupted();

/// Since the first one, s; 0 before.
double seconds_since_interruption();

/// From this call on the signals are ignored. The fine component ends when the coarse one tells it to.
void ignore_interruption();

}  // namespace stria
