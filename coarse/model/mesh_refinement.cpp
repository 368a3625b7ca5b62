#include "coarse/model/mesh_refinement.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <set>

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
    if (mesh.level_of(element) >= disk.levels) return false;
    const auto& nodes = mesh.elements[at(element)];
    const double to_centre = distance_to_segment(centre(mesh, element), disk.from, disk.to);
    const double distance = std::max(0.0, to_centre - diagonal(mesh, element) / 2.0);
    if (distance > disk.radius) return false;
    double longest = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
        longest = std::max(longest, (mesh.nodes[at(nodes[(k + 1) % 4])] - mesh.nodes[at(nodes[k])]).norm());
    return longest > disk.growth * distance;
}

/// All elements that the disks may ask for: an element is as far off as half of its diagonal about its centre.
std::vector<int> elements_near(const BodyMesh& mesh, const std::vector<RefinedDisk>& disks) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const RefinedDisk& disk : disks) {
        const Vec2 reach = Vec2::Constant(disk.radius + mesh.longest_edge());
        boxes.emplace_back(disk.from.cwiseMin(disk.to) - reach, disk.from.cwiseMax(disk.to) + reach);
    }
    return mesh.elements_near(boxes);
}

/// What disks ask of elements, and what lets these be split. All must outlive it.
class Choice {
public:
    Choice(const Mesh& mesh, const IndexLists& around, const std::vector<RefinedDisk>& disks, const ElementSet& never)
        : mesh_(mesh), around_(around), disks_(disks), never_(never) {}

    [[nodiscard]] bool asks_for(int element) const {
        return std::ranges::any_of(disks_, [&](const auto& disk) { return is_too_large(mesh_, element, disk); }) &&
               !stays_whole(element);
    }

    /// Some of the candidates, and larger elements that touch any of these; of those only the ones that may be split at
    /// once.
    [[nodiscard]] std::vector<int> now(const std::vector<int>& candidates) const {
        std::set<int> asked, now;
        std::vector<int> waiting;
        std::ranges::copy_if(candidates, std::back_inserter(waiting), [&](int e) { return asks_for(e); });
        while (!waiting.empty()) {
            const int e = waiting.back();
            waiting.pop_back();
            if (!asked.insert(e).second) continue;
            const std::vector<int> larger = larger_neighbours(e);
            if (larger.empty()) now.insert(e);
            waiting.insert(waiting.end(), larger.begin(), larger.end());
        }
        return {now.begin(), now.end()};
    }

private:
    /// It is to, or a larger neighbour that stays whole does not let it be split.
    [[nodiscard]] bool stays_whole(int element) const {
        return never_.holds(element) ||
               std::ranges::any_of(larger_neighbours(element), [&](int larger) { return stays_whole(larger); });
    }

    /// That share a corner. One that has never been split has none.
    [[nodiscard]] std::vector<int> larger_neighbours(int element) const {
        std::vector<int> larger;
        if (mesh_.level_of(element) == 0) return larger;
        for (const int node : mesh_.elements[at(element)])
            for (const int other : around_[at(node)])
                if (mesh_.level_of(other) < mesh_.level_of(element)) larger.push_back(other);
        return larger;
    }

    const Mesh& mesh_;
    const IndexLists& around_;
    const std::vector<RefinedDisk>& disks_;
    const ElementSet& never_;
};

Mesh with_levels(Mesh mesh) {
    mesh.level.resize(mesh.elements.size(), 0);
    return mesh;
}

class Splitter {
public:
    explicit Splitter(Mesh mesh) : mesh_(with_levels(std::move(mesh))) {
        for (const HangingNode& hanging : mesh_.hanging)
            middle_[std::minmax(hanging.ends[0], hanging.ends[1])] = hanging.node;
    }

    [[nodiscard]] const Mesh& mesh() const { return mesh_; }

    /// Elements that share no corner with a larger one. Returns the element of each part that is new.
    std::vector<int> split(const std::vector<int>& elements) {
        const double after = static_cast<double>(mesh_.elements.size() + 3 * elements.size());
        require_memory(fmt::format("fine.refine: a mesh of {} elements", after), after * bytes_of_element);
        std::map<int, int> second;  // by element: its second part
        std::vector<int> part_of;
        for (const int e : elements) {
            second[e] = static_cast<int>(mesh_.elements.size());
            append_parts(e);
            part_of.insert(part_of.end(), {e, e, e});
            follow(mesh_.insert, e, second[e]);
            for (auto& [name, group] : mesh_.groups) follow(group, e, second[e]);
        }
        for (auto& [name, edges] : mesh_.boundary) edges = follow(edges, second);
        find_hanging_nodes();
        return part_of;
    }

