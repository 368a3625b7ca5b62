// On which side of a crack the nodes and elements that touch it lie. Side +1 is left of the crack's direction.
#pragma once

#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "common/crack/crack_path.hpp"
#include "common/crack/tip.hpp"
#include "common/fem/body_mesh.hpp"

namespace stria::coarse {

class CrackSides {
public:
    /// `path` must outlive the sides.
    CrackSides(BodyMesh mesh, const CrackPath& path);

    /// +1 or -1 for each node of an element that the crack cuts, and for each node on the crack: those count as +1.
    [[nodiscard]] const std::map<int, int>& of_nodes() const { return of_nodes_; }
    /// Of these, and of what hangs on an edge of an element that the crack cuts or ends in.
    [[nodiscard]] const std::map<int, int>& of_hanging_too() const { return of_hanging_too_; }

    /// Side of one of the tip_nodes() at the end of a piece. Ahead of the tip either will do.
    [[nodiscard]] int near_tip(const CrackPiece& piece, int node) const;

    /// Sets the side, +1 or -1, of the elements that touch the crack without being cut. `tips`: those at its start and
    /// its end, if they are; `sides`: one per element.
    void put_on_elements(std::span<const Tip> tips, std::vector<signed char>& sides) const;

    /// Side of a place off the crack, by what of the crack is nearest; beyond an end that of the line which goes on.
    [[nodiscard]] int of_place(const Vec2& x) const;

    /// Likewise sets that of the elements about the nodes of a tip's functions that the line behind the tip crosses
    /// where the crack has turned away from it.
    void put_behind_tip(const Tip& tip, const std::map<int, int>& nodes, std::vector<signed char>& sides) const;

private:
    void note_piece(const CrackPiece& piece);
    void note_if_node(const CrackPiece& piece, double place);
    void note_hanging_nodes();
    [[nodiscard]] int side_in(const CrackPiece& piece, const Vec2& x) const;
    /// Of the nodes of an element, but for those on the crack: both where the crack cuts it, or ends before it.
    [[nodiscard]] std::set<int> known_sides(int element) const;
    void put_beside_tip(const CrackPiece& piece, const Tip& tip, std::vector<signed char>& sides) const;
    [[nodiscard]] bool is_torn(int element, const Tip& tip, int side) const;
    [[nodiscard]] bool lies_across(int element, const Tip& tip, int side) const;
    [[nodiscard]] std::pair<Vec2, Vec2> neighbours_on_crack(const Vec2& x) const;
    /// Of a place beside one of the crack's points, at which it may bend.
    [[nodiscard]] int side_at(const Vec2& bend, const Vec2& x) const;

    BodyMesh mesh_;
    const CrackPath& path_;
    std::map<int, int> of_nodes_, of_hanging_too_;
    std::set<int> on_crack_;
    std::set<int> cut_;         // elements
    std::vector<Vec2> points_;  // of the crack on the mesh
};

}  // namespace stria::coarse
