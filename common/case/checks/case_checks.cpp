#include "common/case/checks/case_checks.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <vector>

#include "common/case/case_questions.hpp"
#include "common/case/checks/boundary_checks.hpp"
#include "common/case/loads/load_case_checks.hpp"
#include "common/memory.hpp"

namespace stria {

using schema::find;
using schema::Given;
using schema::Place;
using schema::reject;
using schema::Value;

namespace {

bool moves(const BoundarySection& boundary) {
    return boundary.displacement[0].value_or(0.0) != 0.0 || boundary.displacement[1].value_or(0.0) != 0.0;
}

/// Other than zero.
bool carries_load(const BoundarySection& boundary) {
    return moves(boundary) || !boundary.traction.value_or(Vec2::Zero()).isZero(0.0) ||
           boundary.pressure.value_or(0.0) != 0.0 || !boundary.force.value_or(Vec2::Zero()).isZero(0.0) ||
           !boundary.traction_gradient.isZero(0.0) || boundary.travelling.has_value();
}

constexpr std::size_t most_points = 10'000;  // of a crack as it is given

}  // namespace

/// Mesh sizes are cheap to grade along an axis; an oblique line would ask for a size in two directions.
void check_grading(const Grading& grading, const Value& table, const Place& place) {
    const Given given{table, place};
    const bool point = grading.at.size() == 1;
    const bool line = grading.at.size() == 2 && ((grading.at[0] - grading.at[1]).array() == 0.0).any();
    given.demand(point || line, "at", "must be one point or the two ends of an axis-parallel line");
    if (grading.outer_size && *grading.outer_size < grading.size)
        given.refuse_value("outer_size", "must be >= size", "mm");
}

void check_mesh(const MeshSection& mesh, const Value& table, const Place& place) {
    if (mesh.file) return;
    const Given given{table, place};
    if (mesh.height == 0.0) given.refuse("needs height: a " + mesh.specimen + " has no standard proportions");
    if (mesh.specimen == "ct" && std::abs(mesh.height - 1.2 * mesh.width) > 1e-9 * mesh.width)
        given.refuse_value("height", "must be 1.2 width, or be left out", "mm");
    if (mesh.size > std::min(mesh.width, mesh.height))
        given.refuse_value("size", "must not exceed width and height", "mm");
}

void check_crack(const CrackSection& crack, const Value& table, const Place& place) {
    const Given given{table, place};
    const std::vector<Vec2>& points = crack.points;
    given.demand(points.size() >= 2, "points", "must have at least two points");
    if (points.size() > most_points)
        given.refuse("points", fmt::format("has {} points, at most {} are allowed", points.size(), most_points));
    const auto same = [](const Vec2& a, const Vec2& b) { return a == b; };
    given.demand(std::ranges::adjacent_find(points, same) == points.end(), "points",
                 "must not repeat a point: a segment has no length");
    if (!crack.contact || crack.contact->smooth.empty()) return;
    const std::vector<double>& smooth = crack.contact->smooth;
    const Given contact = given.inside("contact");
    contact.demand(smooth.size() == 2 && smooth[0] >= 0.0 && smooth[1] > smooth[0], "smooth",
                   "must be two arc lengths, the first at least 0 and the second larger");
    contact.demand(crack.contact->friction != 0.0, "smooth", "needs friction > 0 outside of them");
}

namespace {

bool is_curve(const std::vector<double>& x, const std::vector<double>& y) {
    const auto ascends = [](const std::vector<double>& all) {
        return all.front() > 0.0 && std::ranges::adjacent_find(all, std::greater_equal()) == all.end();
    };
    return x.size() == y.size() && x.size() > 1 && ascends(x) && ascends(y);
}

}  // namespace

void check_growth(const GrowthSection& growth, const Value& table, const Place& place) {
    const Given given{table, place};
    const bool power = growth.law == GrowthLaw::Paris || growth.law == GrowthLaw::Ctod;
    given.demand(!power || (growth.C > 0.0 && growth.m > 0.0), "law", "needs C and m, both positive");
    given.demand(growth.law != GrowthLaw::Table || is_curve(growth.ranges, growth.rates), "law",
                 "needs ranges and rates, as long, with two numbers at least, both positive and ascending");
    given.demand(!is_prescribed(growth) || !growth.increment.is_auto(), "increment",
                 "needs law = \"paris\", \"table\" or \"ctod\"");
    for (const auto& [key, value] : {std::pair("C", growth.C), std::pair("m", growth.m)})
        given.demand(growth.law != GrowthLaw::Table || value == 0.0, key, "belongs to law = \"paris\" or \"ctod\"");
    given.demand(growth.walker == 1.0 || (is_law_of_dK(growth) && growth.driving == GrowthDriving::Range), "walker",
                 "belongs to law = \"paris\" or \"table\" with driving = \"dK\"");
    given.demand(!growth.threshold || growth.law == GrowthLaw::Paris, "threshold", "belongs to law = \"paris\"");
    for (const auto& [key, values] : {std::pair("ranges", &growth.ranges), std::pair("rates", &growth.rates)})
        given.demand(values->empty() || growth.law == GrowthLaw::Table, key, "belongs to law = \"table\"");
}

void check_block(const LoadBlock& block, const Value& table, const Place& place) {
    const Given given{table, place};
    const bool ratio = given.has("ratio"), least = given.has("min");
    if (ratio && least) given.refuse("has both ratio and min; one of them says it");
    if (!ratio && !least) given.refuse("needs ratio or min");
    given.demand(block.min < block.max, least ? "min" : "ratio",
                 "must keep the minimum < max: there is no cycle otherwise");
}

/// Functions gathered over a fixed radius belong to the elastic structure: the zone does not take them.
void check_enrichment(const Case& whole, const Value& root, const Place& place) {
    if (find(root, "fine") == nullptr) return;
    const Given fine = Given{root, place}.inside("fine");
    const Enrichment enrichment = whole.fine.enrichment;
    fine.demand(enrichment != Enrichment::Geometrical || !needs_fine(whole), "enrichment",
                "is for elastic, traction-free scenes; others are auto, none, single, topological");
    if (whole.fine.enrichment_radius && enrichment != Enrichment::Geometrical && enrichment != Enrichment::Auto)
        fine.refuse_value("enrichment_radius", "needs enrichment = \"geometrical\" or \"auto\"", "mm");
    fine.demand(whole.fine.refine == 1 || may_yield(whole) || whole.fine.radius, "refine",
                "needs fine.radius where nothing yields: eq. (3) gives no radius there");
}

namespace {

/// The opening range that drives a crack depends on where it is read.
void check_opening_range(const Case& whole, const Value& root, const Place& place) {
    if (!whole.growth || whole.growth->law != GrowthLaw::Ctod || whole.closure.distance) return;
    Given{root, place}.inside("growth").refuse_value(
        "law", "needs closure.distance: how far behind the tip the opening is read");
}

/// Increments that the program chooses are too long to tell a compliance.
void check_compliance(const Case& whole, const Value& root, const Place& place) {
    if (whole.closure.definition != OpeningDefinition::Offset || !whole.load.steps.is_auto()) return;
    Given{root, place}.inside("closure").refuse_value(
        "definition",
        "needs load.steps, for instance 40 with load.grading = 1: it takes segments of a tenth of the load range");
}

/// Only where a load drives the body is there a load factor left to find.
void check_control(const Case& whole, const Value& root, const Place& place) {
    if (find(root, "load") == nullptr) return;
    const Given load = Given{root, place}.inside("load");
    if (whole.load.K_gradient != 0.0 && whole.load.control != Control::StressIntensity)
        load.refuse_value("K_gradient", "needs control = \"K\"", "1/mm");
    if (whole.load.control != Control::Displacement) return;
    const auto driven = std::ranges::find_if(whole.boundaries, [](const BoundarySection& boundary) {
        return is_of_main_load(boundary) && carries_load(boundary);
    });
    load.demand(driven != whole.boundaries.end(), "control", "needs a boundary that carries a load");
    load.demand(!moves(*driven), "control",
                "needs a load on the first boundary that is driven: \"" + driven->on +
                    "\" has a displacement of its own, which control = \"load\" scales");
}

/// Their extremes as the run goes through them.
void check_extremes(const LoadSection& load, const Value& root, const Place& place) {
    const auto is_usual = [&](double value) {
        const double size = std::abs(load.scale * value);
        return value == 0.0 || (size > 1e-100 && size < 1e100);
    };
    const auto unusual = [&](const LoadBlock& block) { return !is_usual(block.max) || !is_usual(block.min); };
    if (std::ranges::none_of(load.blocks, unusual)) return;
    constexpr auto unusual_size =
        "makes a max or min beyond all use: its size must lie between 1e-100 and 1e100, or be zero";
    const Given given = Given{root, place}.inside("load");
    if (given.has("scale")) given.refuse("scale", unusual_size);
    reject(given.place.inside("blocks"), given.table.line, unusual_size);
}

/// All turns of the load are kept in memory, and increments are counted in int.
void check_length(const LoadSection& load, const Value& root, const Place& place) {
    double cycles = 0.0;
    for (const LoadBlock& block : load.blocks) cycles += static_cast<double>(load.repeat) * block.cycles;
    if (cycles == 0.0) return;
    const Value& table = *find(root, "load");
    if (cycles * load.first_steps() > std::numeric_limits<int>::max())
        reject(place.inside("load"), table.line,
               fmt::format("has {:.4g} cycles of {} increments, at most {} increments can be counted", cycles,
                           load.first_steps(), std::numeric_limits<int>::max()));
    require_memory(fmt::format("{}:{}: load: {:.4g} cycles", place.file, table.line, cycles), cycles * bytes_of_cycle);
}

}  // namespace

void check_load(const Case& whole, const Value& root, const Place& place) {
    check_extremes(whole.load, root, place);
    check_length(whole.load, root, place);
    check_cycles_of_cases(whole, root, place);
}

void check_names_of_mesh(const Case& whole, const Value& root, const Place& place) {
    if (whole.mesh.file) return;
    const Given given{root, place};
    for (std::size_t k = 0; k < whole.boundaries.size(); ++k)
        check_boundary_of_specimen(whole.boundaries[k], given.entry("boundary", k));
    for (std::size_t k = 0; k < whole.regions.size(); ++k)
        if (whole.regions[k].group)
            given.entry("region", k).refuse_value("group", "needs mesh.file, whose groups have names");
}

void check_case(const Case& whole, const Value& root, const Place& place) {
    check_enrichment(whole, root, place);
    const Given given{root, place};
    const bool names_a_folder = whole.name.find('/') == std::string::npos && whole.name != "." && whole.name != "..";
    given.demand(names_a_folder, "name", "must be the name of a folder, without /");
    check_control(whole, root, place);
    check_opening_range(whole, root, place);
    check_compliance(whole, root, place);
    check_load_cases(whole, root, place);
    if (std::ranges::none_of(whole.boundaries, carries_load))
        reject(place.inside("boundary"), root.line,
               "carries no load: give one a displacement, traction, pressure or force other than zero");
    if (!whole.load.blocks.empty() || whole.load.spectrum) return;
    const Value* load = find(root, "load");
    for (const BoundarySection& boundary : whole.boundaries)
        if (carries_load(boundary))
            reject(place.inside("load.blocks"), load != nullptr ? load->line : root.line,
                   "is empty, but boundary \"" + boundary.on + "\" carries a load: give at least one block");
}

}  // namespace stria
