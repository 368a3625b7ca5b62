// What asks a run to end: SIGINT and SIGTERM, SIGUSR1, which mpirun passes on to its programs, a time that is up, and
// the end of who has started it.
#pragma once

namespace stria {

/// From this call on the signals are noted.
void heed_interruption();

/// So many seconds from this call on the run is asked to end as by a signal.
void interrupt_after(double seconds);

/// From this call on the run is asked to end where the process that has started it ends.
void interrupt_with_parent();

/// True once a signal has come, the time is up or the parent has ended.
bool interrupted();
bool time_is_up();

/// Since the first of them, s; 0 before.
double seconds_since_interruption();

/// From this call on the signals are ignored. The fine component ends when the coarse one tells it to.
void ignore_interruption();

}  // namespace stria
