#include "coarse/mesh_file/soundness.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <numeric>

#include "common/error.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"

namespace stria::coarse {
namespace {

constexpr double same_place = 1e-7;  // of the body: what lies nearer is one point, kept apart by the mesher
constexpr double on_edge = 1e-5;     // of the edge's length

/// How far a place is along a direction in which no two nodes of a regular mesh are as far: its slope is the golden
/// ratio. Two places are no nearer to each other than along it.
double along(const Vec2& x) {
    constexpr double cosine = 0.85065080835203993, sine = 0.52573111211913361;
    return cosine * x.x() + sine * x.y();
}

class Judge {
public:
    Judge(const Faces& faces, const std::string& name) : faces_(faces), name_(name) {
        Vec2 low = faces.nodes.front(), high = low;
        for (const Vec2& x : faces.nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
        extent_ = (high - low).maxCoeff();
        ordered_.resize(faces.nodes.size());
        std::iota(ordered_.begin(), ordered_.end(), 0);
        std::ranges::sort(ordered_, {}, [&](int node) { return along(faces.nodes[at(node)]); });
    }

    void require_nodes_apart() const {
        for (std::size_t i = 0; i < ordered_.size(); ++i) {
            const Vec2& x = x_of(ordered_[i]);
            for (std::size_t j = i + 1; j < ordered_.size(); ++j) {
                const Vec2& other = x_of(ordered_[j]);
                if (along(other) - along(x) > same_place * extent_) break;
                if ((other - x).norm() > same_place * extent_) continue;
                complain(fmt::format("nodes {} and {} lie both at {}; merge them (Gmsh: Coherence Mesh). Cracks are "
                                     "given in the case, not by the mesh",
                                     number(ordered_[i]), number(ordered_[j]), text_of(x)));
            }
        }
    }

    void require_two_faces_an_edge() const {
        for (const auto& [ends, sides] : faces_.edges) {
            if (sides.size() > 2)
                complain(fmt::format("elements {}, {} and {} share the edge between the nodes {} and {}; two may",
                                     face(sides[0]), face(sides[1]), face(sides[2]), number(ends.first),
                                     number(ends.second)));
            if (sides.size() == 2 && start_of(sides[0]) == start_of(sides[1]))
                complain(fmt::format("elements {} and {} lie on the same side of their edge between the nodes {} and "
                                     "{}: they overlap",
                                     face(sides[0]), face(sides[1]), number(ends.first), number(ends.second)));
        }
    }

    void require_one_piece() const {
        std::vector<int> first(faces_.faces.size());  // a face of the same piece; at the end of the way, itself
        std::iota(first.begin(), first.end(), 0);
        const auto root = [&](int f) {
            while (first[at(f)] != f) f = first[at(f)] = first[at(first[at(f)])];
            return f;
        };
        for (const auto& [ends, sides] : faces_.edges)
            if (sides.size() == 2) first[at(root(sides[0].face))] = root(sides[1].face);
        for (int f = 1; f < std::ssize(first); ++f)
            if (root(f) != root(0))
                complain(
                    fmt::format("elements {} and {} are not connected by edges: the mesh is of more than one piece",
                                faces_.faces[0].number, faces_.faces[at(f)].number));
    }

    /// The boundary passes each of its nodes once.
    void require_no_hinge() const {
        std::map<int, int> passes;
        for (const auto& [ends, sides] : faces_.edges) {
            if (sides.size() != 1) continue;
            for (const int node : {ends.first, ends.second})
                if (++passes[node] > 2)
                    complain(fmt::format("at node {}, {}, elements hang together by this point alone", number(node),
                                         text_of(x_of(node))));
        }
    }

    /// A node on an edge of which it is no end: the elements on either side do not fit.
    void require_whole_edges() const {
        for (const auto& [ends, sides] : faces_.edges) {
            if (sides.size() != 1) continue;
            const Vec2 &a = x_of(ends.first), &b = x_of(ends.second);
            const double near = on_edge * (b - a).norm();
            const auto [first, last] = std::minmax({along(a), along(b)});
            const auto place = [&](int node) { return along(x_of(node)); };
            const auto from = std::ranges::lower_bound(ordered_, first - near, {}, place);
            for (auto node = from; node != ordered_.end() && place(*node) <= last + near; ++node) {
                if (*node == ends.first || *node == ends.second) continue;
                if (distance_to_segment(x_of(*node), a, b) > near) continue;
                complain(fmt::format("node {} at {} lies on the edge of element {} between the nodes {} and {}: "
                                     "neighbours must share whole edges",
                                     number(*node), text_of(x_of(*node)), face(sides[0]), number(ends.first),
                                     number(ends.second)));
            }
        }
    }

private:
    [[noreturn]] void complain(const std::string& what) const { throw CaseError(name_ + ": " + what); }

    [[nodiscard]] const Vec2& x_of(int node) const { return faces_.nodes[at(node)]; }
    [[nodiscard]] Number number(int node) const { return faces_.numbers[at(node)]; }
    [[nodiscard]] Number face(const FaceEdge& side) const { return faces_.faces[at(side.face)].number; }
    [[nodiscard]] int start_of(const FaceEdge& side) const { return faces_.faces[at(side.face)].nodes[at(side.edge)]; }
    static std::string text_of(const Vec2& x) { return fmt::format("({:.6g}, {:.6g})", x.x(), x.y()); }

    const Faces& faces_;
    const std::string& name_;
    double extent_;             // mm
    std::vector<int> ordered_;  // nodes, ascending along()
};

}  // namespace

void require_soundness(const Faces& faces, const std::string& name) {
    const Judge judge(faces, name);
    judge.require_nodes_apart();
    judge.require_two_faces_an_edge();
    judge.require_whole_edges();
    judge.require_one_piece();
    judge.require_no_hinge();
}

}  // namespace stria::coarse
