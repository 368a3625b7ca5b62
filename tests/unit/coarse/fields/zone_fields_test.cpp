#include "coarse/fields/zone_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "common/index.hpp"
#include "fine/growth/frozen_tips.hpp"
#include "tests/support/pulled_plate.hpp"

namespace stria::coarse {
namespace {

const std::vector<double>& displacement_of(const FieldData& fields) {
    return std::ranges::find(fields.point_arrays, "displacement", &FieldArray::name)->values;
}

const std::vector<double>& of_cells(const FieldData& fields, const char* name) {
    return std::ranges::find(fields.cell_arrays, name, &FieldArray::name)->values;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k) largest = std::max(largest, std::abs(a[k] - b[k]));
    return largest;
}

// Act (a) of growth: the same displacement, whether the functions of a tip are unknowns or what is frozen of them.
TEST(ZoneFields, HoldWhatOldTipsHaveFrozen) {
    const Scene scene = refined_scene(test::pulled_plate(1.0, true, true));
    const Structure structure(scene, select_zone(scene, {200.0}));
    const EnrichedMesh part = extract(scene.enriched, structure.in_zone().members());
    coupling::ZoneState free, frozen, forgotten;
    free.displacement = Eigen::VectorXd::LinSpaced(part.unknowns, -1.0, 1.0).array().sin();
    fine::FrozenTips tips;
    tips.freeze(part, 0, free.displacement);
    forgotten.displacement = free.displacement;
    for (const auto& [node, term, unknown] : part.own_unknowns())
        if (term > 0 && part.terms[at(node)][at(term - 1)].kind == Term::Kind::Tip)
            forgotten.displacement.segment<2>(unknown).setZero();
    frozen.displacement = forgotten.displacement;
    frozen.frozen_tips = tips.tips();
    const Eigen::VectorXd structure_alone = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    const auto fields = [&](const coupling::ZoneState& zone) {
        return displacement_of(make_fields(structure, structure_alone, &zone, {}));
    };
    EXPECT_LT(largest_difference(fields(free), fields(frozen)), 1e-14);
    EXPECT_GT(largest_difference(fields(free), fields(forgotten)), 1e-3);
}

// A grown tip's element may have no point on one side of the crack, which is as loaded as the other one.
TEST(ZoneFields, WhereASideHasNoPointTellTheStressBesideIt) {
    const Scene scene = refined_scene(test::pulled_plate(1.0, true, true));
    const Structure structure(scene, select_zone(scene, {200.0}));
    const EnrichedMesh part = extract(scene.enriched, structure.in_zone().members());
    const std::vector<int> piece = piece_of_elements(part);
    coupling::ZoneState zone;
    zone.displacement = Eigen::VectorXd::Zero(part.unknowns);
    for (int e = 0; e < std::ssize(part.elements); ++e) {
        zone.element.push_back(e);
        zone.side.push_back(piece[at(e)] < 0 ? 0 : 1);
        zone.weight.push_back(1.0);
        zone.stress.insert(zone.stress.end(), {70.0, 80.0, 90.0, 0.0});
        zone.plastic_strain.insert(zone.plastic_strain.end(), 4, 0.0);
        zone.accumulated.push_back(0.0);
    }
    const FieldData fields = make_fields(structure, Eigen::VectorXd::Zero(scene.enriched.unknowns), &zone, {});
    const std::vector<double>&side = of_cells(fields, "crack_side"), &stress = of_cells(fields, "stress");
    int cells = 0;
    for (std::size_t c = 0; c < side.size(); ++c)
        if (side[c] < 0.0) {
            ++cells;
            EXPECT_EQ(stress[4 * c + 1], 80.0);
        }
    EXPECT_GT(cells, 5);
}

}  // namespace
}  // namespace stria::coarse
