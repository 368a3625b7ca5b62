#include "coarse/results/case_mark.hpp"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <fmt/format.h>
#include <sstream>

#include "common/case/schema/case_file.hpp"
#include "common/error.hpp"
#include "common/index.hpp"
#include "common/io/checksum.hpp"

namespace stria::coarse {
namespace {

/// What a run may change when it goes on is left out.
Case essence(Case input) {
    input.name.clear();
    input.title.clear();
    input.solver = {};
    input.coupling = {};
    input.output = {.format = input.output.format};  // a series of fields has one
    input.material_test.reset();
    input.load.blocks.clear();
    input.load.spectrum.reset();
    input.load.scale = 1.0;
    input.load.repeat = 1;
    // The mesh itself is compared: its file may lie elsewhere now.
    if (input.mesh.file) input.mesh.file = std::filesystem::path(*input.mesh.file).filename().string();
    return input;
}

std::uint64_t digest_of(const Mesh& mesh) {
    Checksum sum;
    for (const Vec2& node : mesh.nodes)
        for (const double coordinate : node) sum.add(std::bit_cast<std::uint64_t>(coordinate));
    sum.add(mesh.elements.size());
    for (const auto& nodes : mesh.elements)
        for (const int node : nodes) sum.add(static_cast<std::uint64_t>(node));
    for (const int material : mesh.material) sum.add(static_cast<std::uint64_t>(material));
    for (const auto& [name, edges] : mesh.boundary) {
        sum.add(name);
        for (const auto& [element, edge] : edges) sum.add(4 * static_cast<std::uint64_t>(element) + at(edge));
    }
    return sum.value();
}

[[noreturn]] void refuse(const std::string& difference) {
    throw CaseError(
        fmt::format("--resume: {}; a run goes on with the same case: only [solver], [coupling], [output] but for "
                    "its format, title and name may change, and the load history where the load has not been yet",
                    difference));
}

void compare_texts(const std::string& then, const std::string& now) {
    std::istringstream before(then), after(now);
    std::string section, old_line, new_line;
    while (true) {
        const bool more_before = static_cast<bool>(std::getline(before, old_line));
        const bool more_after = static_cast<bool>(std::getline(after, new_line));
        if (!more_before && !more_after) return;
        if (!more_before) old_line.clear();
        if (!more_after) new_line.clear();
        if (old_line != new_line)
            refuse(fmt::format("{}\"{}\" in the case was \"{}\" where the checkpoint was written", section, new_line,
                               old_line));
        if (old_line.starts_with('[')) section = old_line + " ";
    }
}

LoadSection load_of(const CaseMark& mark) {
    LoadSection load;
    load.blocks = mark.blocks;
    load.scale = mark.scale;
    load.repeat = mark.repeat;
    return load;
}

[[noreturn]] void refuse_history(int cycle, const std::string& why = "") {
    refuse(fmt::format("the load history is another one in cycle {}, which had begun when the checkpoint was written{}",
                       cycle, why));
}

/// Where the cycle that comes next has another maximum: of a run that is made longer the one behind its end.
std::string of_next_maximum(const Leg& then, const Leg& now) {
    if (!then.ends_cycle || !now.ends_cycle || then.from != now.from || then.to == now.to) return "";
    return fmt::format(": a cycle ends at the maximum of the next one, the last at its own, and it ended at {:g}, not "
                       "{:g}; a cycle to {:g} between them leaves it as it was",
                       then.to, now.to, then.to);
}

/// Up to and with the leg that the load is on.
void compare_histories(const CaseMark& then, const CaseMark& now, std::size_t leg) {
    const std::vector<Leg> before = legs(load_of(then)), after = legs(load_of(now));
    for (std::size_t k = 0; k < std::min(leg + 1, before.size()); ++k) {
        if (k >= after.size()) refuse_history(before[k].cycle);
        const bool same = after[k].cycle == before[k].cycle && after[k].from == before[k].from &&
                          after[k].to == before[k].to && after[k].ends_cycle == before[k].ends_cycle;
        if (!same) refuse_history(before[k].cycle, of_next_maximum(before[k], after[k]));
    }
}

}  // namespace

int cycles_of(const CaseMark& mark) { return cycle_count(load_of(mark)); }

CaseMark mark_of(const Scene& scene) {
    const LoadSection& load = scene.input.load;
    return {resolved_toml(essence(scene.input)),
            load.blocks,
            load.scale,
            load.repeat,
            CaseHistories(scene.input).legs_before_history(),
            digest_of(scene.mesh)};
}

void check_same_case(const CaseMark& then, const CaseMark& now, const LoadPosition& reached) {
    compare_texts(then.text, now.text);
    // A first displacement of zero has a leg of its own. While dead loads come on it may yet become another one.
    const std::size_t of_dead_loads = std::min(then.legs_before, now.legs_before);
    if (reached.leg >= of_dead_loads && then.legs_before != now.legs_before) refuse_history(0);
    if (reached.leg >= then.legs_before) compare_histories(then, now, reached.leg - then.legs_before);
    if (then.mesh != now.mesh)
        refuse("the mesh is another one than where the checkpoint was written (it is refined along the way that the "
               "cracks will take)");
}

}  // namespace stria::coarse
