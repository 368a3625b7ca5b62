// The mesh of a body, and what is looked up on it for each position of its cracks.
#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <span>
#include <vector>

#include "common/fem/mesh.hpp"
#include "common/shared_list.hpp"

namespace stria {

/// A mesh that never changes: copies share it, and what has been found on it once. So a growth step asks the elements
/// that are about its cracks, and no others.
class BodyMesh {
public:
    BodyMesh() : BodyMesh(Mesh()) {}
    /// Finds all of it anew, however small the change: never in passing.
    explicit BodyMesh(Mesh mesh);

    operator const Mesh&() const { return found_->mesh; }
    const Mesh& operator*() const { return found_->mesh; }
    const Mesh* operator->() const { return &found_->mesh; }

    /// elements_around_nodes().
    [[nodiscard]] const IndexLists& around() const { return found_->around; }

    /// Those that have, or on an edge of which hangs, some of the nodes; ascending.
    [[nodiscard]] std::vector<int> elements_about(std::span<const int> nodes) const;

    /// All that reach into some of the boxes, or miss them by less than a hundredth of their own diagonal, and others;
    /// ascending.
    [[nodiscard]] std::vector<int> elements_near(std::span<const Eigen::AlignedBox2d> boxes) const;
    /// Likewise of a disk.
    [[nodiscard]] std::vector<int> elements_near(const Vec2& place, double radius = 0.0) const;

    /// Calls visit(element) for elements near a box, in any order, and for some of them more than once.
    template <class Visit> void visit_near(const Eigen::AlignedBox2d& box, Visit&& visit) const {
        found_->cells.for_each(box, [&](std::size_t cell) {
            for (const int element : found_->cells.elements[cell]) visit(element);
        });
    }

    /// mm.
    [[nodiscard]] double longest_edge() const { return found_->longest_edge; }

    // Shared by all that is made of the mesh.
    [[nodiscard]] SharedList<Vec2> nodes() const { return part(&found_->mesh.nodes); }
    [[nodiscard]] SharedList<std::array<int, 4>> elements() const { return part(&found_->mesh.elements); }
    [[nodiscard]] SharedList<int> material() const { return part(&found_->mesh.material); }
    /// 0, 1, 2, ...
    [[nodiscard]] SharedList<int> node_ids() const { return part(&found_->node_ids); }
    [[nodiscard]] SharedList<int> element_ids() const { return part(&found_->element_ids); }

private:
    /// Square cells that cover the mesh, row by row, and the elements near each.
    struct Cells {
        Vec2 origin = Vec2::Zero();
        double size = 1.0;  // mm
        int columns = 0, rows = 0;
        IndexLists elements;

        explicit Cells(const Mesh& mesh);
        /// Calls visit(cell) for each one that a box reaches into.
        template <class Visit> void for_each(const Eigen::AlignedBox2d& box, Visit&& visit) const {
            if (columns == 0) return;
            const int left = along(box.min().x(), origin.x(), columns), top = along(box.max().y(), origin.y(), rows);
            const int right = along(box.max().x(), origin.x(), columns);
            for (int row = along(box.min().y(), origin.y(), rows); row <= top; ++row)
                for (int column = left; column <= right; ++column) visit(at(row) * at(columns) + at(column));
        }
        [[nodiscard]] int along(double coordinate, double from, int count) const;
    };

    struct Found {
        Mesh mesh;
        IndexLists around;
        Cells cells;
        std::vector<int> node_ids, element_ids;
        double longest_edge;

        explicit Found(Mesh whole);
    };

    template <class T> [[nodiscard]] SharedList<T> part(const std::vector<T>* list) const {
        return SharedList<T>(std::shared_ptr<const std::vector<T>>(found_, list));
    }

    std::shared_ptr<const Found> found_;
};

}  // namespace stria
