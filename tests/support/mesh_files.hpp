// Meshes as files, for tests.
#pragma once

#include <fmt/format.h>

#include <fstream>
#include <string>

#include "common/fem/mesh.hpp"
#include "common/index.hpp"
#include "tests/support/folders.hpp"

namespace stria::test {

inline std::string mesh_data(const std::string& name) {
    return std::string(source_folder) + "/tests/data/meshes/" + name;
}

inline void write_file(const std::string& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

/// Format 2.2; boundaries are physical curves, every coordinate keeps its last digit.
inline std::string msh_text(const Mesh& mesh) {
    std::string names, nodes, elements;
    int curves = 0, number = 0;
    for (const auto& [name, edges] : mesh.boundary) {
        names += fmt::format("1 {} \"{}\"\n", ++curves, name);
        for (const auto& [element, edge] : edges) {
            const auto& n = mesh.elements[at(element)];
            elements += fmt::format("{} 1 2 {} {} {} {}\n", ++number, curves, curves, n[at(edge)] + 1,
                                    n[at((edge + 1) % 4)] + 1);
        }
    }
    for (const auto& n : mesh.elements)
        elements += fmt::format("{} 3 2 1 1 {} {} {} {}\n", ++number, n[0] + 1, n[1] + 1, n[2] + 1, n[3] + 1);
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
        nodes += fmt::format("{} {} {} 0\n", n + 1, mesh.nodes[n].x(), mesh.nodes[n].y());
    return fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n{}\n{}2 1 \"body\"\n$EndPhysicalNames\n"
                       "$Nodes\n{}\n{}$EndNodes\n$Elements\n{}\n{}$EndElements\n",
                       curves + 1, names, mesh.nodes.size(), nodes, number, elements);
}

}  // namespace stria::test
