// Signals that ask a run to end: SIGINT and SIGTERM, and SIGUSR1, which mpirun passes on to its programs.
#pragma once

namespace stria {

/// They are noted from here on.
void heed_interruption();

/// One has come.
bool interrupted();

/// They are left to somebody else from here on: the fine component ends when the coarse one tells it to.
void ignore_interruption();

}  // namespace stria
