#include "common/enrichment/element_basis.hpp"

#include <algorithm>

#include "common/enrichment/tip_functions.hpp"
#include "common/fem/shape_q4.hpp"
#include "common/index.hpp"

namespace stria {

ElementBasis::ElementBasis(const EnrichedMesh& mesh, int element, bool cut)
    : mesh_(&mesh), nodes_(mesh.elements[at(element)]), own_side_(cut ? 0 : mesh.element_side[at(element)]),
      tip_side_(cut ? 0 : branch_side(mesh, element)) {
    constexpr std::size_t of_cut_element = 8;
    functions_.reserve(of_cut_element);
    for (int corner = 0; corner < 4; ++corner) add_corner(corner, cut);
    number_functions();
    for (int tip = 0; tip < std::ssize(mesh.tips); ++tip) {
        int functions = 0;
        for (const int node : nodes_) {
            for (const Term& term : mesh.terms[at(node)]) {
                if (term.kind == Term::Kind::Gathered && term.owner == tip)
                    functions = std::max(functions, term.function + 1);
            }
        }
        if (functions > 0) gather_tip(tip, functions);
    }
}

void ElementBasis::add_corner(int corner, bool cut) {
    const int node = nodes_[at(corner)];
    corners_[at(corner)] = mesh_->nodes[at(node)];
    functions_.push_back({corner, 0, {}});
    const auto& terms = mesh_->terms[at(node)];
    for (int k = 0; k < std::ssize(terms); ++k) {
        const Term& term = terms[at(k)];
        if (term.kind == Term::Kind::Heaviside) {
            if (!cut && (own_side_ == 0 || own_side_ == static_cast<int>(term.shift))) continue;
        } else {
            singular_ = true;
        }
        if (term.kind != Term::Kind::Gathered) functions_.push_back({corner, k + 1, term});
    }
}

// A hanging corner's functions go to the ends of its edge (TiedNode). Most elements have none.
void ElementBasis::number_functions() {
    const auto follows = [&](const Function& function) {
        return mesh_->follows(nodes_[at(function.corner)], function.term_index);
    };
    if (mesh_->tied.empty() || std::ranges::none_of(functions_, follows)) {
        unknowns_.reserve(2 * functions_.size());
        for (const Function& function : functions_) {
            const int unknown = mesh_->unknown(nodes_[at(function.corner)], function.term_index, 0);
            unknowns_.insert(unknowns_.end(), {unknown, unknown + 1});
        }
        return;
    }
    std::vector<int> first;  // unknown of each column
    struct Share {
        std::size_t column;
        std::size_t function;
        double part;
    };
    std::vector<Share> shares;
    first.reserve(2 * functions_.size());
    shares.reserve(3 * functions_.size());
    const auto give = [&](std::size_t function, int node, int term, double part) {
        const int unknown = mesh_->unknown(node, term, 0);
        const auto found = std::ranges::find(first, unknown);
        shares.push_back({at(found - first.begin()), function, part});
        if (found == first.end()) first.push_back(unknown);
    };
    for (std::size_t f = 0; f < functions_.size(); ++f) {
        const auto& [corner, term_index, term] = functions_[f];
        const int node = nodes_[at(corner)];
        if (!mesh_->follows(node, term_index)) {
            give(f, node, term_index, 1.0);
            continue;
        }
        const TiedNode& tie = *mesh_->tie(node);
        for (const int end : tie.ends) {
            if (term_index == 0) give(f, end, 0, 0.5);
            const auto& terms = mesh_->terms[at(end)];
            for (int k = 0; k < std::ssize(terms); ++k) {
                const Term& own = terms[at(k)];
                if (own.kind == Term::Kind::Gathered || (term_index > 0 && !own.same_function(term))) continue;
                const double part = 0.5 * (term_index > 0 ? 1.0 : mesh_->value_at(tie, own) - own.shift);
                if (part != 0.0) give(f, end, k + 1, part);
            }
        }
    }
    unknowns_.reserve(2 * first.size());
    for (const int unknown : first) unknowns_.insert(unknowns_.end(), {unknown, unknown + 1});
    ties_ = Eigen::MatrixXd::Zero(std::ssize(first), std::ssize(functions_));
    for (const Share& share : shares)
        ties_(static_cast<Eigen::Index>(share.column), static_cast<Eigen::Index>(share.function)) += share.part;
}

// The interpolant that a gathered function is freed from takes, in each element, what the standard and Heaviside terms
// can take: from either side of the crack the values of a jumping node continue the function of that side.
void ElementBasis::gather_tip(int index, int functions) {
    const Tip& tip = mesh_->tips[at(index)];
    Gathered gathered{index, functions, Eigen::Vector4d::Zero(), {}};
    for (int corner = 0; corner < 4; ++corner) {
        const int node = nodes_[at(corner)];
        const auto psi = [&](int side) {
            return tip_functions(tip, corners_[at(corner)], side, mesh_->tip_exponent).value;
        };
        Eigen::Matrix<double, 6, 1> own = psi(tip_side_);
        bool jumps = false;
        for (const Term& term : mesh_->terms[at(node)]) {
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
            unknowns_.push_back(mesh_->first_gathered[at(index)] + 2 * alpha + component);
    }
    gathered_.push_back(gathered);
}

void ElementBasis::add_gathered(const ShapeQ4& shape, const Vec2& x, int side, BasisValues& out) const {
    auto f = static_cast<Eigen::Index>(functions_.size());
    for (const Gathered& gathered : gathered_) {
        const TipFunctions psi = tip_functions(mesh_->tips[at(gathered.tip)], x, side, mesh_->tip_exponent);
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
    const int own_functions = ties_.size() > 0 ? static_cast<int>(functions_.size()) : functions();
    out.value.resize(own_functions);
    out.gradient.resize(own_functions, 2);
    const Tip* cached_tip = nullptr;
    TipFunctions tip;
    for (std::size_t k = 0; k < functions_.size(); ++k) {
        const Function& function = functions_[k];
        const auto f = static_cast<Eigen::Index>(k);
        const double n = shape.value[function.corner];
        const Eigen::RowVector2d dn = shape.gradient.row(function.corner);
        if (function.term_index == 0) {
            out.value[f] = n;
            out.gradient.row(f) = dn;
        } else if (function.term.kind == Term::Kind::Heaviside) {
            const double psi = where - function.term.shift;
            out.value[f] = n * psi;
            out.gradient.row(f) = dn * psi;
        } else {
            if (const Tip* own = &mesh_->tip_of(function.term); own != cached_tip) {
                cached_tip = own;
                tip = tip_functions(*own, x, tip_where, mesh_->tip_exponent);
            }
            const double psi = tip.value[function.term.function] - function.term.shift;
            out.value[f] = n * psi;
            out.gradient.row(f) = dn * psi + n * tip.gradient.row(function.term.function);
        }
    }
    add_gathered(shape, x, tip_where, out);
    if (ties_.size() == 0) return;
    out.value = ties_ * out.value;
    out.gradient = ties_ * out.gradient;
}

}  // namespace stria
