#include "coarse/fields/zone_fields.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "coarse/zone/refined_scene.hpp"
#include "coarse/zone/zone_selection.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "common/index.hpp"
#include "fine/growth/frozen_tips.hpp"
#include "tests/support/elastic_scene.hpp"
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

// The crack leaves an edge into the element that has its faces there: these are of both.
TEST(ZoneFields, TellTheMeanOfAllFacesOfAnElement) {
    const Mesh mesh = test::square_mesh(6);
    Scene scene = test::make_scene(mesh, test::cracked(mesh, {{0.0, 0.5}, {0.25, 0.5}, {0.45, 0.4}}, 1), test::steel);
    for (const int node : test::boundary_nodes(mesh))
        for (const int component : {0, 1})
            scene.prescribed.push_back({scene.enriched.unknown(node, 0, component), 0.0});
    const auto face = [](double s, double pressure, int status) {
        coupling::FaceSample sample{};
        sample.s = s;
        sample.pressure = pressure;
        sample.status = status;
        return sample;
    };
    const FieldData fields =
        make_fields(Structure(scene), Eigen::VectorXd::Zero(scene.enriched.unknowns), nullptr,
                    {face(0.1, 10.0, 1), face(0.2, 60.0, 2), face(0.23, 90.0, 1), face(0.27, 30.0, 1)});
    const std::vector<double>&pressure = of_cells(fields, "contact_pressure"),
          &status = of_cells(fields, "contact_status");
    EXPECT_EQ(std::ranges::count(pressure, 10.0), 1);
    EXPECT_GT(std::ranges::count(pressure, 60.0), 1);
    EXPECT_EQ(std::ranges::count(status, 2.0), std::ranges::count(pressure, 60.0));
    EXPECT_EQ(std::ranges::count(pressure, 0.0), std::ssize(pressure) - 1 - std::ranges::count(pressure, 60.0));
}

double area_of(const FieldData& fields, std::size_t cell) {
    const std::int64_t begin = fields.offsets[cell], end = fields.offsets[cell + 1];
    double twice = 0.0;
    for (std::int64_t k = begin; k < end; ++k) {
        const auto point = [&](std::int64_t of_cell) -> Vec2 {
            return fields.points[static_cast<std::size_t>(fields.connectivity[static_cast<std::size_t>(of_cell)])]
                .head<2>();
        };
        twice += cross(point(k), point(k + 1 < end ? k + 1 : begin));
    }
    return 0.5 * twice;
}

// Rounding puts a crossing of a slanted edge beside it, and left a cell without area there; ParaView warns of those.
TEST(ZoneFields, CellsHaveAnAreaAndTogetherThatOfTheBody) {
    for (int k = 0; k < 40; ++k) {
        const Mesh mesh = test::distorted(test::square_mesh(6), 0.02);
        const Vec2 tip(0.5 + 0.2 * std::sin(5.0 * k), 0.5 + 0.2 * std::cos(9.0 * k));
        const Vec2 along(std::cos(0.7 * k), std::sin(0.7 * k));
        Scene scene = test::make_scene(mesh, test::cracked(mesh, {tip - 2.0 * along, tip}, k % 2), test::steel);
        for (const int node : test::boundary_nodes(mesh))
            for (const int component : {0, 1})
                scene.prescribed.push_back({scene.enriched.unknown(node, 0, component), 0.0});
        const FieldData fields =
            make_fields(Structure(scene), Eigen::VectorXd::Zero(scene.enriched.unknowns), nullptr, {});
        double sum = 0.0, least = 1.0;
        for (std::size_t cell = 0; cell < fields.types.size(); ++cell) {
            sum += area_of(fields, cell);
            least = std::min(least, area_of(fields, cell));
        }
        EXPECT_NEAR(sum, 1.0, 1e-12) << k;
        EXPECT_GT(least, 1e-12) << k;
    }
}

}  // namespace
}  // namespace stria::coarse
