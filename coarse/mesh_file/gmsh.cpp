#include "coarse/mesh_file/gmsh.hpp"

#include <array>
#include <cstdlib>
#include <fmt/format.h>
#include <map>
#include <utility>

#include "coarse/mesh_file/gmsh_input.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

constexpr int point = 15, line = 1, triangle = 2, quadrilateral = 3;

/// Corners of the elements that are read; 0: of no other.
int corners_of(int type) {
    return type == point ? 1 : type == line ? 2 : type == triangle ? 3 : type == quadrilateral ? 4 : 0;
}

class GmshReader {
public:
    GmshReader(std::string text, const std::string& name) : in_(std::move(text), name) {}

    Part read() {
        read_format();
        while (const auto section = in_.next_section()) {
            if (*section == "PhysicalNames")
                read_names();
            else if (*section == "Entities" && fourth_)
                read_entities();
            else if (*section == "Nodes")
                fourth_ ? read_nodes_4() : read_nodes_2();
            else if (*section == "Elements")
                fourth_ ? read_elements_4() : read_elements_2();
            else if (*section == "PartitionedEntities")
                in_.complain("the mesh is partitioned; write it as a whole (Mesh.NbPartitions = 0)");
            else {
                part_.passed_over.insert("$" + *section);
                in_.skip_section(*section);
                continue;
            }
            in_.end_section(*section);
        }
        return std::move(part_);
    }

private:
    using Group = std::pair<int, int>;  // dimension and tag

    void read_format() {
        const auto section = in_.next_section();
        if (section != "MeshFormat") in_.complain("is no mesh of Gmsh: it does not begin with $MeshFormat");
        const double version = in_.text_real();
        const bool binary = in_.text_integer() == 1;
        const int bytes = in_.text_integer();
        fourth_ = version == 4.1;
        if (!fourth_ && version != 2.2)
            in_.complain(fmt::format("is of format {:g}; 4.1 and 2.2 are read (Mesh.MshFileVersion = 4.1)", version));
        if (bytes != 8) in_.complain(fmt::format("has numbers of {} bytes, not 8", bytes));
        if (binary) in_.be_binary();
        part_.format = fmt::format("Gmsh {:.1f}, {}", version, binary ? "binary" : "text");
        in_.end_section("MeshFormat");
    }

    void read_names() {
        const int names = in_.text_integer();
        for (int k = 0; k < names; ++k) {
            const int dimension = in_.text_integer(), tag = in_.text_integer();
            names_[{dimension, tag}] = in_.quoted();
        }
    }

    [[nodiscard]] std::string name_of(int dimension, int tag) const {
        const std::int64_t positive = std::abs(std::int64_t{tag});  // an int has no such of its least value
        const auto found = names_.find({dimension, static_cast<int>(positive)});
        return found != names_.end() ? found->second : std::to_string(positive);
    }

    void read_entities() {
        std::array<std::int64_t, 4> entities{};
        for (std::int64_t& number : entities) number = in_.count();
        for (int dimension = 0; dimension < 4; ++dimension) {
            for (std::int64_t k = 0; k < entities[at(dimension)]; ++k) {
                const int tag = in_.integer();
                for (int c = 0; c < (dimension == 0 ? 3 : 6); ++c) in_.real();
                for (std::int64_t groups = in_.count(); groups > 0; --groups)
                    groups_of_[{dimension, tag}].push_back(name_of(dimension, in_.integer()));
                if (dimension == 0) continue;
                for (std::int64_t bounding = in_.count(); bounding > 0; --bounding) in_.integer();
            }
        }
    }

    void read_nodes_4() {
        const std::int64_t blocks = in_.count();
        for (int k = 0; k < 3; ++k) in_.count();
        for (std::int64_t block = 0; block < blocks; ++block) {
            const int dimension = in_.integer();
            in_.integer();
            const int parameters = in_.integer() != 0 ? dimension : 0;
            const std::int64_t nodes = in_.count();
            const std::size_t first = part_.nodes.size();
            for (std::int64_t k = 0; k < nodes; ++k) part_.nodes.push_back({in_.count(), Eigen::Vector3d::Zero()});
            for (std::size_t k = first; k < part_.nodes.size(); ++k) {
                part_.nodes[k].x = position();
                for (int c = 0; c < parameters; ++c) in_.real();
            }
        }
    }

