#include "tests/stress/crack_trials.hpp"

#include <cmath>
#include <fmt/format.h>

#include "coarse/advice/mesh_adequacy.hpp"
#include "coarse/enrichment/enrichment.hpp"
#include "coarse/enrichment/tip_enrichment.hpp"
#include "coarse/model/crack_room.hpp"
#include "common/error.hpp"
#include "common/fracture/williams.hpp"
#include "common/integration/crack_faces.hpp"
#include "tests/stress/inner_crack.hpp"
#include "tests/stress/random_crack.hpp"
#include "tests/support/condition_number.hpp"
#include "tests/support/elastic_scene.hpp"
#include "tests/support/one_equilibrium.hpp"

namespace stria::test {
namespace {

constexpr double compression = 100.0;  // MPa

Case case_of(const CrackedPlate& plate, bool contact) {
    Case input;
    input.material.young = steel.young;
    input.material.poisson = steel.poisson;
    input.cracks = {{.points = plate.points, .contact = {}}};
    if (contact) input.cracks[0].contact = ContactSection{};
    return input;
}

/// Under the tractions of a uniform stress; what is free to move is pinned.
coarse::Scene scene_of(const CrackedPlate& plate, const Case& input, const coarse::TipEnrichment& tips,
                       const Eigen::Matrix2d& stress) {
    coarse::Scene scene;
    scene.input = input;
    scene.mesh = BodyMesh(plate.mesh);
    scene.materials = Materials(input);
    scene.loads.main = boundary_tractions(plate.mesh, stress);
    scene.free_motions = coarse::analyse_rigid_motions(scene.mesh, scene.loads.main);
    scene.enriched = coarse::enrich(scene.mesh, input.cracks, tips);
    coarse::put_loads_on_unknowns(scene);
    return scene;
}

/// The tip of each unknown that belongs to one, else -1.
std::vector<int> tips_of_unknowns(const EnrichedMesh& mesh) {
    std::vector<int> owner(at(mesh.unknowns), -1);
    for (const auto& [node, term, unknown] : mesh.own_unknowns()) {
        if (term == 0) continue;
        const Term& t = mesh.terms[at(node)][at(term - 1)];
        if (t.kind == Term::Kind::Heaviside) continue;
        owner[at(unknown)] = owner[at(unknown + 1)] = t.owner;
    }
    return owner;
}

/// What faces that transmit a uniform stress push the unknowns with. Tip functions are integrated about their own tip.
Eigen::VectorXd face_forces(const EnrichedMesh& mesh, const Eigen::Matrix2d& stress) {
    Eigen::VectorXd force = Eigen::VectorXd::Zero(mesh.unknowns);
    const std::vector<int> owner = tips_of_unknowns(mesh);
    const auto add = [&](const std::vector<FaceStation>& stations, int tip) {
        for (const FaceStation& station : stations)
            for (const FaceStation::Term& term : station.terms)
                if (owner[at(term.unknown)] == tip)
                    force.segment<2>(term.unknown) -= station.weight * term.value * (stress * station.normal);
    };
    add(face_stations(mesh, 0, 1, 8), -1);
    for (int t = 0; t < static_cast<int>(mesh.tips.size()); ++t)
        add(face_stations_about(mesh, mesh.tips[at(t)], 1, 16), t);
    return force;
}

/// Standard unknowns and jumps; tip functions that all nodes of a disk share are free.
void hold_boundary(coarse::Scene& scene) {
    const EnrichedMesh& mesh = scene.enriched;
    scene.prescribed.clear();
    for (const int node : boundary_nodes(scene.mesh)) {
        for (int term = 0; term <= static_cast<int>(mesh.terms[at(node)].size()); ++term) {
            if (term > 0 && mesh.terms[at(node)][at(term - 1)].kind != Term::Kind::Heaviside) continue;
            for (int c = 0; c < 2; ++c) scene.prescribed.push_back({mesh.unknown(node, term, c), 0.0});
        }
    }
    std::ranges::sort(scene.prescribed, {}, &coarse::PrescribedUnknown::unknown);
}

/// A uniform stress that the faces transmit leaves every unknown in balance.
double imbalance(const CrackedPlate& plate, const coarse::TipEnrichment& tips, const Eigen::Matrix2d& stress) {
    coarse::Scene scene = scene_of(plate, case_of(plate, false), tips, stress);
    const Eigen::VectorXd outside = scene.unit_force + face_forces(scene.enriched, stress);
    hold_boundary(scene);
    const Eigen::VectorXd u = linear_field(scene.enriched, gradient_of(stress, steel));
    const SparseMatrix K = coarse::Structure(scene).elements().stiffness();
    const Eigen::VectorXd scale = K.cwiseAbs() * u.cwiseAbs();
    return (K * u - outside).cwiseAbs().maxCoeff() / scale.maxCoeff();
}

constexpr coarse::TipEnrichment no_functions{0, 0.5}, single{1, 0.5}, six{6, 0.5},
    gathered{4, 0.5, coarse::TipSupport::Gathered};

// Exact, but where a crossing was moved onto a node, by up to 1e-3 of an edge, and the next one lies as near: then it
// shows in the second order.
constexpr double patch_limit = 2e-5;

void try_patch(const CrackedPlate& plate, unsigned seed, Tally& tally) {
    const Eigen::Matrix2d stress{{70.0, 30.0}, {30.0, -100.0}};
    tally.measure("patch test, no function", seed, imbalance(plate, no_functions, stress), patch_limit);
    tally.measure("patch test, one function", seed, imbalance(plate, single, stress), patch_limit);
    tally.measure("patch test, six functions", seed, imbalance(plate, six, stress), patch_limit);
    tally.measure("patch test, fixed radius", seed, imbalance(plate, gathered, stress), patch_limit);
}

struct Pressed {
    std::string name;
    Enrichment enrichment = Enrichment::Auto;
    std::optional<double> yield_stress = {};  // that nothing reaches
    double limit = 0.0;
    double poisson = steel.poisson;
    std::optional<double> n = {};  // of the function
};

// Exact but for crossings moved onto nodes, where the functions are r^(1/2), or none, and the crack is straight about
// its tip. Other jumps are no polynomials in r^(1/2), and the work of the pressure on them is integrated by four
// points.
const std::array presses{Pressed{"pressure, no function", Enrichment::None, {}, 1e-3},
                         Pressed{"pressure, six functions", Enrichment::Auto, {}, 3e-3},
                         Pressed{"pressure, one function, J2", Enrichment::Auto, 1e6, 3e-3},
                         Pressed{"pressure, the same, nu = 0.4999", Enrichment::Auto, 1e6, 3e-3, 0.4999},
                         Pressed{"pressure, one function, n = 10", Enrichment::Auto, 1e6, 3e-3, steel.poisson, 10.0}};

/// Pressed alike from all sides the faces bear that pressure, whatever their shape.
void try_pressure(const CrackedPlate& plate, const Pressed& press, unsigned seed, Tally& tally) {
    Case input = case_of(plate, true);
    input.material.yield_stress = press.yield_stress;
    input.material.poisson = press.poisson;
    if (press.yield_stress) input.fine.radius = 0.2;
    input.fine.enrichment = press.enrichment;
    input.fine.enrichment_n = press.n;
    input.solver.tolerance = 1e-11;
    const Eigen::Matrix2d stress = -compression * Eigen::Matrix2d::Identity();
    const Equilibrated result = equilibrate(scene_of(plate, input, coarse::choose_enrichment(input), stress), 1.0);
    if (!result.newton.converged) return tally.fail(press.name, seed, "no equilibrium: " + result.newton.failure);
    double off = 0.0;
    for (const coupling::FaceSample& face : result.zone.faces)
        off = std::max(off, std::abs(face.pressure / compression - 1.0));
    tally.measure(press.name, seed, off, press.limit);
    tally.measure(press.name + ", iterations", seed, result.newton.count(), 10.0);
}

/// Of K_I = 1, K_II = 1/2 at every tip, by displacements on the boundary; relative to K_I.
double intensity_error(const CrackedPlate& plate) {
    const Case input = case_of(plate, false);
    coarse::Scene scene = scene_of(plate, input, coarse::choose_enrichment(input), Eigen::Matrix2d::Zero());
    const EnrichedMesh& mesh = scene.enriched;
    hold_boundary(scene);
    const auto set = [&](int unknown, const Vec2& value) {
        for (coarse::PrescribedUnknown& p : scene.prescribed)
            for (int c = 0; c < 2; ++c)
                if (p.unknown == unknown + c) p.value = value[c];
    };
    const Vec2 first = plate.points.front(), last = plate.points.back();
    const double length = (last - first).norm(), a = 0.5 * length, unit_K = 1.0 / std::sqrt(std::numbers::pi * a);
    const InnerCrack inner{0.5 * (first + last), (last - first) / length, a, unit_K, 0.5 * unit_K};
    const auto exact = [&](const Vec2& x, int side) {
        if (mesh.tips.size() > 1) return inner.displacement(x);
        const auto mode = [&](int m) {
            return williams_field(m, mesh.tips.front(), x, side, scene.materials.elastic(0)).displacement;
        };
        return Vec2(mode(1) + 0.5 * mode(2));
    };
    for (const int node : boundary_nodes(scene.mesh)) {
        const double side = heaviside_side(mesh, node);
        const Vec2& x = mesh.nodes[at(node)];
        set(mesh.unknown(node, 0, 0), exact(x, side > 0.0 ? 1 : side < 0.0 ? -1 : 0));
        if (side != 0.0) set(mesh.unknown(node, 1, 0), 0.5 * (exact(x, 1) - exact(x, -1)));
    }
    const coarse::Structure structure(scene);
    double error = 0.0;
    const auto tips = coarse::fracture_parameters(structure, structure.expand({}, 1.0), {});
    for (const coarse::TipResult& tip : tips)
        error = std::max({error, std::abs(tip.K_I - 1.0), std::abs(tip.K_II - 0.5)});
    return error;
}

/// K_I and K_II of each tip under a uniform stress.
std::vector<Vec2> intensities(const CrackedPlate& plate, double E = steel.young) {
    Case input = case_of(plate, false);
    input.material.young = E;
    const Eigen::Matrix2d stress{{20.0, 30.0}, {30.0, 100.0}};
    const coarse::Scene scene = scene_of(plate, input, coarse::choose_enrichment(input), stress);
    const coarse::Structure structure(scene);
    std::vector<Vec2> found;
    for (const coarse::TipResult& tip : coarse::fracture_parameters(structure, structure.expand({}, 1.0), {}))
        found.emplace_back(tip.K_I, tip.K_II);
    return found;
}

/// Largest relative distance; nothing where there are other tips.
double distance(const std::vector<Vec2>& before, const std::vector<Vec2>& after) {
    double largest = 0.0;
    for (std::size_t t = 0; before.size() == after.size() && t < before.size(); ++t)
        largest = std::max(largest, (after[t] - before[t]).norm() / before[t].norm());
    return largest;
}

double change_by_a_hair(const CrackedPlate& plate) {
    CrackedPlate moved = plate;
    for (Vec2& x : moved.points) x += 1e-9 * plate.h * Vec2(0.7, 0.6);
    return distance(intensities(plate), intensities(moved));
}

/// The same body in other units of length, and of a metal a million times as stiff or as soft.
double change_by_units(const CrackedPlate& plate, double length) {
    CrackedPlate scaled = plate;
    for (Vec2& x : scaled.mesh.nodes) x *= length;
    for (Vec2& x : scaled.points) x *= length;
    std::vector<Vec2> found = intensities(scaled, length * steel.young);
    for (Vec2& K : found) K /= std::sqrt(length);
    return distance(intensities(plate), found);
}

/// What a run says of tips whose K is not resolved.
std::vector<std::string> warnings_of(const CrackedPlate& plate) {
    const Case input = case_of(plate, false);
    return coarse::mesh_warnings(scene_of(plate, input, coarse::choose_enrichment(input), Eigen::Matrix2d::Zero()), {},
                                 {});
}

void try_intensities(const CrackedPlate& plate, unsigned seed, Tally& tally) {
    if (const auto warnings = warnings_of(plate); !warnings.empty())
        return tally.refuse("warning: " + warnings.front(), seed);
    // What no warning is to hide. A tip that comes onto an edge changes K by a part of it.
    constexpr double promised = 0.02;
    if (plate.straight) tally.measure("K of an exact field", seed, intensity_error(plate), promised);
    tally.measure("K, moved by a hair", seed, change_by_a_hair(plate), promised);
    for (const double length : {0x1p-20, 0x1p20})  // 1e-6 and 1e6, without rounding
        tally.measure("K, in other units", seed, change_by_units(plate, length), 1e-9);
}

coarse::Scene with_boundary_held(const CrackedPlate& plate, bool with_crack) {
    Case input = case_of(plate, false);
    if (!with_crack) input.cracks.clear();
    coarse::Scene scene = scene_of(plate, input, coarse::choose_enrichment(input), Eigen::Matrix2d::Zero());
    hold_boundary(scene);
    return scene;
}

/// Against the same plate without a crack. Functions of each node cost more than shared ones.
void try_conditioning(const CrackedPlate& plate, unsigned seed, Tally& tally) {
    const auto number = [](const coarse::Scene& scene) { return condition_number(coarse::Structure(scene), 40); };
    const coarse::Scene cracked = with_boundary_held(plate, true), whole = with_boundary_held(plate, false);
    const bool own = std::ranges::any_of(cracked.enriched.terms.lists(), [](const std::vector<Term>& terms) {
        return std::ranges::find(terms, Term::Kind::Tip, &Term::kind) != terms.end();
    });
    tally.measure(own ? "condition number, functions of each node" : "condition number, over that without a crack",
                  seed, number(cracked) / number(whole), own ? 2000.0 : 10.0);
}

/// One check; a sentence to the user is no failure, anything else that is thrown is one.
template <class Check> bool guarded(const char* name, unsigned seed, Tally& tally, const Check& check) {
    try {
        check();
        return true;
    } catch (const CaseError& error) {
        tally.refuse(error.what(), seed);
    } catch (const std::exception& error) {
        tally.fail(name, seed, error.what());
    }
    return false;
}

}  // namespace

void try_crack(const CrackedPlate& plate, unsigned seed, Tally& tally) {
    const bool legal = guarded("room", seed, tally, [&] {
        const EnrichedMesh enriched = coarse::enrich(BodyMesh(plate.mesh), case_of(plate, false).cracks, single);
        coarse::require_room(plate.mesh, enriched, 1);
        coarse::require_tips(enriched, 1);
    });
    if (!legal) return;
    guarded("patch test", seed, tally, [&] { try_patch(plate, seed, tally); });
    for (const Pressed& press : presses)
        guarded("pressure", seed, tally, [&] { try_pressure(plate, press, seed, tally); });
    guarded("intensities", seed, tally, [&] { try_intensities(plate, seed, tally); });
    guarded("conditioning", seed, tally, [&] { try_conditioning(plate, seed, tally); });
}

}  // namespace stria::test
