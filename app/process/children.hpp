// Child processes: started, told of what the user asks, waited for.
#pragma once

#include <string>
#include <sys/types.h>
#include <vector>

namespace stria {

/// How a child is started.
struct ChildPlace {
    std::string log = {};         // the file of its output and errors; empty: ours, and it stands apart
    std::vector<int> cores = {};  // where it runs; empty: where we do
};

/// How one ended.
struct EndedChild {
    pid_t process = 0;
    int code = 0;      // its exit code, Interrupted where the user has ended it; 128 + the number of the signal
    bool ours = true;  // false: of the loader, of mpirun or of a signal
};

/// At most so many run at a time.
inline constexpr int most_children = 256;

/// Starts the command and passes on to it, from here on, what asks us to end. One that stands apart is out of the
/// terminal's reach and is sent SIGUSR1: mpirun passes that on to its programs, and would kill them on others. Another
/// one has the SIGINT of the terminal itself and is sent SIGTERM. All end with us. Throws std::runtime_error.
pid_t start_child(const std::vector<std::string>& command, const ChildPlace& place);

/// Sleeps until a child ends. Throws std::runtime_error where there is none.
EndedChild wait_for_child();

/// True once the user has asked us to end, since the first child was started.
bool asked_to_end();

/// The cores that this process may use, by number.
std::vector<int> own_cores();

/// What part `part` of `parts` gets of the cores: as many as each other, to one. All where there are too few.
std::vector<int> share_of(const std::vector<int>& cores, int part, int parts);

/// The word as a shell reads it back.
std::string quoted(const std::string& word);

/// The words of a command as a shell reads them back.
std::string quoted(const std::vector<std::string>& words);

}  // namespace stria
