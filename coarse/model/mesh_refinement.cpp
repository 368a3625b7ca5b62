#include "coarse/model/mesh_refinement.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "common/fem/centre.hpp"
#include "common/geometry/segment.hpp"
#include "common/geometry/vec2.hpp"
#include "common/index.hpp"
#include "common/index_set.hpp"
#include "common/memory.hpp"

namespace stria::coarse {
namespace {
using Edge = std::pair<int, int>;  // nodes, ascending

Edge edge_of(const Mesh& mesh, int element, int k) {
    const auto& nodes = mesh.elements[at(element)];
    return std::minmax(nodes[at(k)], nodes[at((k + 1) % 4)]);
}

bool is_too_large(const Mesh& mesh, int element, const RefinedDisk& disk) {
    if (mesh.level[at(element)] >= disk.levels) return false;
    double longest = 0.0;
    const auto& nodes = mesh.elements[at(element)];
    for (std::size_t k = 0; k < 4; ++k)
        longest = std::max(longest, (mesh.nodes[at(nodes[(k + 1) % 4])] - mesh.nodes[at(nodes[k])]).norm());
    const double half_diagonal = (mesh.nodes[at(nodes[2])] - mesh.nodes[at(nodes[0])]).norm() / 2.0;
    const double distance =
        std::max(0.0, distance_to_segment(centre(mesh, element), disk.from, disk.to) - half_diagonal);
    return distance <= disk.radius && longest > disk.growth * distance;
}

/// What the disks ask for, and larger elements that touch any of it; of those only the ones that may be split at once.
ElementSet elements_to_split(const Mesh& mesh, const std::vector<RefinedDisk>& disks) {
    const auto around = elements_around_nodes(mesh);
    const auto for_larger_neighbours = [&](int element, const auto& visit) {
        for (const int node : mesh.elements[at(element)]) {
            for (const int other : around[at(node)])
                if (mesh.level[at(other)] < mesh.level[at(element)]) visit(other);
        }
    };
    ElementSet asked(mesh.elements.size()), now = asked;
    std::vector<int> waiting;
    for (int e = 0; e < std::ssize(mesh.elements); ++e) {
        if (std::ranges::any_of(disks, [&](const RefinedDisk& disk) { return is_too_large(mesh, e, disk); }))
            waiting.push_back(e);
    }
    while (!waiting.empty()) {
        const int e = waiting.back();
        waiting.pop_back();
        if (asked.contains(e)) continue;
        asked.insert(e);
        now.insert(e);
        for_larger_neighbours(e, [&](int larger) {
            waiting.push_back(larger);
            now.erase(e);
        });
    }
    return now;
}

class Splitter {
public:
    explicit Splitter(Mesh mesh) : mesh_(std::move(mesh)) { mesh_.level.assign(mesh_.elements.size(), 0); }

    /// False where nothing was split.
    bool split(const std::vector<RefinedDisk>& disks) {
        const ElementSet chosen = elements_to_split(mesh_, disks);
        if (chosen.none()) return false;
        const double elements = static_cast<double>(mesh_.elements.size()) + 3.0 * chosen.count();
        require_memory(fmt::format("fine.refine: a mesh of {} elements", elements), elements * bytes_of_element);
        Mesh next = mesh_;
        next.elements.clear();
        next.level.clear();
        next.insert.clear();
        std::vector<int> first(mesh_.elements.size());  // new number of each element, or of its first part
        for (int e = 0; e < std::ssize(mesh_.elements); ++e) {
            first[at(e)] = static_cast<int>(next.elements.size());
            const bool parts = chosen.contains(e);
            if (parts)
                append_parts(e, next);
            else
                next.elements.push_back(mesh_.elements[at(e)]);
            next.level.resize(next.elements.size(), mesh_.level[at(e)] + (parts ? 1 : 0));
            if (mesh_.in_insert(e)) {
                for (auto n = at(first[at(e)]); n < next.elements.size(); ++n)
                    next.insert.push_back(static_cast<int>(n));
            }
        }
        for (auto& [name, edges] : next.boundary) edges = follow(edges, chosen, first);
        mesh_ = std::move(next);
        find_hanging_nodes();
        return true;
    }

    Mesh take() { return std::move(mesh_); }

private:
    // Part k lies at corner k, and its edges k and k - 1 on those of the whole.
    void append_parts(int element, Mesh& next) {
        std::array<int, 4> n = mesh_.elements[at(element)], m{};
        for (int k = 0; k < 4; ++k) m[at(k)] = middle(edge_of(mesh_, element, k), next);
        const auto c = static_cast<int>(next.nodes.size());
        next.nodes.push_back(centre(mesh_, element));
        next.elements.push_back({n[0], m[0], c, m[3]});
        next.elements.push_back({m[0], n[1], m[1], c});
        next.elements.push_back({c, m[1], n[2], m[2]});
        next.elements.push_back({m[3], c, m[2], n[3]});
    }

    int middle(const Edge& edge, Mesh& next) {
        const auto [found, added] = middle_.try_emplace(edge, static_cast<int>(next.nodes.size()));
        if (added) next.nodes.push_back((next.nodes[at(edge.first)] + next.nodes[at(edge.second)]) / 2.0);
        return found->second;
    }

    static std::vector<BoundaryEdge> follow(const std::vector<BoundaryEdge>& edges, const ElementSet& chosen,
                                            const std::vector<int>& first) {
        std::vector<BoundaryEdge> result;
        for (const auto& [element, edge] : edges) {
            const int start = first[at(element)];
            if (!chosen.contains(element)) {
                result.push_back({start, edge});
                continue;
            }
            result.push_back({start + edge, edge});
            result.push_back({start + (edge + 1) % 4, edge});
        }
        return result;
    }

    // An edge with a middle that still bounds an element is that element's undivided one.
    void find_hanging_nodes() {
        mesh_.hanging.clear();
        for (int e = 0; e < std::ssize(mesh_.elements); ++e) {
            for (int k = 0; k < 4; ++k) {
                const Edge edge = edge_of(mesh_, e, k);
                const auto middle = middle_.find(edge);
                if (middle != middle_.end()) mesh_.hanging.push_back({middle->second, {edge.first, edge.second}, e});
            }
        }
        std::ranges::sort(mesh_.hanging, {}, &HangingNode::node);
    }

    Mesh mesh_;
    std::map<Edge, int> middle_;
};

}  // namespace

Mesh refine(Mesh mesh, const std::vector<RefinedDisk>& disks) {
    Splitter splitter(std::move(mesh));
    while (splitter.split(disks)) {
    }
    return splitter.take();
}

}  // namespace stria::coarse