    Mesh take() { return std::move(mesh_); }

private:
    // Part k lies at corner k, and its edges k and k - 1 on those of the whole.
    void append_parts(int element) {
        std::array<int, 4> n = mesh_.elements[at(element)], m{};
        for (int k = 0; k < 4; ++k) m[at(k)] = middle(edge_of(mesh_, element, k));
        const auto c = static_cast<int>(mesh_.nodes.size());
        mesh_.nodes.push_back(centre(mesh_, element));
        mesh_.elements[at(element)] = {n[0], m[0], c, m[3]};
        mesh_.elements.push_back({m[0], n[1], m[1], c});
        mesh_.elements.push_back({c, m[1], n[2], m[2]});
        mesh_.elements.push_back({m[3], c, m[2], n[3]});
        mesh_.level.resize(mesh_.elements.size(), ++mesh_.level[at(element)]);
        if (!mesh_.material.empty()) mesh_.material.resize(mesh_.elements.size(), mesh_.material_of(element));
    }

    int middle(const Edge& edge) {
        const auto [found, added] = middle_.try_emplace(edge, static_cast<int>(mesh_.nodes.size()));
        if (!added) return found->second;
        mesh_.nodes.push_back((mesh_.nodes[at(edge.first)] + mesh_.nodes[at(edge.second)]) / 2.0);
        // What is held at both ends of an edge is held along it. The new node is the last one.
        for (auto& [name, set] : mesh_.node_sets)
            if (std::ranges::binary_search(set, edge.first) && std::ranges::binary_search(set, edge.second))
                set.push_back(found->second);
        return found->second;
    }

    // The three new parts stay in what the element is in: they come last, so the list stays ascending.
    static void follow(std::vector<int>& elements, int element, int second) {
        if (std::ranges::binary_search(elements, element))
            elements.insert(elements.end(), {second, second + 1, second + 2});
    }

    static std::vector<BoundaryEdge> follow(const std::vector<BoundaryEdge>& edges, const std::map<int, int>& second) {
        std::vector<BoundaryEdge> result;
        for (const auto& [element, edge] : edges) {
            const auto parts = second.find(element);
            if (parts == second.end()) {
                result.push_back({element, edge});
                continue;
            }
            for (const int part : {edge, (edge + 1) % 4})
                result.push_back({part == 0 ? element : parts->second + part - 1, edge});
        }
        return result;
    }

    // An edge with a middle that still bounds an element is that element's undivided one.
    void find_hanging_nodes() {
        mesh_.hanging.clear();
        NodeSet ends(mesh_.nodes.size());  // of edges with a middle
        for (const auto& [edge, middle] : middle_)
            for (const int end : {edge.first, edge.second}) ends.insert(end);
        for (int e = 0; e < std::ssize(mesh_.elements); ++e) {
            for (int k = 0; k < 4; ++k) {
                const Edge edge = edge_of(mesh_, e, k);
                if (!ends.contains(edge.first) || !ends.contains(edge.second)) continue;
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

// What no disk reaches asks for nothing, and neither do its parts.
RefinedMesh refine(const BodyMesh& mesh, const std::vector<RefinedDisk>& disks, const ElementSet& never) {
    Splitter splitter(*mesh);
    RefinedMesh refined;
    refined.part_of.assign(splitter.mesh().elements.size(), -1);
    std::vector<int> candidates = elements_near(mesh, disks);
    IndexLists around = mesh.around();
    while (true) {
        const std::vector<int> chosen = Choice(splitter.mesh(), around, disks, never).now(candidates);
        if (chosen.empty()) break;
        for (const int e : chosen)
            if (refined.part_of[at(e)] < 0) refined.part_of[at(e)] = e;
        for (const int e : splitter.split(chosen)) {
            candidates.push_back(static_cast<int>(refined.part_of.size()));
            refined.part_of.push_back(refined.part_of[at(e)]);
        }
        refined.splits.push_back(chosen);
        around = elements_around_nodes(splitter.mesh());
    }
    refined.mesh = splitter.take();
    return refined;
}

bool asks_for_more(const BodyMesh& mesh, const std::vector<RefinedDisk>& disks, const ElementSet& never) {
    const Choice choice(*mesh, mesh.around(), disks, never);
    return std::ranges::any_of(elements_near(mesh, disks), [&](int e) { return choice.asks_for(e); });
}

Mesh split_again(Mesh mesh, const MeshSplits& splits) {
    Splitter splitter(std::move(mesh));
    for (const std::vector<int>& elements : splits) splitter.split(elements);
    return splitter.take();
}

}  // namespace stria::coarse
