#include "coarse/model/supports_on_unknowns.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "common/error.hpp"

namespace stria::coarse {
namespace {

/// The crack passes through a node at an end of one of its pieces.
bool lies_on(const EnrichedMesh& mesh, int crack, int node) {
    const auto ends_at = [&](const CrackPiece& piece, double place) {
        return place >= 0.0 && place == std::floor(place) &&
               mesh.elements[at(piece.element)][static_cast<std::size_t>(place) % 4] == node;
    };
    return std::ranges::any_of(mesh.pieces, [&](const CrackPiece& piece) {
        return piece.crack == crack && (ends_at(piece, piece.entry) || ends_at(piece, piece.exit));
    });
}

/// Enriched terms that move a supported edge: Heaviside terms where the crack crosses it, or where it begins at a node
/// beside which the edge lies on the other side, and all tip functions. A node on the crack is of one face; where a
/// support ends there it must be that one's.
class EdgeSupports {
public:
    EdgeSupports(const Mesh& mesh, const EnrichedMesh& enriched, const Loads& main) : mesh_(enriched) {
        const auto held = held_nodes(main, {});
        for (const auto& [name, edges] : mesh.boundary)
            for (const BoundaryEdge& edge : edges)
                for (int component = 0; component < 2; ++component) {
                    const auto [from, to] = edge_nodes(mesh, edge);
                    if (!held.contains({from, component}) || !held.contains({to, component})) continue;
                    look_at(edge.element, from, to, component);
                    look_at(edge.element, to, from, component);
                }
    }

    /// Throws CaseError where a support ends at a crack, on the face to which the node there does not belong.
    void hold(std::map<int, double>& prescribed) const {
        for (const auto& [unknown, term] : moved_) {
            if (!own_face_.contains(unknown) && term.crack >= 0 && lies_on(mesh_, term.crack, term.node))
                throw CaseError(fmt::format("boundary: a support ends at ({:.6g}, {:.6g}), where crack {} begins, on "
                                            "the right of the crack's points; give them in reverse order",
                                            mesh_.nodes[at(term.node)].x(), mesh_.nodes[at(term.node)].y(),
                                            term.crack));
            prescribed[unknown] = 0.0;
        }
    }

private:
    struct Moved {
        int node, crack;  // crack: of a Heaviside term; else -1
    };

    void look_at(int element, int node, int other, int component) {
        const auto& terms = mesh_.terms[at(node)];
        for (int k = 0; k < static_cast<int>(terms.size()); ++k) {
            const Term& term = terms[at(k)];
            const int unknown = mesh_.unknown(node, k + 1, component);
            if (term.kind == Term::Kind::Tip || term.kind == Term::Kind::Left) moved_[unknown] = {node, -1};
            if (term.kind != Term::Kind::Heaviside) continue;
            const bool crossed = std::ranges::any_of(mesh_.terms[at(other)], [&](const Term& t) {
                return t.kind == Term::Kind::Heaviside && t.owner == term.owner && t.shift != term.shift;
            });
            if (crossed || mesh_.element_side[at(element)] * term.shift < 0)
                moved_[unknown] = {node, term.owner};
            else
                own_face_.insert(unknown);
        }
    }

    const EnrichedMesh& mesh_;
    std::map<int, Moved> moved_;
    std::set<int> own_face_;  // unknowns of Heaviside terms that vanish on a held edge
};

/// Displacements that load case `k` imposes.
void move_in_case(std::vector<PrescribedUnknown>& prescribed, const EnrichedMesh& enriched, const Loads& of_case,
                  std::size_t k) {
    for (const PrescribedDisplacement& d : of_case.displacements) {
        const int unknown = enriched.unknown(d.node, 0, d.component);
        PrescribedUnknown& p = *std::ranges::lower_bound(prescribed, unknown, {}, &PrescribedUnknown::unknown);
        p.in_cases.resize(k + 1, 0.0);
        p.in_cases[k] = d.value;
    }
}

}  // namespace

UnknownSet prescribed_among(int unknowns, const std::vector<PrescribedUnknown>& prescribed) {
    UnknownSet set(unknowns);
    for (const PrescribedUnknown& p : prescribed) set.insert(p.unknown);
    return set;
}

void impose(const std::vector<PrescribedUnknown>& prescribed, const LoadFactors& factors, Eigen::VectorXd& u) {
    for (const PrescribedUnknown& p : prescribed) u[p.unknown] = p.under(factors);
}

std::map<std::pair<int, int>, double> held_nodes(const Loads& main, const FreeMotions& free_motions) {
    std::map<std::pair<int, int>, double> held;
    for (const PrescribedDisplacement& d : main.displacements) held[{d.node, d.component}] = d.value;
    for (const Pin& pin : free_motions.pins) held[{pin.node, pin.component}] = 0.0;
    return held;
}

std::vector<PrescribedUnknown> prescribed_unknowns(const Mesh& mesh, const EnrichedMesh& enriched,
                                                   const LoadsOfCase& loads, const FreeMotions& free_motions) {
    std::map<int, double> values;
    EdgeSupports(mesh, enriched, loads.main).hold(values);
    for (const auto& [where, value] : held_nodes(loads.main, free_motions))
        values[enriched.unknown(where.first, 0, where.second)] = value;
    std::vector<PrescribedUnknown> prescribed;
    for (const auto& [unknown, value] : values) prescribed.push_back({unknown, value});
    for (std::size_t k = 0; k < loads.cases.size(); ++k) move_in_case(prescribed, enriched, loads.cases[k], k);
    return prescribed;
}

}  // namespace stria::coarse