    void read_nodes_2() {
        const int nodes = in_.text_integer();
        if (binary()) in_.skip_line();
        for (int k = 0; k < nodes; ++k) {
            const Number number = in_.integer();
            part_.nodes.push_back({number, position()});
        }
    }

    Eigen::Vector3d position() {
        const double x = in_.real(), y = in_.real(), z = in_.real();
        return {x, y, z};
    }

    void read_elements_4() {
        const std::int64_t blocks = in_.count();
        for (int k = 0; k < 3; ++k) in_.count();
        for (std::int64_t block = 0; block < blocks; ++block) {
            const int dimension = in_.integer(), entity = in_.integer(), type = in_.integer();
            const std::int64_t elements = in_.count();
            for (std::int64_t k = 0; k < elements; ++k) {
                const Number number = in_.count();
                require_known(type, number);
                std::vector<Number> nodes;
                for (int corner = 0; corner < corners_of(type); ++corner) nodes.push_back(in_.count());
                add(number, std::move(nodes), groups_of_[{dimension, entity}]);
            }
        }
    }

    // Of a binary file elements of one type share a head.
    void read_elements_2() {
        const int elements = in_.text_integer();
        if (binary()) in_.skip_line();
        for (int k = 0; k < elements;) {
            Number number = binary() ? 0 : in_.integer();
            const int type = in_.integer(), same = binary() ? in_.integer() : 1, tags = in_.integer();
            for (int of_them = 0; of_them < same; ++of_them, ++k) {
                if (binary()) number = in_.integer();
                require_known(type, number);
                int group = 0;
                for (int tag = 0; tag < tags; ++tag) (tag == 0 ? group : unused_) = in_.integer();
                std::vector<Number> nodes;
                for (int corner = 0; corner < corners_of(type); ++corner) nodes.push_back(in_.integer());
                const int dimension = type == point ? 0 : type == line ? 1 : 2;
                add(number, std::move(nodes),
                    group != 0 ? std::vector{name_of(dimension, group)} : std::vector<std::string>());
            }
            if (same <= 0) in_.complain(fmt::format("has a head of {} elements", same));
        }
    }

    [[nodiscard]] bool binary() const { return part_.format.ends_with("binary"); }

    void require_known(int type, Number number) const {
        if (corners_of(type) > 0) return;
        if (type >= 4 && type <= 7)
            in_.complain(fmt::format("element {} is three-dimensional; Stria reads plane meshes: mesh the cross "
                                     "section, and save it without volumes",
                                     number));
        if ((type >= 8 && type <= 10) || type == 16 || type == 20 || type == 21)
            in_.complain(fmt::format("element {} is of second or higher order (type {}); Stria reads first order: "
                                     "Mesh.ElementOrder = 1, or gmsh -order 1",
                                     number, type));
        in_.complain(fmt::format("element {} is of type {}; lines (1), triangles (2), quadrilaterals (3) and points "
                                 "(15) are read",
                                 number, type));
    }

    void add(Number number, std::vector<Number> nodes, const std::vector<std::string>& groups) {
        for (const std::string& group : groups) {
            if (nodes.size() == 1) part_.node_sets[group].push_back(nodes[0]);
            if (nodes.size() == 2) part_.edges[group].push_back({nodes[0], nodes[1]});
            if (nodes.size() > 2) part_.regions[group].push_back(part_.faces.size());
        }
        if (nodes.size() > 2) part_.faces.push_back({number, std::move(nodes)});
    }

    GmshInput in_;
    Part part_;
    bool fourth_ = true;
    int unused_ = 0;
    std::map<Group, std::string> names_;                                 // of physical groups
    std::map<std::pair<int, int>, std::vector<std::string>> groups_of_;  // of the entities of format 4.1
};

}  // namespace

Part read_gmsh(std::string text, const std::string& name) { return GmshReader(std::move(text), name).read(); }

}  // namespace stria::coarse
