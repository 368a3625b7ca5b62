// What a mesh file says, before it is judged: nodes, edges and faces by the numbers that the file gives them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace stria::coarse {

/// Of a node or an element in the file.
using Number = std::int64_t;

struct FileNode {
    Number number;
    Eigen::Vector3d x;
};

/// A triangle or a quadrilateral, either way round.
struct FileFace {
    Number number;
    std::vector<Number> nodes;
};

using FileEdge = std::array<Number, 2>;

struct Part {
    std::string format;  // "Gmsh 4.1, binary"
    std::vector<FileNode> nodes;
    std::vector<FileFace> faces;
    std::map<std::string, std::vector<std::size_t>> regions;  // named faces, by their places in `faces`
    std::map<std::string, std::vector<FileEdge>> edges;
    std::map<std::string, std::vector<Number>> node_sets;
    std::set<std::string> passed_over;  // what the file says beside a mesh: sections or keywords
};

}  // namespace stria::coarse
