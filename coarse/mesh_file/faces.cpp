#include "coarse/mesh_file/faces.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <utility>

#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

class Reader {
public:
    Reader(const Part& part, const std::string& name) : part_(part), name_(name) {}

    Faces read() {
        number_nodes();
        if (part_.faces.empty())
            complain("has no triangle and no quadrilateral; where groups are named, Gmsh saves only what is in one: "
                     "name the surface too");
        for (std::size_t k = 0; k < part_.faces.size(); ++k) add_face(k);
        name_regions();
        drop_unused_nodes();
        gather_edges();
        return std::move(faces_);
    }

private:
    [[noreturn]] void complain(const std::string& what) const { throw CaseError(name_ + ": " + what); }

    void number_nodes() {
        for (const auto& [number, x] : part_.nodes) {
            if (!x.allFinite()) complain(fmt::format("node {} has a coordinate that is no number", number));
            if (!place_.emplace(number, std::ssize(place_)).second)
                complain(fmt::format("node {} is given twice", number));
            const double height = part_.nodes.front().x.z();
            if (std::abs(x.z() - height) > 1e-9 * (1.0 + x.lpNorm<Eigen::Infinity>()))
                complain(fmt::format("node {} lies at z = {:g}, the first one at z = {:g}; the mesh must be plane, "
                                     "along x and y",
                                     number, x.z(), height));
        }
    }

    void add_face(std::size_t index) {
        const auto& [number, nodes] = part_.faces[index];
        Face face{number, {}};
        for (const Number node : nodes) {
            const auto found = place_.find(node);
            if (found == place_.end())
                complain(fmt::format("element {} has the node {}, which the file does not give", number, node));
            const int n = static_cast<int>(found->second);
            if (std::ranges::find(face.nodes, n) == face.nodes.end()) face.nodes.push_back(n);  // a triangle, folded
        }
        if (face.nodes.size() < 3) complain(fmt::format("element {} has no area: its nodes are {}", number, nodes));
        if (signed_area(face) < 0.0) {
            std::ranges::reverse(face.nodes);
            ++faces_.turned;
        }
        require_convex(face);
        std::array<int, 4> key = {-1, -1, -1, -1};
        std::ranges::copy(face.nodes, key.begin());
        std::ranges::sort(key);
        const auto [known, is_new] = known_.try_emplace(key, static_cast<int>(faces_.faces.size()));
        if (is_new) faces_.faces.push_back(std::move(face));  // format 2.2 has it once for each group that it is in
        face_of_.push_back(known->second);
    }

    [[nodiscard]] Vec2 x_of(int node) const { return part_.nodes[at(node)].x.head<2>(); }

    [[nodiscard]] double signed_area(const Face& face) const {
        double twice = 0.0;
        for (std::size_t k = 1; k + 1 < face.nodes.size(); ++k) {
            const Vec2 a = x_of(face.nodes[k]) - x_of(face.nodes[0]), b = x_of(face.nodes[k + 1]) - x_of(face.nodes[0]);
            twice += cross(a, b);
        }
        return 0.5 * twice;
    }

    // The Jacobian of a quadrilateral is smallest at a corner.
    void require_convex(const Face& face) const {
        constexpr double flat = 1e-3;  // sine
        const std::size_t n = face.nodes.size();
        for (std::size_t k = 0; k < n; ++k) {
            const Vec2 here = x_of(face.nodes[k]);
            const Vec2 in = here - x_of(face.nodes[(k + n - 1) % n]), out = x_of(face.nodes[(k + 1) % n]) - here;
            const double turn = cross(in, out);
            if (turn > flat * in.norm() * out.norm()) continue;
            complain(fmt::format("element {} at ({:.6g}, {:.6g}) {} its node {}; the mesh needs convex elements there",
                                 face.number, here.x(), here.y(),
                                 turn < 0.0 ? "has a negative Jacobian at" : "is flat at",
                                 part_.nodes[at(face.nodes[k])].number));
        }
    }

    void name_regions() {
        for (const auto& [region, members] : part_.regions) {
            std::vector<int>& faces = faces_.regions[region];
            for (const std::size_t member : members) faces.push_back(face_of_[member]);
            std::ranges::sort(faces);
            faces.erase(std::ranges::unique(faces).begin(), faces.end());
        }
    }

    void drop_unused_nodes() {
        std::vector<int> kept(part_.nodes.size(), -1);
        for (const Face& face : faces_.faces)
            for (const int node : face.nodes) kept[at(node)] = 0;
        for (std::size_t n = 0; n < kept.size(); ++n) {
            if (kept[n] < 0) continue;
            kept[n] = static_cast<int>(faces_.nodes.size());
            faces_.node_of[part_.nodes[n].number] = kept[n];
            faces_.nodes.push_back(x_of(static_cast<int>(n)));
            faces_.numbers.push_back(part_.nodes[n].number);
        }
        faces_.unused_nodes = static_cast<int>(part_.nodes.size() - faces_.nodes.size());
        for (Face& face : faces_.faces)
            for (int& node : face.nodes) node = kept[at(node)];
    }

    void gather_edges() {
        std::vector<std::pair<NodePair, FaceEdge>> all;
        for (int f = 0; f < std::ssize(faces_.faces); ++f) {
            const std::vector<int>& nodes = faces_.faces[at(f)].nodes;
            for (std::size_t k = 0; k < nodes.size(); ++k)
                all.push_back({std::minmax(nodes[k], nodes[(k + 1) % nodes.size()]), {f, static_cast<int>(k)}});
        }
        std::ranges::stable_sort(all, {}, &std::pair<NodePair, FaceEdge>::first);
        for (const auto& [nodes, side] : all) {
            if (faces_.edges.empty() || faces_.edges.back().nodes != nodes) faces_.edges.push_back({nodes, {}});
            faces_.edges.back().sides.push_back(side);
        }
    }

    const Part& part_;
    const std::string& name_;
    Faces faces_;
    std::unordered_map<Number, std::ptrdiff_t> place_;  // of each node in the part
    std::map<std::array<int, 4>, int> known_;           // faces by their nodes, ascending behind a -1 for a triangle
    std::vector<int> face_of_;                          // per face of the part
};

}  // namespace

const Edge* Faces::find_edge(const NodePair& ends) const {
    const auto found = std::ranges::lower_bound(edges, ends, {}, &Edge::nodes);
    return found != edges.end() && found->nodes == ends ? &*found : nullptr;
}

Faces faces_of(const Part& part, const std::string& name) { return Reader(part, name).read(); }

}  // namespace stria::coarse
