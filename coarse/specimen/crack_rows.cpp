#include "coarse/specimen/crack_rows.hpp"

#include <algorithm>
#include <cmath>

#include "common/crack/bends.hpp"

namespace stria::coarse {
namespace {

/// Nodes with the coordinate `value` along an axis, and the way up to the next line of nodes.
class Line {
public:
    Line(const Mesh& mesh, int axis, double value) : axis_(axis) {
        double low = value;
        for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
            const double above = mesh.nodes[n][axis] - value;
            if (std::abs(above) <= 1e-9 * (1.0 + std::abs(value)))
                nodes_.push_back(n);
            else if (above > 0.0)
                next_ = std::min(next_, above);
            low = std::min(low, mesh.nodes[n][axis]);
        }
        inside_ = low < value && next_ < infinite;
    }

    /// Inside the body, with the point between two of its nodes.
    [[nodiscard]] bool holds_between_nodes(const Mesh& mesh, const Vec2& point) const {
        const auto is_there = [&](std::size_t n) {
            return (mesh.nodes[n] - point).norm() <= 1e-9 * (1.0 + point.norm());
        };
        return inside_ && !nodes_.empty() && std::ranges::none_of(nodes_, is_there);
    }

    void move_up(Mesh& mesh) const {
        for (const std::size_t n : nodes_) mesh.nodes[n][axis_] += 0.25 * next_;
    }

private:
    static constexpr double infinite = 1e300;
    int axis_;
    std::vector<std::size_t> nodes_;
    double next_ = infinite;  // mm
    bool inside_ = false;
};

}  // namespace

void move_off_bends(Mesh& mesh, const std::vector<CrackSection>& cracks) {
    for (const CrackSection& crack : cracks) {
        const std::vector<Vec2> points = ends_and_bends(crack.points);
        for (std::size_t k = 1; k + 1 < points.size(); ++k) {
            for (const int axis : {0, 1}) {
                const Vec2 &before = points[k - 1], &bend = points[k], &after = points[k + 1];
                if (before[axis] != bend[axis] && after[axis] != bend[axis]) continue;
                const Line line(mesh, axis, bend[axis]);
                if (line.holds_between_nodes(mesh, bend)) line.move_up(mesh);
            }
        }
    }
}

}  // namespace stria::coarse
