#include "common/fem/element_basis.hpp"

#include <optional>

#include "common/fem/shape_q4.hpp"
#include "common/fem/tip_functions.hpp"

namespace stria {

ElementBasis::ElementBasis(const EnrichedMesh& mesh, int element, bool cut)
    : mesh_(&mesh), own_side_(cut ? 0 : mesh.element_side[static_cast<std::size_t>(element)]) {
    const auto& nodes = mesh.elements[static_cast<std::size_t>(element)];
    for (int corner = 0; corner < 4; ++corner) {
        const int node = nodes[static_cast<std::size_t>(corner)];
        corners_[static_cast<std::size_t>(corner)] = mesh.nodes[static_cast<std::size_t>(node)];
        const auto add = [&](int term_index, const Term& term, bool standard) {
            functions_.push_back({corner, term, standard});
            for (int component = 0; component < 2; ++component)
                unknowns_.push_back(mesh.unknown(node, term_index, component));
        };
        add(0, {}, true);
        const auto& terms = mesh.terms[static_cast<std::size_t>(node)];
        for (int k = 0; k < static_cast<int>(terms.size()); ++k) {
            const Term& term = terms[static_cast<std::size_t>(k)];
            const bool heaviside = term.kind == Term::Kind::Heaviside;
            if (heaviside && !cut && (own_side_ == 0 || own_side_ == static_cast<int>(term.shift))) continue;
            singular_ = singular_ || !heaviside;
            add(k + 1, term, false);
        }
    }
}

void ElementBasis::evaluate(const Vec2& xi, const Vec2& x, int side, BasisValues& out) const {
    const ShapeQ4 shape = shape_q4(corners_, xi);
    const int where = own_side_ != 0 ? own_side_ : side;
    out.value.resize(functions());
    out.gradient.resize(functions(), 2);
    int cached_tip = -1;
    TipFunctions tip;
    for (int f = 0; f < functions(); ++f) {
        const Function& function = functions_[static_cast<std::size_t>(f)];
        const double n = shape.value[function.corner];
        const Eigen::RowVector2d dn = shape.gradient.row(function.corner);
        if (function.standard) {
            out.value[f] = n;
            out.gradient.row(f) = dn;
        } else if (function.term.kind == Term::Kind::Heaviside) {
            const double psi = where - function.term.shift;
            out.value[f] = n * psi;
            out.gradient.row(f) = dn * psi;
        } else {
            if (cached_tip != function.term.owner) {
                cached_tip = function.term.owner;
                tip = tip_functions(mesh_->tips[static_cast<std::size_t>(cached_tip)], x, where, mesh_->tip_exponent);
            }
            const double psi = tip.value[function.term.function] - function.term.shift;
            out.value[f] = n * psi;
            out.gradient.row(f) = dn * psi + n * tip.gradient.row(function.term.function);
        }
    }
}

}  // namespace stria
