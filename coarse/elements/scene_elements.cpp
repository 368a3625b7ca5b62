#include "coarse/elements/scene_elements.hpp"

namespace stria::coarse {

ElementOperator SceneElements::enriched_operator(int element) const {
    const EnrichedMesh& mesh = scene_->enriched;
    const CrackPiece* cut = mesh.piece(piece_[at(element)]);
    IntegrationRule rule = elastic_rule(mesh, element, cut != nullptr);
    rule.mean_dilatation = scene_->mean_dilatation(element);
    return make_operator(mesh, element, cut, rule);
}

}  // namespace stria::coarse
