// What keeping the functions of old tips as unknowns (growth.retain) buys and costs.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

#include "coarse/zone/refined_scene.hpp"
#include "tests/support/condition_number.hpp"
#include "tests/support/sent_analysis.hpp"
#include "tests/support/specimens.hpp"

namespace stria::test {
namespace {

constexpr double growth_step = 0.031;  // of the width

// Nothing flows, but it might: a body of which nothing may forgets the functions of old tips anyway.
Case growing_edge_crack(Retain retain, double step = growth_step) {
    Case input = edge_crack(0.3, 3.0, End::Pulled);
    input.material.yield_stress = 1e6;
    input.fine.enrichment = Enrichment::Topological;
    input.mesh.size = 1.0 / 21.0;
    input.fine.refine = 8;
    input.load = {.steps = 2, .blocks = {{.cycles = 3, .max = 100.0, .min = 10.0}}};
    input.growth.emplace().increment = step;
    input.growth->retain = retain;
    return input;
}

int notes_of_frozen(const RunHistory& run) {
    return static_cast<int>(std::ranges::count_if(
        run.notes, [](const std::string& note) { return note.find("functions are frozen") != std::string::npos; }));
}

/// What a linear body releases over the sum of K^2 / E' da.
double released_by(Retain retain) {
    const RunHistory run = run_direct(growing_edge_crack(retain));
    EXPECT_EQ(notes_of_frozen(run), 0);
    double irwin = 0.0;
    for (std::size_t i = 1; i < run.increments.size(); ++i) {
        const coarse::TipResult &from = run.increments[i - 1].tips[0], &to = run.increments[i].tips[0];
        irwin += 0.5 * (from.K_I * from.K_I + to.K_I * to.K_I) / plane_modulus * (to.a - from.a);
    }
    return run.increments.back().work.released / irwin;
}

TEST(RetainedFunctions, LetALinearBodyReleaseAll) {
    const double frozen = released_by(Retain::Frozen), retained = released_by(Retain::All);
    std::cout << fmt::format("released over K^2/E' da: frozen {:.4f}, retained {:.4f}\n", frozen, retained);
    EXPECT_NEAR(retained, 1.0, 0.01);
    EXPECT_LT(frozen, retained);
}

// A tip that hardly moves, beside a faster one say, leaves functions that are next to the new ones: they are frozen,
// and the log says so once. The crack grows three times.
TEST(RetainedFunctions, OfATipThatHardlyMovesAreFrozen) {
    constexpr double of_element = 1e-4 / (21.0 * 8.0);
    const RunHistory run = run_direct(growing_edge_crack(Retain::All, of_element)),
                     frozen = run_direct(growing_edge_crack(Retain::Frozen, of_element));
    ASSERT_EQ(run.increments.size(), frozen.increments.size());
    EXPECT_EQ(run.increments.back().displacement.size(), frozen.increments.back().displacement.size());
    EXPECT_EQ(notes_of_frozen(run), 1);
    EXPECT_EQ(notes_of_frozen(frozen), 0);
    EXPECT_NEAR(run.increments.back().tips[0].K_I / frozen.increments.back().tips[0].K_I, 1.0, 1e-9);
}

/// Largest condition number of an edge crack that has gone on by some elements in such steps, parts of an element.
double condition_after(Enrichment enrichment, double step) {
    constexpr double element = 1.0 / 31.0, way = 3.0;  // of the width; elements
    Case input = edge_crack(0.3, 3.0, End::Pulled);
    input.mesh.size = element;
    input.fine.enrichment = enrichment;
    coarse::Scene retained = coarse::refined_scene(input);
    for (double gone = step; gone < way; gone += step) {
        input.cracks[0].points[1].x() += step * element;
        retained = coarse::with_functions_left(coarse::make_scene(input, retained.mesh), retained.enriched);
    }
    return condition_number(coarse::Structure(retained));
}

// However short the steps are, unknowns are told apart.
TEST(RetainedFunctions, LeaveTheEquationsWellConditioned) {
    for (const Enrichment enrichment : {Enrichment::Single, Enrichment::Topological}) {
        double largest = 0.0;
        for (const double step : {0.7, 0.35, 0.25, 0.2, 0.1})
            largest = std::max(largest, condition_after(enrichment, step));
        std::cout << fmt::format("{} function(s): condition at most {:.2e}\n", enrichment == Enrichment::Single ? 1 : 6,
                                 largest);
        EXPECT_LT(largest, 1e9);
    }
}

// Of the elastic stiffness with every old function, diagonal scaled to one.
TEST(RetainedFunctions, AreNearlyWhatOtherFunctionsSayAlready) {
    for (const Enrichment enrichment : {Enrichment::Single, Enrichment::Topological}) {
        Case input = edge_crack(0.3, 3.0, End::Pulled);
        input.mesh.size = 1.0 / 61.0;
        input.fine.enrichment = enrichment;
        coarse::Scene retained = coarse::refined_scene(input);
        for (int step = 1; step <= 4; ++step) {
            input.cracks[0].points[1].x() += 0.7 / 61.0;
            retained = coarse::with_functions_left(coarse::make_scene(input, retained.mesh), retained.enriched);
        }
        const coarse::Scene longer = coarse::make_scene(input, retained.mesh);
        const double before = condition_number(coarse::Structure(longer)),
                     after = condition_number(coarse::Structure(retained));
        std::cout << fmt::format(
            "{} functions, 4 steps: {} unknowns, condition {:.2e}; with old functions {}, {:.2e}\n",
            longer.enriched.tip_functions, longer.enriched.unknowns, before, retained.enriched.unknowns, after);
        EXPECT_GT(after, before);
    }
}

}  // namespace
}  // namespace stria::test
