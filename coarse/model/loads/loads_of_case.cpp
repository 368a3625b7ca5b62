#include "coarse/model/loads/loads_of_case.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "coarse/load/case_histories.hpp"
#include "common/case/loads/load_case_checks.hpp"
#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

/// Places along an edge need one direction.
void require_straight(const Mesh& mesh, const std::vector<BoundaryEdge>& edges, const std::string& key) {
    if (edges.empty()) throw CaseError(key + ".travelling: a set of nodes without edges bears no load");
    const Vec2 normal = edge_geometry(mesh, edges.front()).inward_normal();
    for (const BoundaryEdge& edge : edges)
        if ((edge_geometry(mesh, edge).inward_normal() - normal).norm() > 1e-6)
            throw CaseError(key + ".travelling: the edge is not straight");
}

/// One for each position.
void add_travelling(const Mesh& mesh, const BoundarySection& section, const std::string& key, int positions,
                    std::vector<Loads>& cases) {
    const TravellingPressure& travelling = *section.travelling;
    const Place place = place_of(mesh, section, key);
    require_straight(mesh, place.edges, key);
    for (int k = 0; k < positions; ++k) {
        const double middle = std::lerp(travelling.from, travelling.to, static_cast<double>(k) / (positions - 1));
        Traction traction{.origin = section.origin};
        traction.hertz = {travelling.p0, travelling.half_width, middle, travelling.friction};
        Loads& loads = cases.emplace_back();
        for (const BoundaryEdge& edge : place.edges) loads.edges.push_back({edge, traction});
    }
}

/// What load cases move is held where they are without load.
void hold_what_moves(LoadsOfCase& loads) {
    std::vector<PrescribedDisplacement>& held = loads.main.displacements;
    const auto place = [](const PrescribedDisplacement& d) { return std::pair(d.node, d.component); };
    for (const Loads& of_case : loads.cases) {
        for (const PrescribedDisplacement& d : of_case.displacements) {
            const auto found = std::ranges::lower_bound(held, place(d), {}, place);
            if (found == held.end() || place(*found) != place(d)) held.insert(found, {d.node, d.component, 0.0});
        }
    }
}

struct Nearest {
    const Mesh& mesh;
    const Vec2& x;
    double distance = std::numeric_limits<double>::infinity();  // mm
    void look_at(int node) { distance = std::min(distance, (mesh.nodes[at(node)] - x).norm()); }
};

void for_all(const LoadsOfCase& loads, auto&& look) {
    look(loads.main);
    for (const Loads& of_case : loads.cases) look(of_case);
}

}  // namespace

double distance_to_loads(const Mesh& mesh, const LoadsOfCase& loads, const Vec2& x) {
    Nearest nearest{mesh, x};
    for_all(loads, [&](const Loads& some) {
        for (const PointForce& load : some.forces) nearest.look_at(load.node);
        for (const PrescribedDisplacement& held : some.displacements) nearest.look_at(held.node);
    });
    return nearest.distance;
}

double distance_to_points(const Mesh& mesh, const LoadsOfCase& loads, const Vec2& x) {
    Nearest nearest{mesh, x};
    for_all(loads, [&](const Loads& some) {
        for (const int node : some.points) nearest.look_at(node);
    });
    return nearest.distance;
}

LoadsOfCase resolve_loads(const Mesh& mesh, const Case& input) {
    LoadsOfCase loads{resolve_boundaries(mesh, input.boundaries, is_of_main_load), {}};
    for (const LoadCaseSection& load_case : input.load_cases)
        loads.cases.push_back(resolve_boundaries(mesh, input.boundaries, [&](const BoundarySection& section) {
            return section.load_case == load_case.name;
        }));
    for (std::size_t k = 0; k < input.boundaries.size(); ++k)
        if (input.boundaries[k].travelling)
            add_travelling(mesh, input.boundaries[k], key_of(k), positions_of_travel(input.load), loads.cases);
    hold_what_moves(loads);
    return loads;
}

namespace {

/// What unit loads put on a boundary.
struct LoadThere {
    Vec2 resultant = Vec2::Zero();
    double magnitude = 0.0;  // sum of the norms of its forces

