// Where the sources and the programs of this build are. Compiled apart, so that no other test depends on the path.
#pragma once

namespace stria::test {

extern const char* const source_folder;
extern const char* const program_folder;

}  // namespace stria::test
