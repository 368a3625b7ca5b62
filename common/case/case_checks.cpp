#include "common/case/case_checks.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <limits>
#include <vector>

#include "common/case/case_questions.hpp"
#include "common/case/loads/load_case_checks.hpp"
#include "common/memory.hpp"

namespace stria {

using schema::find;
using schema::Key;
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

bool says_something(const BoundarySection& boundary) {
    return boundary.displacement[0] || boundary.displacement[1] || boundary.traction || boundary.pressure ||
           boundary.force || boundary.travelling;
}

constexpr std::size_t most_points = 10'000;  // of a crack as it is given

}  // namespace

/// Mesh sizes are cheap to grade along an axis; an oblique line would ask for a size in two directions.
void check_grading(const Grading& grading, const Value& table, const Place& place) {
    const bool point = grading.at.size() == 1;
    const bool line = grading.at.size() == 2 && ((grading.at[0] - grading.at[1]).array() == 0.0).any();
    if (!point && !line)
        reject(place.inside("at"), *find(table, "at"), {},
               "must be one point or the two ends of an axis-parallel line");
    if (grading.outer_size && *grading.outer_size < grading.size)
        reject(place.inside("outer_size"), *find(table, "outer_size"), Key{}.in("mm"), "must be >= size");
}

void check_mesh(const MeshSection& mesh, const Value& table, const Place& place) {
    if (mesh.file) return;
    if (mesh.height == 0.0)
        reject(place, table.line, "needs height: a " + mesh.specimen + " has no standard proportions");
    if (mesh.specimen == "ct" && std::abs(mesh.height - 1.2 * mesh.width) > 1e-9 * mesh.width)
        reject(place.inside("height"), *find(table, "height"), Key{}.in("mm"), "must be 1.2 width, or be left out");
    if (mesh.size > std::min(mesh.width, mesh.height))
        reject(place.inside("size"), *find(table, "size"), Key{}.in("mm"), "must not exceed width and height");
}

void check_crack(const CrackSection& crack, const Value& table, const Place& place) {
    const Value& points = *find(table, "points");
    if (crack.points.size() < 2) reject(place.inside("points"), points, {}, "must have at least two points");
    if (crack.points.size() > most_points)
        reject(place.inside("points"), points.line,
               fmt::format("has {} points, at most {} are allowed", crack.points.size(), most_points));
    for (std::size_t i = 1; i < crack.points.size(); ++i)
        if (crack.points[i] == crack.points[i - 1])
            reject(place.inside("points"), points, {}, "must not repeat a point: a segment has no length");
    if (!crack.contact || crack.contact->smooth.empty()) return;
    const std::vector<double>& smooth = crack.contact->smooth;
    if (smooth.size() != 2 || !(smooth[0] >= 0.0 && smooth[1] > smooth[0]))
        reject(place.inside("contact.smooth"), *find(*find(table, "contact"), "smooth"), {},
               "must be two arc lengths, the first at least 0 and the second larger");
    if (crack.contact->friction == 0.0)
        reject(place.inside("contact.smooth"), *find(*find(table, "contact"), "smooth"), {},
               "needs friction > 0 outside of them");
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
    const bool power = growth.law == GrowthLaw::Paris || growth.law == GrowthLaw::Ctod;
    if (power && (growth.C <= 0.0 || growth.m <= 0.0))
        reject(place.inside("law"), *find(table, "law"), {}, "needs C and m, both positive");
    if (growth.law == GrowthLaw::Table && !is_curve(growth.ranges, growth.rates))
        reject(place.inside("law"), *find(table, "law"), {},
               "needs ranges and rates, as long, with two numbers at least, both positive and ascending");
    if (is_prescribed(growth) && growth.increment.is_auto())
        reject(place.inside("increment"), *find(table, "increment"), {},
               "needs law = \"paris\", \"table\" or \"ctod\"");
    const auto belongs = [&](const char* key, bool given, GrowthLaw law, const char* name) {
        if (given && growth.law != law)
            reject(place.inside(key), *find(table, key), {}, fmt::format("belongs to law = \"{}\"", name));
    };
    for (const auto& [key, value] : {std::pair("C", growth.C), std::pair("m", growth.m)})
        if (growth.law == GrowthLaw::Table && value != 0.0)
            reject(place.inside(key), *find(table, key), {}, "belongs to law = \"paris\" or \"ctod\"");
    const bool by_range =
        (growth.law == GrowthLaw::Paris || growth.law == GrowthLaw::Table) && growth.driving == GrowthDriving::Range;
    if (growth.walker != 1.0 && !by_range)
        reject(place.inside("walker"), *find(table, "walker"), {},
               "belongs to law = \"paris\" or \"table\" with driving = \"dK\"");
    belongs("threshold", growth.threshold.has_value(), GrowthLaw::Paris, "paris");
    belongs("ranges", !growth.ranges.empty(), GrowthLaw::Table, "table");
    belongs("rates", !growth.rates.empty(), GrowthLaw::Table, "table");
}

