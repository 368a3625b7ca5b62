#include "coupling/ranks/divided_patch.hpp"

#include <algorithm>
#include <compare>
#include <utility>

#include "common/enrichment/part_of_mesh.hpp"
#include "common/index.hpp"
#include "common/integration/element_operator.hpp"

namespace stria::coupling {
namespace {

std::map<int, std::vector<int>> elements_of_ranks(const EnrichedMesh& zone, const std::map<int, int>& owner) {
    std::map<int, std::vector<int>> elements;
    for (int e = 0; e < std::ssize(zone.elements); ++e) elements[owner.at(zone.element_ids[at(e)])].push_back(e);
    return elements;
}

std::vector<int> of_elements(const std::vector<int>& part_of, const std::vector<int>& elements) {
    std::vector<int> own;
    for (const int e : elements)
        if (!part_of.empty()) own.push_back(part_of[at(e)]);
    return own;
}

Eigen::MatrixXd rows_of(const Eigen::MatrixXd& case_loads, const std::vector<int>& unknowns) {
    if (case_loads.cols() == 0) return {};
    return case_loads(unknowns, Eigen::all);
}

Seams find_seams(const Patch& patch, const std::vector<RankPart>& parts) {
    std::vector<int> seen(at(patch.mesh.unknowns), 0);
    for (const RankPart& part : parts)
        for (const int unknown : part.unknowns) ++seen[at(unknown)];
    for (const int unknown : patch.boundary) seen[at(unknown)] = 2;
    Seams seams;
    for (int unknown = 0; unknown < patch.mesh.unknowns; ++unknown) {
        if (seen[at(unknown)] < 2) continue;
        const bool on_gamma = std::ranges::binary_search(patch.boundary, unknown);
        (on_gamma ? seams.gamma : seams.between).push_back(static_cast<int>(seams.kept.size()));
        seams.kept.push_back(unknown);
    }
    return seams;
}

/// Gives a part's patch its boundary, and the kept unknowns their places: seams first, as they are eliminated.
void end_at_seams(const Seams& seams, RankPart& part, Patch& patch) {
    struct Shared {
        bool on_gamma;
        int place, own;
        auto operator<=>(const Shared&) const = default;
    };
    std::vector<Shared> shared;
    for (int i = 0; i < patch.mesh.unknowns; ++i) {
        const auto found = std::ranges::lower_bound(seams.kept, part.unknowns[at(i)]);
        if (found == seams.kept.end() || *found != part.unknowns[at(i)]) continue;
        const int place = static_cast<int>(found - seams.kept.begin());
        shared.push_back({std::ranges::binary_search(seams.gamma, place), place, i});
        patch.unit_load[i] = 0.0;
        if (patch.case_loads.cols() > 0) patch.case_loads.row(i).setZero();
    }
    std::ranges::sort(shared);
    for (const Shared& s : shared) {
        patch.boundary.push_back(s.own);
        part.shared.push_back(s.place);
    }
}

}  // namespace

// All rings for everybody: pressure on faces counts also where q is one, inside of them.
DividedPatch divide(const Patch& patch, const std::map<int, int>& owner, const Eigen::VectorXd& displacement,
                    const std::vector<RankPart>& before) {
    DividedPatch divided;
    for (auto& [rank, elements] : elements_of_ranks(patch.mesh, owner)) {
        Patch& part = divided.patches.emplace_back();
        part.mesh = extract(patch.mesh, elements);
        std::vector<int> unknowns = whole_unknowns(patch.mesh, part.mesh);
        part.unit_load = gather(patch.unit_load, unknowns);
        part.case_loads = rows_of(patch.case_loads, unknowns);
        part.displacement = gather(displacement, unknowns);
        part.rings = patch.rings;
        part.opening_at = patch.opening_at;
        part.contact_at = patch.contact_at;
        part.ahead = patch.ahead;
        part.slip_at = patch.slip_at;
        part.anew = std::ranges::find(before, rank, &RankPart::rank) == before.end();
        part.shared = true;
        part.part_of = of_elements(patch.part_of, elements);
        divided.parts.push_back({rank, elements, std::move(unknowns), {}});
    }
    divided.seams = find_seams(patch, divided.parts);
    for (std::size_t k = 0; k < divided.parts.size(); ++k)
        end_at_seams(divided.seams, divided.parts[k], divided.patches[k]);
    return divided;
}

}  // namespace stria::coupling
