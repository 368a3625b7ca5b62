#include "coarse/model/scene.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>

#include "coarse/enrichment/enrichment.hpp"
#include "coarse/enrichment/retained_functions.hpp"
#include "coarse/enrichment/tip_enrichment.hpp"
#include "coarse/model/crack_room.hpp"
#include "coarse/specimen/initial_field.hpp"
#include "coarse/specimen/regions.hpp"
#include "common/enrichment/element_basis.hpp"
#include "common/error.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/index.hpp"
#include "common/integration/cut_element.hpp"
#include "common/integration/element_operator.hpp"

namespace stria::coarse {
namespace {

/// Splits an element edge where a crack leaves it, so that each part lies on one side.
std::vector<double> edge_breaks(const CrackPiece* piece, int edge) {
    std::vector<double> breaks{0.0, 1.0};
    if (piece != nullptr) {
        for (const double place : {piece->entry, piece->exit}) {
            if (place > edge && place < edge + 1) breaks.push_back(place - edge);
        }
    }
    std::ranges::sort(breaks);
    return breaks;
}

void add_edge_load(const Scene& scene, const EdgeLoad& load, const CrackPiece* piece, Eigen::VectorXd& force) {
    const EdgeGeometry edge = edge_geometry(scene.mesh, load.edge);
    const ElementBasis basis(scene.enriched, load.edge.element, piece != nullptr);
    const std::vector<double> breaks = edge_breaks(piece, load.edge.edge);
    BasisValues values;
    for (std::size_t part = 0; part + 1 < breaks.size(); ++part) {
        const double length = breaks[part + 1] - breaks[part];
        int side = 0;
        if (piece != nullptr)
            side = cut_element(basis.corners(), *piece)
                       .side_of(edge.at(breaks[part] + length / 2.0) + 1e-6 * edge.length() * edge.inward_normal());
        for (const auto& [fraction, weight] :
             edge_points(load.traction, edge, breaks[part], breaks[part + 1], basis.singular() ? 16 : 3)) {
            const Vec2 x = edge.at(fraction);
            const Vec2 traction = load.traction.at(x, edge.inward_normal());
            basis.evaluate(map_to_parent(basis.corners(), x), x, side, values);
            for (int f = 0; f < basis.functions(); ++f) {
                for (int c = 0; c < 2; ++c)
                    force[basis.unknowns()[at(2 * f + c)]] += weight * values.value[f] * traction[c];
            }
        }
    }
}

/// The crack passes through a node at an end of one of its pieces.
bool lies_on(const EnrichedMesh& mesh, int crack, int node) {
    const auto ends_at = [&](const CrackPiece& piece, double place) {
        return place >= 0.0 && place == std::floor(place) &&
               mesh.elements[at(piece.element)][static_cast<std::size_t>(place) % 4] == node;
    };
    return std::ranges::any_of(mesh.pieces, [&](const CrackPiece& piece) {
        return piece.crack == crack && (ends_at(piece, piece.entry) || ends_at(piece, piece.exit));
    });
}

/// Enriched terms that move a supported edge: Heaviside terms where the crack crosses it, or where it begins at a node
/// beside which the edge lies on the other side, and all tip functions. A node on the crack is of one face; where a
/// support ends there it must be that one's.
class EdgeSupports {
public:
    EdgeSupports(const Scene& scene, const std::map<std::pair<int, int>, double>& held) : mesh_(scene.enriched) {
        for (const auto& [name, edges] : scene.mesh.boundary)
            for (const BoundaryEdge& edge : edges)
                for (int component = 0; component < 2; ++component) {
                    const auto [from, to] = edge_nodes(scene.mesh, edge);
                    if (!held.contains({from, component}) || !held.contains({to, component})) continue;
                    look_at(edge.element, from, to, component);
                    look_at(edge.element, to, from, component);
                }
    }

    /// Throws CaseError where a support ends at a crack, on the face to which the node there does not belong.
    void hold(std::map<int, double>& prescribed) const {
        for (const auto& [unknown, term] : moved_) {
            if (!own_face_.contains(unknown) && term.crack >= 0 && lies_on(mesh_, term.crack, term.node))
                throw CaseError(fmt::format("boundary: a support ends at ({:.6g}, {:.6g}), where crack {} begins, on "
                                            "the right of the crack's points; give them in reverse order",
                                            mesh_.nodes[at(term.node)].x(), mesh_.nodes[at(term.node)].y(),
                                            term.crack));
            prescribed[unknown] = 0.0;
        }
    }

private:
    struct Moved {
        int node, crack;  // crack: of a Heaviside term; else -1
    };

