// Eq. (1) as data: elements, the cracks through them, and which node carries which enrichment term. A value: the coarse
// component builds it from the case; the part of it that is the fine zone is sent across (messages.hpp) and used there
// alike.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "common/crack/crack_piece.hpp"
#include "common/crack/tip.hpp"
#include "common/enrichment/terms_of_nodes.hpp"
#include "common/geometry/vec2.hpp"
#include "common/index.hpp"
#include "common/shared_list.hpp"

namespace stria {

/// A hanging node, tied to the trace of the larger neighbour: the displacement there is the mean of the ends' on either
/// side of the crack, so u = sum_i (u_i + (side - s_i) a_i + (psi - psi_i) b_i) / 2, where the crack meets the edge
/// a = sum_i a_i / 2, and b = sum_i b_i / 2. Of tip functions it has those of both ends, with its own psi.
struct TiedNode {
    int node;
    std::array<int, 2> ends;
    double side;     // of the crack, of the edge at the node
    bool jump_tied;  // else its jump vanishes on the edge, and is free
};

struct EnrichedMesh {
    SharedList<Vec2> nodes;
    SharedList<std::array<int, 4>> elements;
    SharedList<int> node_ids;     // of the whole mesh, ascending
    SharedList<int> element_ids;  // of the whole mesh
    SharedList<int> material;     // of each element (materials.hpp); empty: all are of material 0

    std::vector<CrackPiece> pieces;  // ordered by crack, then along it
    std::vector<Tip> tips;
    std::vector<Tip> left_tips;          // that cracks have outgrown, where their functions stay unknowns
    std::vector<double> mouths;          // per crack, CrackPath::mouth()
    std::vector<double> grown_at_start;  // per crack: CrackSection::grown_at_start, mm; empty: no first point moved
    double tip_exponent = 0.5;           // 1/(n+1) of eq. (2)
    int tip_functions = 0;               // 6: eq. (2); 1: r^(1/2) sin(theta/2) alone; 0: no tip enrichment
    TermsOfNodes terms;                  // gathered ones last
    // +1, -1: side of an uncut element that touches the crack, or that the line behind a tip crosses where its
    // functions act; else 0.
    std::vector<signed char> element_side;
    // Of a part of a mesh, whose nodes have lost the terms that none of its elements sees: branch_side() of each
    // element, as the whole tells it. Empty: this is no part.
    std::vector<signed char> branch;

    std::vector<TiedNode> tied;  // ascending by node; their ends are not tied

    /// First unknown of each node, of each tip's gathered functions, and their total: a node has 2 (1 + own terms)
    /// unknowns, component fastest. Kept by number().
    std::vector<int> first_unknown, first_gathered;
    int unknowns = 0;

    /// Numbers the unknowns, node by node, then tip by tip.
    void number();

    [[nodiscard]] double grown_at_start_of(int crack) const {
        return grown_at_start.empty() ? 0.0 : grown_at_start[at(crack)];
    }

    [[nodiscard]] int material_of(int element) const { return material.empty() ? 0 : material[at(element)]; }

    /// Some function of a tip, or of one that has moved on, has an amplitude at a node.
    [[nodiscard]] bool has_tip_functions(int node) const {
        return std::ranges::any_of(terms[at(node)], [](const Term& t) { return t.kind != Term::Kind::Heaviside; });
    }

    /// Of an index that piece_of_elements() gives; null for -1.
    [[nodiscard]] const CrackPiece* piece(int index) const { return index >= 0 ? &pieces[at(index)] : nullptr; }

    /// Null where the node is not tied. Hanging nodes come last in a mesh: most others are told at once.
    [[nodiscard]] const TiedNode* tie(int node) const {
        if (tied.empty() || node < tied.front().node) return nullptr;
        const auto found = std::ranges::lower_bound(tied, node, {}, &TiedNode::node);
        return found != tied.end() && found->node == node ? &*found : nullptr;
    }

    /// True where a node's term (0: standard) has no unknowns of its own.
    [[nodiscard]] bool follows(int node, int term) const;

    /// Of a function that an end of its edge has, at a tied node.
    [[nodiscard]] double value_at(const TiedNode& here, const Term& function) const;

    /// The nodes whose unknowns make the jump at a node, with their shares: itself, or the ends of its edge.
    [[nodiscard]] std::vector<std::pair<int, double>> holders_of_jump(int node) const;

    /// A term of a node and the first of its two unknowns.
    struct OwnUnknown {
        int node, term, unknown;
    };
    /// All terms that have unknowns, node by node; gathered functions come once a node that carries them.
    [[nodiscard]] std::vector<OwnUnknown> own_unknowns() const;

    /// Of a term that does not follow. Term 0: standard; k: terms[node][k - 1].
    [[nodiscard]] int unknown(int node, int term, int component) const {
        if (term > 0) {
            const Term& t = terms[at(node)][at(term - 1)];
            if (t.kind == Term::Kind::Gathered) return first_gathered[at(t.owner)] + 2 * t.function + component;
        }
        return first_unknown[at(node)] + 2 * term + component;
    }

    /// The node that alone has an unknown; -1: it is of a gathered function.
    [[nodiscard]] int node_of(int unknown) const;
    /// Of a node's displacement, and not of a term.
    [[nodiscard]] bool is_standard(int unknown) const;

    /// Of a term with a tip's function.
    [[nodiscard]] const Tip& tip_of(const Term& term) const {
        const auto owner = at(term.owner);
        return term.kind == Term::Kind::Left ? left_tips[owner] : tips[owner];
    }

    /// Index of a term of a node for unknown(); 0 where the node has no such term.
    [[nodiscard]] int term_index(int node, const Term& term) const;
};

/// Of each unknown of a mesh: that of another mesh which is the same (of the same node, the same function of the same
/// crack or tip), -1: none.
std::vector<int> same_unknowns(const EnrichedMesh& mesh, const EnrichedMesh& other);

/// Values of unknowns that both meshes have, carried from one numbering to the other; elsewhere `initial`.
Eigen::VectorXd carry_over(const EnrichedMesh& from, const Eigen::VectorXd& values, const EnrichedMesh& to,
                           Eigen::VectorXd initial);

/// element_side, or that of an element which has a node beside the crack, +1 or -1; else 0. Behind a tip it
/// chooses the branch of theta: where a crack turns, the line behind its tip passes through such elements.
int branch_side(const EnrichedMesh& mesh, int element);

/// The piece inside each element (not along its edges): index into mesh.pieces, or -1.
std::vector<int> piece_of_elements(const EnrichedMesh& mesh);

}  // namespace stria
