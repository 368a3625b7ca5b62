// The elements of a scene, whatever they carry: what each of them sees, and its elastic operator, made on demand.
#pragma once

#include <span>
#include <vector>

#include "coarse/model/scene.hpp"
#include "common/integration/plain_operator.hpp"

namespace stria::coarse {

/// Of a plain element (plain_operator.hpp), with the mean dilatation that its material wants.
[[nodiscard]] inline PlainOperator plain_operator(const Scene& scene, int element) {
    return stria::plain_operator(scene.enriched, element, scene.mean_dilatation(element) != MeanDilatation::Nowhere);
}

class SceneElements {
public:
    /// `scene` must outlive them.
    explicit SceneElements(const Scene& scene) : scene_(&scene), piece_(piece_of_elements(scene.enriched)) {}

    [[nodiscard]] const Scene& scene() const { return *scene_; }

    /// Calls visit(unknowns): a span over unknowns of the whole mesh.
    template <class Visit> void visit_unknowns(int element, Visit&& visit) const {
        if (is_plain(scene_->enriched, element))
            visit(std::span<const int>(plain_unknowns(scene_->enriched, element)));
        else
            visit(std::span<const int>(ElementBasis(scene_->enriched, element, piece_[at(element)] >= 0).unknowns()));
    }

    /// Calls visit(op): a PlainOperator or an ElementOperator. Both answer to the same names and last for the visit.
    template <class Visit> void visit_operator(int element, Visit&& visit) const {
        if (is_plain(scene_->enriched, element))
            visit(plain_operator(*scene_, element));
        else
            visit(enriched_operator(element));
    }

    /// Of one that is not plain.
    [[nodiscard]] ElementOperator enriched_operator(int element) const;

private:
    const Scene* scene_;
    std::vector<int> piece_;  // of the crack, per element; -1: uncut
};

}  // namespace stria::coarse
