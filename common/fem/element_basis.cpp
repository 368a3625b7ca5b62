#include "common/fem/element_basis.hpp"

#include <optional>

#include "common/fem/shape_q4.hpp"
#include "common/fem/tip_functions.hpp"

namespace stria {

ElementBasis::ElementBasis(const EnrichedMesh& mesh, int element, bool cut)
    : mesh_(&mesh), nodes_(mesh.elements[static_cast<std::size_t>(element)]),
      own_side_(cut ? 0 : mesh.element_side[static_cast<std::size_t>(element)]), tip_side_(own_side_) {
    std::vector<std::pair<int, int>> gathered;  // tip, functions
    for (int corner = 0; corner < 4; ++corner) {
        const int node = nodes_[static_cast<std::size_t>(corner)];
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
            if (term.kind == Term::Kind::Heaviside) {
                if (tip_side_ == 0) tip_side_ = static_cast<int>(term.shift);
                if (!cut && (own_side_ == 0 || own_side_ == static_cast<int>(term.shift))) continue;
            } else {
                singular_ = true;
            }
            if (term.kind != Term::Kind::Gathered)
                add(k + 1, term, false);
            else if (gathered.empty() || gathered.back().first != term.owner)
                gathered.emplace_back(term.owner, term.function + 1);
            else
                gathered.back().second = std::max(gathered.back().second, term.function + 1);
        }
    }
    if (cut) tip_side_ = 0;
    for (const auto& [tip, functions] : gathered) gather_tip(tip, functions);
}

// The interpolant that a gathered function is freed from takes, in each element, what the standard and Heaviside terms
// can take: from either side of the crack the values of a jumping node continue the function of that side.
void ElementBasis::gather_tip(int index, int functions) {
    const Tip& tip = mesh_->tips[static_cast<std::size_t>(index)];
    Gathered gathered{index, functions, Eigen::Vector4d::Zero(), {}};
    for (int corner = 0; corner < 4; ++corner) {
        const int node = nodes_[static_cast<std::size_t>(corner)];
        const auto psi = [&](int side) {
            return tip_functions(tip, corners_[static_cast<std::size_t>(corner)], side, mesh_->tip_exponent).value;
        };
        Eigen::Matrix<double, 6, 1> own = psi(0);
        bool jumps = false;
        for (const Term& term : mesh_->terms[static_cast<std::size_t>(node)]) {
            jumps = jumps || (term.kind == Term::Kind::Heaviside && term.owner == tip.crack);
            if (term.kind != Term::Kind::Gathered || term.owner != index) continue;
            gathered.inside[corner] = 1.0;
            own[term.function] = term.shift;
        }
        for (const int side : {-1, 1}) {
            gathered.at_corners[side > 0 ? 1 : 0].row(corner) = jumps ? psi(tip_side_ != 0 ? tip_side_ : side) : own;
        }
    }
    for (int alpha = 0; alpha < functions; ++alpha) {
        for (int component = 0; component < 2; ++component)
            unknowns_.push_back(mesh_->first_gathered[static_cast<std::size_t>(index)] + 2 * alpha + component);
    }
    gathered_.push_back(gathered);
}

void ElementBasis::add_gathered(const ShapeQ4& shape, const Vec2& x, int side, BasisValues& out) const {
    auto f = static_cast<Eigen::Index>(functions_.size());
    for (const Gathered& gathered : gathered_) {
        const TipFunctions psi =
            tip_functions(mesh_->tips[static_cast<std::size_t>(gathered.tip)], x, side, mesh_->tip_exponent);
        const auto& at_corners = gathered.at_corners[side > 0 ? 1 : 0];
        const double inside = shape.value.dot(gathered.inside);
        const Eigen::RowVector2d inside_slope = gathered.inside.transpose() * shape.gradient;
        for (int alpha = 0; alpha < gathered.functions; ++alpha, ++f) {
            const double rest = psi.value[alpha] - shape.value.dot(at_corners.col(alpha));
            out.value[f] = inside * rest;
            out.gradient.row(f) = inside_slope * rest + inside * (psi.gradient.row(alpha) -
                                                                  at_corners.col(alpha).transpose() * shape.gradient);
        }
    }
}

void ElementBasis::evaluate(const Vec2& xi, const Vec2& x, int side, BasisValues& out) const {
    const ShapeQ4 shape = shape_q4(corners_, xi);
    const int where = own_side_ != 0 ? own_side_ : side, tip_where = tip_side_ != 0 ? tip_side_ : side;
    out.value.resize(functions());
    out.gradient.resize(functions(), 2);
    int cached_tip = -1;
    TipFunctions tip;
    for (std::size_t k = 0; k < functions_.size(); ++k) {
        const Function& function = functions_[k];
        const auto f = static_cast<Eigen::Index>(k);
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
                tip =
                    tip_functions(mesh_->tips[static_cast<std::size_t>(cached_tip)], x, tip_where, mesh_->tip_exponent);
            }
            const double psi = tip.value[function.term.function] - function.term.shift;
            out.value[f] = n * psi;
            out.gradient.row(f) = dn * psi + n * tip.gradient.row(function.term.function);
        }
    }
    add_gathered(shape, x, tip_where, out);
}

}  // namespace stria
