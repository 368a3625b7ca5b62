// Whether the mesh at the tips is fine enough for K, opening loads and growth: asked before a run, and of the longer
// cracks after each growth.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "coarse/advice/mesh_doubt.hpp"
#include "coarse/model/scene.hpp"

namespace stria::coarse {

/// What the mesh serves or not. One number per tip; nothing is said of openings where nobody looks at them.
struct MeshDemands {
    std::vector<double> K_I = {};       // that opening loads are asked of (common_K_behind_turns), MPa sqrt(mm)
    std::vector<double> distance = {};  // of closure (closure_distances), mm
    std::vector<double> radius = {};    // of the largest ring, mm
};

/// Says each doubt of a tip once, and once more where it has become graver. Of the first that holds: a bend behind the
/// tip, no room for rings, another metal. Then of functions, of opening loads and of growth (ring_adequacy.hpp,
/// opening_adequacy.hpp).
///
/// At the first look elements are as small as the case asks for, and of a K that has fallen it is silent. Of bends it
/// speaks only then: a run speaks of turns itself.
class MeshJudge {
public:
    explicit MeshJudge(std::vector<int> said = {}) : said_(std::move(said)) {}

    /// What is to be said that has not been said before.
    [[nodiscard]] std::vector<std::string> look_at(const Scene& scene, const MeshDemands& demands);

    /// How grave each doubt was that has been said: kinds of the first tip, then of the second. Empty before any look.
    [[nodiscard]] const std::vector<int>& said() const { return said_; }

private:
    [[nodiscard]] bool is_news(std::size_t tip, const MeshDoubt& doubt);

    std::vector<int> said_;
};

/// What a first look finds, behind what is to be said of the body: a region whose outline elements do not follow.
/// `K_I` and `distance`: as in MeshDemands.
[[nodiscard]] std::vector<std::string> mesh_warnings(const Scene& scene, const std::vector<double>& K_I,
                                                     const std::vector<double>& distance);

}  // namespace stria::coarse