    /// Pure bending, or a pressure all around a hole.
    [[nodiscard]] bool balanced() const { return resultant.norm() <= 1e-9 * magnitude; }
};

/// Which loads act at a place.
class ActsAt {
public:
    explicit ActsAt(const Place& place) : nodes_(place.nodes.begin(), place.nodes.end()) {
        for (const BoundaryEdge& edge : place.edges) edges_.insert({edge.element, edge.edge});
    }
    bool operator()(const EdgeLoad& load) const { return edges_.contains({load.edge.element, load.edge.edge}); }
    bool operator()(const PointForce& load) const { return nodes_.contains(load.node); }

private:
    std::set<std::pair<int, int>> edges_;
    std::set<int> nodes_;
};

Loads loads_that(const ActsAt& there, const Loads& loads) {
    Loads some;
    std::ranges::copy_if(loads.edges, std::back_inserter(some.edges), there);
    std::ranges::copy_if(loads.forces, std::back_inserter(some.forces), there);
    return some;
}

LoadThere load_that(const ActsAt& there, const Mesh& mesh, const Loads& loads) {
    LoadThere sum;
    for (const AppliedForce& applied : applied_forces(mesh, loads_that(there, loads))) {
        sum.resultant += applied.force;
        sum.magnitude += applied.force.norm();
    }
    if (sum.balanced()) sum.resultant.setZero();
    return sum;
}

std::optional<std::size_t> first_loaded(const Mesh& mesh, const std::vector<BoundarySection>& sections,
                                        const std::function<bool(const BoundarySection&)>& wanted) {
    const auto pushes = [](const AppliedForce& applied) { return !applied.force.isZero(0.0); };
    for (std::size_t k = 0; k < sections.size(); ++k)
        if (wanted(sections[k]) &&
            (!displacement_of(sections[k]).isZero(0.0) ||
             std::ranges::any_of(applied_forces(mesh, resolve_boundaries(mesh, {sections[k]})), pushes)))
            return k;
    return std::nullopt;
}

/// What a section of the same unit load prescribes on the same boundary: its reaction is a load, whatever acts besides.
Vec2 displacement_there(const std::vector<BoundarySection>& sections, const BoundarySection& first) {
    for (const BoundarySection& section : sections)
        if (section.on == first.on && section.at == first.at && section.load_case == first.load_case &&
            !displacement_of(section).isZero(0.0))
            return displacement_of(section);
    return Vec2::Zero();
}

/// Of the boundary's outward normals, each as long as its edge; zero all around a hole.
Vec2 outward(const Mesh& mesh, const std::vector<BoundaryEdge>& edges) {
    Vec2 sum = Vec2::Zero();
    double length = 0.0;
    for (const BoundaryEdge& edge : edges) {
        const EdgeGeometry geometry = edge_geometry(mesh, edge);
        sum -= geometry.length() * geometry.inward_normal();
        length += geometry.length();
    }
    return sum.norm() > 1e-9 * length ? sum.normalized() : Vec2::Zero();
}

/// What `loads`, those of one load case or of [load], pull at any boundary along a direction: an edge may be listed in
/// parts.
double pulls_along(const Mesh& mesh, const std::vector<BoundarySection>& sections, Loads loads,
                   const std::optional<std::string>& load_case, const Vec2& direction) {
    double sum = 0.0;
    for (std::size_t k = 0; k < sections.size(); ++k) {
        if (sections[k].load_case != load_case || sections[k].travelling) continue;
        const ActsAt there(place_of(mesh, sections[k], key_of(k)));
        sum += std::max(0.0, load_that(there, mesh, loads).resultant.dot(direction));
        std::erase_if(loads.edges, there);  // counted
        std::erase_if(loads.forces, there);
    }
    return sum;
}

}  // namespace

std::optional<LoadedBoundary> loaded_boundary(const Mesh& mesh, const Case& input, const LoadsOfCase& all) {
    const std::vector<BoundarySection>& sections = input.boundaries;
    std::optional<std::size_t> first = first_loaded(mesh, sections, is_of_main_load);
    if (!first)
        first =
            first_loaded(mesh, sections, [](const BoundarySection& section) { return section.load_case.has_value(); });
    if (!first) return std::nullopt;
    const BoundarySection& section = sections[*first];
    const Vec2 displacement = displacement_there(sections, section);
    const Place place = place_of(mesh, section, key_of(*first));
    const ActsAt acts_there(place);
    LoadedBoundary loaded{.name = section.on, .edges = place.edges, .nodes = place.nodes};
    loaded.resultant = load_that(acts_there, mesh, all.main).resultant;
    loaded.by_force = displacement.isZero(0.0);
    for (const Loads& loads : all.cases) loaded.in_cases.push_back(load_that(acts_there, mesh, loads).resultant);
    if (section.load_case) {
        const auto own = std::ranges::find(input.load_cases, *section.load_case, &LoadCaseSection::name);
        loaded.load_case = at(own - input.load_cases.begin());
    }
    const Loads& own = all.of(loaded.load_case);
    const LoadThere there = load_that(acts_there, mesh, own);
    loaded.acting = loads_that(acts_there, own);
    loaded.force = there.resultant.norm();
    if (!loaded.by_force)
        loaded.direction = displacement.normalized();
    else
        loaded.direction = there.balanced() ? outward(mesh, place.edges) : there.resultant.normalized();
    loaded.pull = pulls_along(mesh, sections, own, section.load_case, loaded.direction);
    return loaded;
}

}  // namespace stria::coarse
