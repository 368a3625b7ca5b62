// The weight q of the domain integrals about a tip: on which elements it varies in which ring, and how.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "common/enrichment/enriched_mesh.hpp"

namespace stria {

/// A ring about a tip: q is 1 at nodes up to the inner radius, falls linearly with the distance to 0 at the outer
/// radius, and is interpolated by the standard functions in between, in the bulk and on the faces alike.
struct Annulus {
    double inner, outer;    // mm
    bool one_metal = true;  // nothing in it answers otherwise than the tip's material (Materials::are_alike())
    bool tells_J = true, tells_K = true;

    [[nodiscard]] double weight(double r) const { return std::clamp((outer - r) / (outer - inner), 0.0, 1.0); }
};

/// q of a ring at the corners of an element.
[[nodiscard]] Eigen::Vector4d corner_weights(const EnrichedMesh& mesh, int element, const Tip& tip,
                                             const Annulus& ring);

class RingWeights {
public:
    /// `among`: elements that are looked at, ascending. `with_inside`: those count on which q is constant and not zero.
    RingWeights(const EnrichedMesh& mesh, const Tip& tip, std::span<const Annulus> rings, std::span<const int> among,
                bool with_inside = false);

    /// A ring that an element has something to add to, and q at its corners.
    struct Entered {
        std::size_t ring;
        Eigen::Vector4d q;
    };

    /// Elements that enter a ring, ascending.
    [[nodiscard]] const std::vector<int>& elements() const { return elements_; }

    /// What the element enters that is at this place among them.
    [[nodiscard]] std::span<const Entered> of(std::size_t place) const {
        return std::span(entered_).subspan(first_[place], first_[place + 1] - first_[place]);
    }

    /// Of all elements together.
    [[nodiscard]] std::size_t entries() const { return entered_.size(); }

private:
    std::vector<int> elements_;
    std::vector<Entered> entered_;    // element by element
    std::vector<std::size_t> first_;  // of each element, then the number of all
};

/// Whether any element of a mesh has something to add to a ring.
[[nodiscard]] bool reaches(const EnrichedMesh& mesh, const Tip& tip, const Annulus& ring);

}  // namespace stria
