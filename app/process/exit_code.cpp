#include "app/process/exit_code.hpp"

#include "common/error.hpp"
#include "common/io/file_failure.hpp"
#include "coupling/transport/mpi_transport.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <mpi.h>
#include <new>

namespace stria {

namespace {

bool mpi_is_up() {
    int initialized = 0;
    int finalized = 0;
    MPI_Initialized(&initialized);
    MPI_Finalized(&finalized);
    return initialized != 0 && finalized == 0;
}

int leave(const std::string& program, const Ending& ending) {
    fmt::print(stderr, "{}: {}\n", program, in_one_line(ending.text));
    std::fflush(stderr);
    if (mpi_is_up()) MPI_Abort(MPI_COMM_WORLD, ending.code);
    return ending.code;
}

/// Bytes of the letter that a text begins with; 0: it is none, or none to be seen.
std::size_t letter_at_start(std::string_view text) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
    if (byte(0) < 0x80) return byte(0) >= 0x20 && byte(0) != 0x7F ? 1 : 0;
    const std::size_t size = byte(0) >= 0xF0 ? 4 : byte(0) >= 0xE0 ? 3 : 2;
    if (byte(0) < 0xC2 || byte(0) > 0xF4 || text.size() < size) return 0;
    for (std::size_t k = 1; k < size; ++k)
        if ((byte(k) & 0xC0) != 0x80) return 0;
    return byte(0) == 0xC2 && byte(1) < 0xA0 ? 0 : size;  // the other control characters
}

Ending defect(const std::string& what) {
    return {Defect, "a defect of this program, please send us the case file: " + what};
}

}  // namespace

std::string in_one_line(std::string_view text) {
    std::string line;
    while (!text.empty()) {
        const std::size_t letter = letter_at_start(text);
        line += letter > 0 ? text.substr(0, letter) : "?";
        text.remove_prefix(std::max<std::size_t>(letter, 1));
    }
    return line;
}

Ending ending_of_exception() {
    try {
        throw;
    } catch (const CaseError& error) {
        return {InputWrong, error.what()};
    } catch (const NumericalFailure& error) {
        return {NumbersFailed, error.what()};
    } catch (const ComponentLost& error) {
        return {LostComponent, error.what()};
    } catch (const FileFailure& error) {
        return {FileFailed, error.what()};
    } catch (const std::filesystem::filesystem_error& error) {
        return {FileFailed, error.what()};
    } catch (const std::bad_alloc&) {
        return {InputWrong, "the case takes more memory than there is; larger elements (mesh.size, fine.refine, "
                            "fine.subcells) take less"};
    } catch (const std::exception& error) {
        return defect(error.what());
    } catch (...) {
        return defect("an unknown exception");
    }
}

int exit_code_of(const std::string& program, const std::function<int()>& work) {
    std::signal(SIGXFSZ, SIG_IGN);  // a write beyond the limit on the size of files fails, and says so
    try {
        return work();
    } catch (const coupling::ToldElsewhere&) {
        return Done;  // mpirun ends with the code of who tells, and kills nobody before the word is out
    } catch (...) {
        return leave(program, ending_of_exception());
    }
}

}  // namespace stria