void check_boundary(const BoundarySection& boundary, const Value& table, const Place& place) {
    const bool point = boundary.on == "point";
    const auto complain = [&](const char* key, const char* demand) {
        if (const Value* given = find(table, key)) reject(place.inside(key), *given, {}, demand);
    };
    if (point && !boundary.at) reject(place, table.line, "on = \"point\" needs at = [x, y]");
    if (!point) complain("at", "needs on = \"point\"");
    if (point)
        for (const char* key : {"traction", "pressure"}) complain(key, "needs an edge, not a point");
    if (point && !boundary.traction_gradient.isZero(0.0)) complain("traction_gradient", "needs an edge, not a point");
    check_pressure(boundary, table, place);
    if (!says_something(boundary) && find(table, "traction_gradient") == nullptr)
        reject(place, table.line, "needs a displacement, traction, pressure or force");
}

void check_block(const LoadBlock& block, const Value& table, const Place& place) {
    const Value* ratio = find(table, "ratio");
    const Value* least = find(table, "min");
    if (ratio != nullptr && least != nullptr) reject(place, table.line, "has both ratio and min; one of them says it");
    if (ratio == nullptr && least == nullptr) reject(place, table.line, "needs ratio or min");
    if (block.min < block.max) return;
    const char* name = least != nullptr ? "min" : "ratio";
    reject(place.inside(name), least != nullptr ? *least : *ratio, {},
           "must keep the minimum < max: there is no cycle otherwise");
}

/// Functions gathered over a fixed radius belong to the elastic structure: the zone does not take them.
void check_enrichment(const Case& whole, const Value& root, const Place& place) {
    const Value* fine = find(root, "fine");
    if (fine == nullptr) return;
    const Enrichment enrichment = whole.fine.enrichment;
    if (enrichment == Enrichment::Geometrical && needs_fine(whole))
        reject(place.inside("fine.enrichment"), *find(*fine, "enrichment"), {},
               "is for elastic, traction-free scenes; others are auto, none, single, topological");
    if (whole.fine.enrichment_radius && enrichment != Enrichment::Geometrical && enrichment != Enrichment::Auto)
        reject(place.inside("fine.enrichment_radius"), *find(*fine, "enrichment_radius"), Key{}.in("mm"),
               "needs enrichment = \"geometrical\" or \"auto\"");
    if (whole.fine.refine > 1 && !may_yield(whole) && !whole.fine.radius)
        reject(place.inside("fine.refine"), *find(*fine, "refine"), {},
               "needs fine.radius where nothing yields: eq. (3) gives no radius there");
}

namespace {

/// The opening range that drives a crack depends on where it is read.
void check_opening_range(const Case& whole, const Value& root, const Place& place) {
    if (!whole.growth || whole.growth->law != GrowthLaw::Ctod || whole.closure.distance) return;
    reject(place.inside("growth.law"), *find(*find(root, "growth"), "law"), {},
           "needs closure.distance: how far behind the tip the opening is read");
}

/// Increments that the program chooses are too long to tell a compliance.
void check_compliance(const Case& whole, const Value& root, const Place& place) {
    if (whole.closure.definition != OpeningDefinition::Offset || !whole.load.steps.is_auto()) return;
    reject(place.inside("closure.definition"), *find(*find(root, "closure"), "definition"), {},
           "needs load.steps, for instance 40 with load.grading = 1: it takes segments of a tenth of the load range");
}

/// Only where a load drives the body is there a load factor left to find.
void check_control(const Case& whole, const Value& root, const Place& place) {
    if (whole.load.K_gradient != 0.0 && whole.load.control != Control::StressIntensity)
        reject(place.inside("load.K_gradient"), *find(*find(root, "load"), "K_gradient"), Key{}.in("1/mm"),
               "needs control = \"K\"");
    if (whole.load.control != Control::Displacement) return;
    const Value& control = *find(*find(root, "load"), "control");
    const auto driven = std::ranges::find_if(whole.boundaries, [](const BoundarySection& boundary) {
        return is_of_main_load(boundary) && carries_load(boundary);
    });
    if (driven == whole.boundaries.end())
        reject(place.inside("load.control"), control, {}, "needs a boundary that carries a load");
    if (moves(*driven))
        reject(place.inside("load.control"), control, {},
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
    const Value& table = *find(root, "load");
    const Value* scale = find(table, "scale");
    reject(place.inside(scale != nullptr ? "load.scale" : "load.blocks"), scale != nullptr ? scale->line : table.line,
           "makes a max or min beyond all use: its size must lie between 1e-100 and 1e100, or be zero");
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

void check_case(const Case& whole, const Value& root, const Place& place) {
    check_enrichment(whole, root, place);
    if (whole.name.find('/') != std::string::npos || whole.name == "." || whole.name == "..")
        reject(place.inside("name"), *find(root, "name"), {}, "must be the name of a folder, without /");
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
