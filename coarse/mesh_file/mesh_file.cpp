#include "coarse/mesh_file/mesh_file.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "coarse/mesh_file/abaqus.hpp"
#include "coarse/mesh_file/faces.hpp"
#include "coarse/mesh_file/gmsh.hpp"
#include "coarse/mesh_file/quadrilaterals.hpp"
#include "coarse/mesh_file/soundness.hpp"
#include "common/error.hpp"
#include "common/index.hpp"
#include "common/memory.hpp"

namespace stria::coarse {
namespace {

std::string name_of(const std::filesystem::path& path) { return "mesh.file: " + path.filename().string(); }

std::string text_of_mesh(const std::filesystem::path& path) {
    std::error_code problem;
    const bool regular = std::filesystem::is_regular_file(path, problem);
    const double bytes = regular ? static_cast<double>(std::filesystem::file_size(path, problem)) : 0.0;
    require_memory(fmt::format("{}: a file of {} bytes", name_of(path), bytes), 10.0 * bytes);
    std::ifstream file(path, std::ios::binary);
    if (!regular || !file) throw CaseError(fmt::format("mesh.file: {}: cannot be read, no such file", path.string()));
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

Part part_in(const std::filesystem::path& path) {
    const std::string kind = path.extension().string();
    if (kind == ".msh") return read_gmsh(text_of_mesh(path), name_of(path));
    if (kind == ".inp") return read_abaqus(text_of_mesh(path), name_of(path));
    throw CaseError(fmt::format("{}: a mesh is a .msh of Gmsh, or an .inp of Abaqus or CalculiX", name_of(path)));
}

Faces body_in(const Part& part, const std::string& name) {
    const Faces faces = faces_of(part, name);
    require_soundness(faces, name);
    require_memory(fmt::format("{}: a mesh of {} elements", name, faces.faces.size()),
                   static_cast<double>(faces.faces.size()) * bytes_of_element);
    return faces;
}

/// Gives the edges of a body their names.
class Naming {
public:
    Naming(const Part& part, const Faces& faces, const std::string& name) : part_(part), faces_(faces), name_(name) {}

    std::map<std::string, std::set<NodePair>> boundaries() {
        for (const auto& [group, edges] : part_.edges)
            for (const FileEdge& edge : edges) name_edge(group, edge);
        for (const auto& [group, numbers] : part_.node_sets)
            if (!part_.edges.contains(group)) name_edges_between(group, numbers);
        std::set<NodePair> named;
        for (const auto& [group, edges] : named_) named.insert(edges.begin(), edges.end());
        for (const Edge& edge : faces_.edges)
            if (edge.is_boundary() && !named.contains(edge.nodes)) named_[unnamed_edges].insert(edge.nodes);
        return named_;
    }

    /// The nodes of each set that are of no edge that it names. Lines or surfaces of the same name are not of the set.
    [[nodiscard]] std::map<std::string, std::vector<int>> node_sets() const {
        std::map<std::string, std::vector<int>> sets;
        for (const auto& [group, numbers] : part_.node_sets) {
            if (part_.edges.contains(group)) continue;
            std::set<int> nodes = nodes_of(numbers);
            if (const auto named = named_.find(group); named != named_.end())
                for (const auto& [from, to] : named->second)
                    for (const int end : {from, to}) nodes.erase(end);
            if (!nodes.empty()) sets[group].assign(nodes.begin(), nodes.end());
        }
        return sets;
    }

private:
    /// Lines inside of the body, along an interface, bound nothing.
    void name_edge(const std::string& group, const FileEdge& edge) {
        const auto from = faces_.node_of.find(edge[0]), to = faces_.node_of.find(edge[1]);
        const bool known = from != faces_.node_of.end() && to != faces_.node_of.end();
        const Edge* found = known ? faces_.find_edge(std::minmax(from->second, to->second)) : nullptr;
        if (found == nullptr)
            throw CaseError(fmt::format("{}: group \"{}\": no element has the edge between the nodes {} and {}", name_,
                                        group, edge[0], edge[1]));
        if (found->is_boundary()) named_[group].insert(found->nodes);
    }

    [[nodiscard]] std::set<int> nodes_of(const std::vector<Number>& numbers) const {
        std::set<int> nodes;
        for (const Number number : numbers)
            if (const auto found = faces_.node_of.find(number); found != faces_.node_of.end())
                nodes.insert(found->second);
        return nodes;
    }

    void name_edges_between(const std::string& group, const std::vector<Number>& numbers) {
        const std::set<int> nodes = nodes_of(numbers);
        for (const Edge& edge : faces_.edges)
            if (edge.is_boundary() && nodes.contains(edge.nodes.first) && nodes.contains(edge.nodes.second))
                named_[group].insert(edge.nodes);
    }

    const Part& part_;
    const Faces& faces_;
    const std::string& name_;
    std::map<std::string, std::set<NodePair>> named_;
};

Mesh mesh_of(const Part& part, const Faces& faces, const std::string& name) {
    const Quadrilaterals quadrilaterals(faces);
    Mesh mesh = quadrilaterals.mesh();
    Naming naming(part, faces, name);
    for (const auto& [group, edges] : naming.boundaries())
        for (const NodePair& edge : edges)
            for (const BoundaryEdge& part_of_it : quadrilaterals.parts(faces.find_edge(edge)->sides.front()))
                mesh.boundary[group].push_back(part_of_it);
    mesh.node_sets = naming.node_sets();
    for (const auto& [group, members] : faces.regions)
        for (const int face : members)
            for (const int element : quadrilaterals.parts(face)) mesh.groups[group].push_back(element);
    return mesh;
}

}  // namespace

Mesh read_mesh_file(const std::string& path) {
    const Part part = part_in(path);
    return mesh_of(part, body_in(part, name_of(path)), name_of(path));
}

std::vector<std::string> describe_mesh_file(const std::string& path) {
    const Part part = part_in(path);
    const Faces faces = body_in(part, name_of(path));
    const auto triangles = std::ranges::count_if(faces.faces, [](const Face& face) { return face.nodes.size() == 3; });
    const std::ptrdiff_t others = std::ssize(faces.faces) - triangles;
    std::vector<std::string> lines;
    lines.push_back(fmt::format("{}: {}; {} quadrilaterals, {} triangles{}", name_of(path), part.format, others,
                                triangles, triangles > 0 ? ", all split into quadrilaterals" : ""));
    if (faces.turned > 0) lines.push_back(fmt::format("{} elements ran clockwise and were turned", faces.turned));
    if (faces.unused_nodes > 0) lines.push_back(fmt::format("{} nodes are of no element", faces.unused_nodes));
    if (!part.passed_over.empty()) lines.push_back(fmt::format("passed over: {}", fmt::join(part.passed_over, ", ")));
    const Mesh mesh = mesh_of(part, faces, name_of(path));
    std::vector<std::string> names;
    for (const auto& [group, edges] : mesh.boundary) names.push_back(fmt::format("{} ({} edges)", group, edges.size()));
    for (const auto& [group, nodes] : mesh.node_sets)
        names.push_back(
            fmt::format("{} ({}{} nodes)", group, mesh.boundary.contains(group) ? "and " : "", nodes.size()));
    lines.push_back(fmt::format("boundaries: {}", fmt::join(names, ", ")));
    names.clear();
    for (const auto& [group, members] : mesh.groups)
        names.push_back(fmt::format("{} ({} elements)", group, members.size()));
    if (!names.empty()) lines.push_back(fmt::format("groups of elements: {}", fmt::join(names, ", ")));
    return lines;
}

}  // namespace stria::coarse
