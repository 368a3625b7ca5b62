// The elements of the zone: their points and functions, their elastic matrices, and which of them an earlier zone had.
#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "common/enrichment/enriched_mesh.hpp"
#include "common/index_set.hpp"
#include "common/integration/element_operator.hpp"
#include "common/material/materials.hpp"

namespace stria::fine {

/// Does not change until a later zone takes over what stays. Elements are numbered as in the mesh, from 0.
class BulkElements {
public:
    /// `rule`: but for the mean dilatation, which follows from an element's material. `old`: null, or the elements of
    /// an earlier zone, which gives up those that stay as they are (has_stayed()); others keep their points, but where
    /// nothing may yield: these have no history.
    BulkElements(const EnrichedMesh& mesh, const Materials& materials, const IntegrationRule& rule, BulkElements* old);

    /// Points that an element has already, with `cut` the crack inside it or null; none: they are placed anew.
    using KnownPoints = std::function<std::optional<std::vector<IntegrationPoint>>(int element, const CrackPiece* cut)>;
    BulkElements(const EnrichedMesh& mesh, const Materials& materials, const IntegrationRule& rule,
                 const KnownPoints& known, BulkElements* old = nullptr);

    /// Nothing else is new (same_but_for_tips()).
    void move_tips(std::vector<Tip> tips) { mesh_.tips = std::move(tips); }

    [[nodiscard]] int count() const { return static_cast<int>(operators_.size()); }
    [[nodiscard]] const EnrichedMesh& mesh() const { return mesh_; }
    [[nodiscard]] const Materials& materials() const { return materials_; }
    /// Of an element.
    [[nodiscard]] const Elasticity& elastic(int element) const {
        return materials_.elastic(mesh_.material_of(element));
    }
    [[nodiscard]] const MandelMatrix& elastic_stiffness(int element) const {
        return materials_.stiffness(mesh_.material_of(element));
    }
    [[nodiscard]] const std::vector<ElementOperator>& operators() const { return operators_; }
    [[nodiscard]] const ElementOperator& op(int element) const { return operators_[at(element)]; }
    /// In an element, MPa.
    [[nodiscard]] Mandel initial_stress(int element, const Vec2& x) const {
        return materials_.initial_stress().at(x, mesh_.material_of(element));
    }

    /// Elastic stiffness of each element, 2f x 2f where it has f functions, N/mm2.
    [[nodiscard]] const std::vector<Eigen::MatrixXd>& stiffness() const { return stiffness_; }

    /// The element that one of a later mesh is: the same id, and the same corners, for it may have been split.
    [[nodiscard]] std::optional<int> find(const EnrichedMesh& later, int element) const;

    /// Whether an element is as it was in an earlier zone, which has given it up: it has the same functions, none of
    /// them a tip's, tied in the same way, and is cut in the same way.
    [[nodiscard]] bool has_stayed(int element) const { return was(element) >= 0; }
    /// Its number there, -1: it has not stayed.
    [[nodiscard]] int was(int element) const { return was_[at(element)]; }
    /// Of those that have not stayed.
    [[nodiscard]] UnknownSet changed_unknowns() const;
    [[nodiscard]] int built() const { return static_cast<int>(std::ranges::count(was_, -1)); }

    /// The points that an element of a later mesh has here already, if it is here: with weights fitted anew where the
    /// crack, `cut`, has newly cut it (docs/equations.md, growth).
    [[nodiscard]] std::optional<std::vector<IntegrationPoint>> points_kept(const EnrichedMesh& later, int element,
                                                                           const CrackPiece* cut) const;

    /// Whether an element has points within a radius of a place, or could have; mm.
    [[nodiscard]] bool is_near(int element, const Vec2& place, double radius) const;

private:
    [[nodiscard]] const CrackPiece* cut_of(int element) const;
    [[nodiscard]] bool stays(const BulkElements& later, int element, int own) const;
    /// `now`: of each unknown of the old mesh.
    void take_over(BulkElements& old, int own, int element, std::span<const int> now);

    EnrichedMesh mesh_;
    Materials materials_;
    std::vector<int> piece_;  // per element: the piece of a crack inside it, -1: none
    std::vector<ElementOperator> operators_;
    std::vector<Eigen::MatrixXd> stiffness_;
    std::vector<int> was_;
};

}  // namespace stria::fine