    void look_at(int element, int node, int other, int component) {
        const auto& terms = mesh_.terms[at(node)];
        for (int k = 0; k < static_cast<int>(terms.size()); ++k) {
            const Term& term = terms[at(k)];
            const int unknown = mesh_.unknown(node, k + 1, component);
            if (term.kind == Term::Kind::Tip || term.kind == Term::Kind::Left) moved_[unknown] = {node, -1};
            if (term.kind != Term::Kind::Heaviside) continue;
            const bool crossed = std::ranges::any_of(mesh_.terms[at(other)], [&](const Term& t) {
                return t.kind == Term::Kind::Heaviside && t.owner == term.owner && t.shift != term.shift;
            });
            if (crossed || mesh_.element_side[at(element)] * term.shift < 0)
                moved_[unknown] = {node, term.owner};
            else
                own_face_.insert(unknown);
        }
    }

    const EnrichedMesh& mesh_;
    std::map<int, Moved> moved_;
    std::set<int> own_face_;  // unknowns of Heaviside terms that vanish on a held edge
};

/// Displacements that a load case imposes.
void move_in_case(Scene& scene, std::size_t k) {
    for (const PrescribedDisplacement& d : scene.loads.cases[k].displacements) {
        const int unknown = scene.enriched.unknown(d.node, 0, d.component);
        PrescribedUnknown& p = *std::ranges::lower_bound(scene.prescribed, unknown, {}, &PrescribedUnknown::unknown);
        p.in_cases.resize(k + 1, 0.0);
        p.in_cases[k] = d.value;
    }
}

/// Each load case balances by itself what the supports leave free.
void require_balanced_cases(const Scene& scene) {
    for (const Loads& of_case : scene.loads.cases) {
        Loads loads = scene.loads.main;
        loads.edges = of_case.edges;
        loads.forces = of_case.forces;
        static_cast<void>(analyse_rigid_motions(scene.mesh, loads));
    }
}

/// What the loads of [load] do work on, over what pulls along the loaded boundary's direction. They balance, so that a
/// motion which nothing holds does not change it.
std::vector<NodalWeight> displacement_of_loads(const Scene& scene, double pull) {
    std::set<int> nodes;
    for (const EdgeLoad& load : scene.loads.main.edges)
        for (const int node : edge_nodes(scene.mesh, load.edge)) nodes.insert(node);
    for (const PointForce& load : scene.loads.main.forces) nodes.insert(load.node);
    std::vector<NodalWeight> sum;
    for (const int node : nodes)
        sum.push_back({node, scene.unit_force.segment<2>(scene.enriched.unknown(node, 0, 0)) / pull});
    return sum;
}

void weigh_mean_displacement(Scene& scene, const std::optional<LoadedBoundary>& loaded) {
    scene.mean_displacement = Eigen::VectorXd::Zero(scene.enriched.unknowns);
    if (!loaded || !loaded->has_direction()) return;
    std::vector<NodalWeight> sum = mean_displacement(scene.mesh, *loaded);
    const bool bends_only = loaded->resultant.isZero(0.0);
    if (loaded->by_force && !bends_only && is_left_free(sum, scene.mesh, scene.loads.main))
        sum = displacement_of_loads(scene, loaded->pull);
    for (const auto& [node, weight] : sum)
        scene.mean_displacement.segment<2>(scene.enriched.unknown(node, 0, 0)) += weight;
}

/// Direction of the loaded boundary on its prescribed unknowns, where no force tells its load.
void weigh_reactions(Scene& scene, const std::optional<LoadedBoundary>& loaded) {
    scene.pull = Eigen::VectorXd::Zero(std::ssize(scene.prescribed));
    if (!loaded || loaded->by_force) return;
    for (const int node : loaded->nodes) {
        for (int c = 0; c < 2; ++c) {
            const int unknown = scene.enriched.unknown(node, 0, c);
            const auto found = std::ranges::lower_bound(scene.prescribed, unknown, {}, &PrescribedUnknown::unknown);
            if (found != scene.prescribed.end() && found->unknown == unknown)
                scene.pull[found - scene.prescribed.begin()] = loaded->direction[c];
        }
    }
}

}  // namespace

void impose(const std::vector<PrescribedUnknown>& prescribed, const LoadFactors& factors, Eigen::VectorXd& u) {
    for (const PrescribedUnknown& p : prescribed) u[p.unknown] = p.under(factors);
}

Scene make_scene(const Case& input, Mesh mesh, int refined) {
    Scene scene;
    scene.input = input;
    scene.materials = Materials(input);
    scene.mesh = std::move(mesh);
    if (scene.mesh.material.empty()) scene.mesh.material = materials_of_elements(scene.mesh, input.regions);
    if (input.initial_stress) check_initial_stress(*input.initial_stress, scene.mesh);
    require_near(scene.mesh, input.cracks);
    scene.enriched = enrich(scene.mesh, input.cracks, choose_enrichment(input));
    if (refined > 0) require_room(scene.mesh, scene.enriched, refined);
    scene.loads = resolve_loads(scene.mesh, input);
    if (refined > 0) require_room_beside_loads(scene.mesh, scene.enriched, scene.loads, refined);
    scene.free_motions = analyse_rigid_motions(scene.mesh, scene.loads.main);
    require_balanced_cases(scene);
    put_loads_on_unknowns(scene);
    if (input.load.control == Control::Displacement && scene.unit_force.isZero(0.0))
        throw CaseError("load.control: \"displacement\" needs a traction, pressure or force other than zero");
    return scene;
}

Scene with_functions_left(Scene scene, const EnrichedMesh& before) {
    scene.enriched = with_functions_left(std::move(scene.enriched), before);
    put_loads_on_unknowns(scene);
    return scene;
}

void put_loads_on_unknowns(Scene& scene) {
    const EnrichedMesh& mesh = scene.enriched;
    scene.unit_force = Eigen::VectorXd::Zero(mesh.unknowns);
    scene.observed = UnknownSet(mesh.unknowns);
    const auto observe = [&](int node) {
        for (const int component : {0, 1}) scene.observed.insert(mesh.unknown(node, 0, component));
    };
    const std::vector<int> piece = piece_of_elements(mesh);
    const auto put = [&](const Loads& loads, Eigen::VectorXd& force) {
        for (const EdgeLoad& load : loads.edges) {
            const int p = piece[at(load.edge.element)];
            add_edge_load(scene, load, p >= 0 ? &mesh.pieces[at(p)] : nullptr, force);
            for (const int node : edge_nodes(scene.mesh, load.edge)) observe(node);
        }
        for (const PointForce& load : loads.forces) {
            force.segment<2>(mesh.unknown(load.node, 0, 0)) += load.force;
            observe(load.node);
        }
    };
    put(scene.loads.main, scene.unit_force);
    scene.case_forces.assign(scene.loads.cases.size(), Eigen::VectorXd::Zero(mesh.unknowns));
    for (std::size_t k = 0; k < scene.case_forces.size(); ++k) put(scene.loads.cases[k], scene.case_forces[k]);
    const std::optional<LoadedBoundary> loaded = loaded_boundary(scene.mesh, scene.input, scene.loads);
    weigh_mean_displacement(scene, loaded);
    std::map<std::pair<int, int>, double> held;
    for (const PrescribedDisplacement& d : scene.loads.main.displacements) held[{d.node, d.component}] = d.value;
    std::map<int, double> prescribed;
    EdgeSupports(scene, held).hold(prescribed);
    for (const auto& pin : scene.free_motions.pins) held[{pin.node, pin.component}] = 0.0;
    for (const auto& [where, value] : held) {
        prescribed[mesh.unknown(where.first, 0, where.second)] = value;
        observe(where.first);
    }
    scene.prescribed.clear();
    for (const auto& [unknown, value] : prescribed) scene.prescribed.push_back({unknown, value});
    for (std::size_t k = 0; k < scene.loads.cases.size(); ++k) move_in_case(scene, k);
    weigh_reactions(scene, loaded);
}

}  // namespace stria::coarse
