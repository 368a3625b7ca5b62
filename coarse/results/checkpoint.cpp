#include "coarse/results/checkpoint.hpp"

#include <fmt/format.h>

#include "coarse/results/checkpoint_members.hpp"
#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "common/io/archive.hpp"
#include "common/io/sealed_file.hpp"

namespace stria::coarse {
namespace {

constexpr int format = 63;  // grows with any change of the members below

}  // namespace

void forget_former_end(Checkpoint& checkpoint, const CaseMark& now, const OutputSection& output) {
    if (cycles_of(checkpoint.mark) == cycles_of(now)) return;
    if (output.faces == Written::Extremes) checkpoint.recorder.face_rows = 0;
    if (output.fields == Written::Extremes) checkpoint.recorder.fields.clear();
}

bool checkpoint_is_due(const OrAuto<int>& every, const LoadStep& step, const CheckpointEffort& so_far) {
    constexpr int usual = 10;  // cycles
    constexpr double share = 0.05;
    const int cycles = every.is_auto() ? usual : every.value();
    if (cycles == 0) return false;
    if (!so_far.has_one && step.reversal) return true;  // what fails in the first cycle is not lost
    const bool is_cheap = !every.is_auto() || so_far.seconds < share * so_far.of_the_run_s;
    return step.ends_cycle && step.cycle % cycles == 0 && is_cheap;
}

void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint) {
    const std::string image = hdf5::image_of([&](hdf5::Group& root) {
        hdf5::Saver save(root);
        save("format", format);
        save("case", checkpoint.mark);
        save("analysis", checkpoint.analysis);
        save("recorder", checkpoint.recorder);
        save("warnings", checkpoint.warnings);
    });
    write_sealed(path, image, previous_checkpoint(path));
}

Checkpoint read_checkpoint(const std::filesystem::path& path) {
    Checkpoint checkpoint;
    try {
        check_seal(path);
        hdf5::Loader load(hdf5::read_file(path));
        int found = 0;
        load("format", found);
        if (found != format) throw CaseError("it is of another version of this program");
        load("case", checkpoint.mark);
        load("analysis", checkpoint.analysis);
        load("recorder", checkpoint.recorder);
        load("warnings", checkpoint.warnings);
    } catch (const std::exception& problem) {
        throw CaseError(fmt::format("{}: cannot go on from this checkpoint: {}", path.string(), problem.what()));
    }
    return checkpoint;
}

}  // namespace stria::coarse
