// What elements add to the rings while they are elastic, in closed form, against the sums over their points.
#include "fine/bulk/bulk_report.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/plate_bulk.hpp"

namespace stria::test {
namespace {

using fine::Bulk;
using fine::EnergyDensity;

std::vector<int> all_elements(const EnrichedMesh& mesh) {
    std::vector<int> all(mesh.elements.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// From all points that the rings reach.
std::vector<DomainIntegral> by_points(RingSums sums, const Bulk& bulk, EnergyDensity density) {
    for (const int e : sums.elements()) {
        sums.enter(e);
        const std::vector<Bulk::PointState> states = bulk.committed_states(e, density);
        for (std::size_t q = 0; q < states.size(); ++q)
            sums.add(bulk.elements().op(e).points[q], states[q].stress, states[q].gradient, states[q].energy);
    }
    return {sums.values().begin(), sums.values().end()};
}

/// Elements whose points stand elsewhere.
int followers(const Bulk& bulk) {
    int count = 0;
    for (int e = 0; e < bulk.elements().count(); ++e)
        count += bulk.standing().stands_at(bulk.elements().op(e), e, bulk.committed_displacement()) ? 0 : 1;
    return count;
}

void expect_alike(const DomainIntegral& found, const DomainIntegral& expected) {
    constexpr double rounding = 1e-11;
    const double interaction = std::hypot(expected.interaction_I, expected.interaction_II, expected.interaction_T);
    EXPECT_NEAR(found.J, expected.J, rounding * std::abs(expected.J));
    EXPECT_NEAR(found.interaction_I, expected.interaction_I, rounding * interaction);
    EXPECT_NEAR(found.interaction_II, expected.interaction_II, rounding * interaction);
    EXPECT_NEAR(found.interaction_T, expected.interaction_T, rounding * interaction);
    EXPECT_NEAR(found.rotation, expected.rotation, rounding * std::abs(expected.rotation));
    EXPECT_NEAR(found.area, expected.area, rounding * expected.area);
    EXPECT_NEAR(found.turned_I, expected.turned_I, rounding * std::abs(expected.turned_I));
}

/// A plate with an edge crack.
class ElasticShares : public testing::TestWithParam<std::tuple<PlaneState, EnergyDensity>> {
protected:
    static Case case_of(PlaneState plane) {
        Case scene = plate_case({{0.0, 2.4}, {2.3, 2.6}});
        scene.model.plane = plane;
        return scene;
    }

    const Case scene = case_of(std::get<0>(GetParam()));
    const EnergyDensity density = std::get<1>(GetParam());
    const EnrichedMesh mesh = plate_mesh(9, 9, scene);
    Bulk bulk = make_bulk(mesh, scene);
};

// Metal flows, follows elastically for some increments, and flows again.
TEST_P(ElasticShares, AreThoseOfTheirPoints) {
    const Tip& tip = mesh.tips.front();
    RingSums rings(mesh, tip, bulk.elements().materials().elastic(0), {{0.8, 1.6}, {1.2, 2.4}}, all_elements(mesh));
    const Eigen::VectorXd way = random_vector(mesh.unknowns, 4e-3, 1), turn = random_vector(mesh.unknowns, 3e-4, 2);
    int followed = 0;
    fine::ElasticAnswers answers;
    for (const double load : {1.0, 0.8, 0.78, 0.76, -0.9, -0.7, -0.68, -0.66, 1.2, 1.0, 0.98}) {
        bulk.evaluate(load * way + load * load * turn);
        bulk.commit(false);
        followed += followers(bulk);
        rings.clear();
        add_to(rings, bulk, density, answers);
        const std::vector<DomainIntegral> expected =
            by_points({mesh, tip, bulk.elements().materials().elastic(0), {{0.8, 1.6}, {1.2, 2.4}}, all_elements(mesh)},
                      bulk, density);
        for (std::size_t ring = 0; ring < expected.size(); ++ring) {
            SCOPED_TRACE(testing::Message() << "ring " << ring << " at " << load);
            expect_alike(rings.values()[ring], expected[ring]);
        }
    }
    EXPECT_GT(followed, 100);
}

// What points answer does not depend on where the tip is, so what stands has been asked once.
TEST_P(ElasticShares, ServeAsATipGoesStraightOn) {
    const Eigen::VectorXd way = random_vector(mesh.unknowns, 1e-4, 1);
    for (const double load : {1.0, 0.9}) {
        bulk.evaluate(load * way);
        bulk.commit(false);
    }
    Tip tip = mesh.tips.front();
    fine::ElasticAnswers answers;
    const auto rings = [&] {
        return RingSums(mesh, tip, bulk.elements().materials().elastic(0), {{0.8, 3.6}}, all_elements(mesh));
    };
    const auto expect_what_begins = [&] {
        RingSums known = rings(), begins = rings();
        fine::ElasticAnswers none;
        add_to(known, bulk, density, answers);
        add_to(begins, bulk, density, none);
        EXPECT_GT(none.made(), 100U);
        EXPECT_EQ(known.values()[0].J, begins.values()[0].J);
        EXPECT_EQ(known.values()[0].interaction_I, begins.values()[0].interaction_I);
        EXPECT_EQ(known.values()[0].interaction_II, begins.values()[0].interaction_II);
    };
    expect_what_begins();
    const std::size_t made = answers.made();
    tip.position += 0.01 * tip.direction;
    expect_what_begins();
    EXPECT_LT(answers.made(), made + made / 10);  // a few elements more are within the ring
    bulk.evaluate(0.8 * way);
    bulk.commit(false);
    expect_what_begins();
    const std::size_t before_turn = answers.made();
    tip.direction = Vec2(0.8, 0.6);
    expect_what_begins();
    EXPECT_GT(answers.made(), before_turn + made / 2);
}

void expect_shares_of_points(const Bulk& bulk, const Tip& tip, EnergyDensity density, fine::ElasticAnswers& answers) {
    const EnrichedMesh& mesh = bulk.elements().mesh();
    const RingSums begun(mesh, tip, bulk.elements().materials().elastic(tip.material), {{0.8, 1.9}},
                         all_elements(mesh));
    RingSums rings = begun;
    add_to(rings, bulk, density, answers);
    expect_alike(rings.values()[0], by_points(begun, bulk, density)[0]);
}

// One asks for the work of stresses, and then another one for the elastic energy.
TEST(ElasticAnswers, AreOfTheDensityThatIsAskedFor) {
    const Case scene = plate_case({{0.0, 2.4}, {2.3, 2.6}});
    const EnrichedMesh mesh = plate_mesh(9, 9, scene);
    Bulk bulk = make_bulk(mesh, scene);
    const Eigen::VectorXd way = random_vector(mesh.unknowns, 4e-3, 1);
    for (const double load : {1.0, 0.8, 0.78}) {
        bulk.evaluate(load * way);
        bulk.commit(false);
    }
    EXPECT_GT(followers(bulk), 30);
    fine::ElasticAnswers answers;
    for (const EnergyDensity density : {EnergyDensity::StressWork, EnergyDensity::Elastic})
        expect_shares_of_points(bulk, mesh.tips.front(), density, answers);
}

// A body of the second metal of a case, but for an element that no ring reaches.
TEST(ElasticAnswers, AreOfTheirOwnMetal) {
    Case scene = plate_case({{0.0, 2.4}, {2.3, 2.6}});
    RegionSection stiff;
    stiff.material = scene.material;
    stiff.material.young *= 3.0;
    scene.regions = {stiff};
    EnrichedMesh mesh = plate_mesh(9, 9, scene);
    std::vector<int> material(81, 1);
    material[0] = 0;
    mesh.material = material;
    mesh.tips.front().material = 1;
    Bulk bulk = make_bulk(mesh, scene);
    const Eigen::VectorXd way = random_vector(mesh.unknowns, 1e-4, 1);
    for (const double load : {1.0, 0.9}) {
        bulk.evaluate(load * way);
        bulk.commit(false);
    }
    EXPECT_GT(followers(bulk), 50);
    fine::ElasticAnswers answers;
    expect_shares_of_points(bulk, mesh.tips.front(), EnergyDensity::StressWork, answers);
}

// A tip has moved on, and left a gradient that the functions of its neighbours no longer tell.
TEST(ElasticAnswers, HaveWhatFunctionsHaveLeftBehind) {
    const Case shorter = plate_case({{0.0, 2.5}, {2.4, 2.5}}), longer = plate_case({{0.0, 2.5}, {5.4, 2.5}});
    const EnrichedMesh before = plate_mesh(9, 9, shorter), mesh = plate_mesh(9, 9, longer);
    const Eigen::VectorXd u = random_vector(before.unknowns, 1e-4, 1);
    Bulk old = make_bulk(before, shorter);
    old.evaluate(u);
    old.commit(false);
    const Eigen::VectorXd carried = carry_over(before, u, mesh, Eigen::VectorXd::Zero(mesh.unknowns));
    Bulk bulk = make_bulk(mesh, longer, carried, &old);
    ASSERT_TRUE(bulk.history().has_frozen_gradients());
    bulk.evaluate(0.98 * carried);
    bulk.commit(false);
    for (const Vec2& about : {Vec2(2.4, 2.5), Vec2(5.4, 2.5)}) {
        Tip tip = mesh.tips.front();
        tip.position = about;
        fine::ElasticAnswers answers;
        expect_shares_of_points(bulk, tip, EnergyDensity::StressWork, answers);
    }
}

std::string name_of(const testing::TestParamInfo<ElasticShares::ParamType>& test) {
    const auto& [plane, density] = test.param;
    return std::string(plane == PlaneState::Strain ? "strain" : "stress") +
           (density == EnergyDensity::Elastic ? "Elastic" : "StressWork");
}

INSTANTIATE_TEST_SUITE_P(All, ElasticShares,
                         testing::Combine(testing::Values(PlaneState::Strain, PlaneState::Stress),
                                          testing::Values(EnergyDensity::StressWork, EnergyDensity::Elastic)),
                         name_of);

/// A plate of squares that flows.
class ForceAhead : public testing::Test {
protected:
    ForceAhead() { bulk.evaluate(random_vector(mesh.unknowns, 4e-3, 1)); }

    [[nodiscard]] double of(const Tip& moved) const { return fine::force_ahead(bulk, moved, radius); }

    static constexpr double radius = 1.2;
    const Case scene = plate_case({{0.0, 2.0}, {2.0, 2.0}});
    const EnrichedMesh mesh = plate_mesh(10, 10, scene);
    const Tip& tip = mesh.tips.front();
    Bulk bulk = make_bulk(mesh, scene);
};

// It began at the tip: up to half an element of open faces was in it, or as much of the metal ahead was not.
TEST_F(ForceAhead, BeginsWhereTheFacesEnd) {
    for (const double beyond : {-0.2, 0.13, 0.25}) {
        Tip moved = tip;
        moved.position += beyond * tip.direction;
        moved.beyond += beyond;
        EXPECT_NEAR(of(moved), of(tip), 1e-12 * std::abs(of(tip)));
    }
}

// On squares points lie on the sides of the sector.
TEST_F(ForceAhead, DoesNotHangOnTheLastDigitOfATip) {
    for (const double sign : {-1.0, 1.0}) {
        Tip moved = tip;
        moved.position += sign * 1e-13 * tip.direction;
        EXPECT_NEAR(of(moved), of(tip), 1e-12 * std::abs(of(tip)));
    }
}

}  // namespace
}  // namespace stria::test
