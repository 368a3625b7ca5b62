#include "coarse/results/checkpoint.hpp"

#include <fmt/format.h>

#include "coarse/results/checkpoint_members.hpp"
#include "common/case/case_file.hpp"
#include "common/error.hpp"
#include "common/io/archive.hpp"

namespace stria::coarse {
namespace {

constexpr int format = 1;  // grows with any change of the members below

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
    hdf5::write_file(path, [&](hdf5::Group& root) {
        hdf5::Saver save(root);
        save("format", format);
        save("case", checkpoint.mark);
        save("analysis", checkpoint.analysis);
        save("recorder", checkpoint.recorder);
    });
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
    Checkpoint checkpoint;
    try {
        hdf5::Loader load(hdf5::read_file(path));
        int found = 0;
        load("format", found);
        if (found != format) throw CaseError("it is of another version of this program");
        load("case", checkpoint.mark);
        load("analysis", checkpoint.analysis);
        load("recorder", checkpoint.recorder);
    } catch (const std::exception& problem) {
        throw CaseError(fmt::format("{}: cannot go on from this checkpoint: {}", path.string(), problem.what()));
    }
    return checkpoint;
}

}  // namespace stria::coarse
