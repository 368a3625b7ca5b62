#include "coarse/model/scene.hpp"

#include <algorithm>
#include <optional>

#include "coarse/enrichment/enrichment.hpp"
#include "coarse/enrichment/retained_functions.hpp"
#include "coarse/enrichment/tip_enrichment.hpp"
#include "coarse/model/crack_room.hpp"
#include "coarse/model/forces_on_unknowns.hpp"
#include "coarse/model/loads/held_loads.hpp"
#include "coarse/model/machine_weights.hpp"
#include "coarse/specimen/initial_field.hpp"
#include "coarse/specimen/regions.hpp"
#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// Each load case balances by itself what the supports leave free.
void require_balanced_cases(const Scene& scene) {
    for (const Loads& of_case : scene.loads.cases) {
        Loads loads = scene.loads.main;
        loads.edges = of_case.edges;
        loads.forces = of_case.forces;
        static_cast<void>(analyse_rigid_motions(scene.mesh, loads));
    }
}

/// Standard unknowns of the nodes where loads are applied or that are held.
UnknownSet observed_unknowns(const Scene& scene) {
    UnknownSet observed(scene.enriched.unknowns);
    const auto observe = [&](int node) {
        for (const int component : {0, 1}) observed.insert(scene.enriched.unknown(node, 0, component));
    };
    const auto observe_loads = [&](const Loads& loads) {
        for (const EdgeLoad& load : loads.edges)
            for (const int node : edge_nodes(scene.mesh, load.edge)) observe(node);
        for (const PointForce& load : loads.forces) observe(load.node);
    };
    observe_loads(scene.loads.main);
    for (const Loads& of_case : scene.loads.cases) observe_loads(of_case);
    for (const auto& [where, value] : held_nodes(scene.loads.main, scene.free_motions)) observe(where.first);
    return observed;
}

bool sees_tip_functions(const EnrichedMesh& mesh, int element) {
    return std::ranges::any_of(mesh.elements[at(element)], [&](int node) { return mesh.has_tip_functions(node); });
}

/// Null where the nominal body has the functions of the scene, or its own ones find no room on the mesh.
std::shared_ptr<const EnrichedMesh> functions_of_nominal(const Scene& scene) {
    const std::optional<TipEnrichment> tips = enrichment_of_nominal(scene.input);
    if (!tips || scene.enriched.tips.empty()) return nullptr;
    // Beside no other crack those of the tip's element serve as well: the zone has the same K then.
    if (scene.enriched.tip_functions >= tips->functions && scene.input.cracks.size() == 1) return nullptr;
    try {
        return std::make_shared<const EnrichedMesh>(enrich(scene.mesh, scene.input.cracks, *tips));
    } catch (const CaseError&) {
        return nullptr;
    }
}

BodyMesh with_materials(BodyMesh mesh, const std::vector<RegionSection>& regions) {
    if (!mesh->material.empty()) return mesh;
    std::vector<int> material = materials_of_elements(mesh, regions);
    if (material.empty()) return mesh;
    Mesh known = *mesh;
    known.material = std::move(material);
    return BodyMesh(std::move(known));
}

}  // namespace

MeanDilatation Scene::mean_dilatation(int element) const {
    if (is_nominal && sees_tip_functions(enriched, element)) return MeanDilatation::Nowhere;
    const int material = mesh->material_of(element);
    return stria::mean_dilatation(materials.section(material), materials.elastic(material));
}

Scene make_scene(const Case& input, BodyMesh mesh, int refined) {
    Scene scene;
    scene.input = input;
    scene.materials = Materials(input);
    scene.mesh = with_materials(std::move(mesh), input.regions);
    if (input.initial_stress) check_initial_stress(*input.initial_stress, scene.mesh);
    require_near(scene.mesh, input.cracks);
    scene.enriched = enrich(scene.mesh, input.cracks, choose_enrichment(input));
    scene.nominal = functions_of_nominal(scene);
    if (refined > 0) require_room(scene.mesh, scene.enriched, refined);
    if (refined > 0) require_free_places(scene.mesh, input.boundaries);
    scene.loads = resolve_loads(scene.mesh, input);
    if (refined > 0) require_room_beside_loads(scene.mesh, scene.enriched, scene.loads, refined);
    scene.free_motions = analyse_rigid_motions(scene.mesh, scene.loads.main);
    require_balanced_cases(scene);
    put_loads_on_unknowns(scene);
    if (std::ssize(scene.prescribed) == scene.enriched.unknowns)
        throw CaseError("boundary: the supports hold every node of the mesh, so nothing is left to find; hold less, or "
                        "take smaller elements (mesh.size)");
    if (input.load.control == Control::Displacement && scene.unit_force.isZero(0.0))
        throw CaseError("load.control: \"displacement\" needs a traction, pressure or force other than zero");
    return scene;
}

Scene with_functions_left(Scene scene, const EnrichedMesh& before) {
    scene.enriched = with_functions_left(std::move(scene.enriched), before);
    put_loads_on_unknowns(scene);
    return scene;
}

std::unique_ptr<Scene> nominal_scene(const Scene& scene) {
    if (!scene.nominal) return nullptr;
    auto nominal = std::make_unique<Scene>();
    nominal->input = scene.input;
    nominal->mesh = scene.mesh;
    nominal->materials = scene.materials;
    nominal->loads = scene.loads;
    nominal->free_motions = scene.free_motions;
    nominal->enriched = *scene.nominal;
    nominal->is_nominal = true;
    put_loads_on_unknowns(*nominal);
    return nominal;
}

const EnrichedMesh& nominal_functions(const Scene& scene) { return scene.nominal ? *scene.nominal : scene.enriched; }

void put_loads_on_unknowns(Scene& scene) {
    const ForcesOnUnknowns forces(scene.mesh, scene.enriched);
    scene.unit_force = forces.of(scene.loads.main);
    scene.case_forces.clear();
    for (const Loads& of_case : scene.loads.cases) scene.case_forces.push_back(forces.of(of_case));
    scene.prescribed = prescribed_unknowns(scene.mesh, scene.enriched, scene.loads, scene.free_motions);
    scene.observed = observed_unknowns(scene);
    const std::optional<LoadedBoundary> loaded = loaded_boundary(scene.mesh, scene.input, scene.loads);
    scene.displacement_weights = weights_of_displacement(loaded, scene.mesh, scene.enriched, forces, scene.loads);
    scene.pull = weights_of_reactions(loaded, scene.enriched, scene.prescribed);
}

}  // namespace stria::coarse
