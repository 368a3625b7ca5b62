// The contact multipliers of one crack (NUMERICS 1): continuous piecewise-linear hats on a trace coarser than the mesh, which
// keeps the pressure free of oscillations for every position of the crack in it.
#pragma once

#include <array>
#include <vector>

#include "common/fem/enriched_mesh.hpp"

namespace stria::fine {

class MultiplierSpace {
public:
    /// From the pieces of `crack` that begin at or after the arc length `notch`.
    MultiplierSpace(const EnrichedMesh& mesh, int crack, double notch);

    [[nodiscard]] int size() const { return size_; }

    struct Value {
        int multiplier;
        double value;
    };
    /// The at most two multipliers that act at an arc length, adding up to one; -1: none.
    [[nodiscard]] std::array<Value, 2> at(double s) const;

    /// Arc length where a multiplier has its node (the middle of its support where it is folded).
    [[nodiscard]] const std::vector<double>& nodes() const { return nodes_; }

    /// Length of mesh chords: the spacing of interface nodes of the displacement mesh near a multiplier, mm.
    [[nodiscard]] const std::vector<double>& chords() const { return chords_; }

private:
    struct Station {
        double s;       // end of a stretch inside one element
        double measure;  // integral of ds / chord up to there
    };
    struct Branch {
        std::vector<Station> stations;  // the first is its start
        bool tip_at_start = false, tip_at_end = false;
        std::vector<double> hats;       // arc lengths of the hats' nodes
        int first_hat = 0, last_hat = 0;  // after folding the hats at tips into their neighbours
        int first_multiplier = 0;

        [[nodiscard]] double chords() const { return stations.back().measure - stations.front().measure; }
        [[nodiscard]] double position(double measure) const;
    };

    void split_into_branches(const EnrichedMesh& mesh, int crack, double notch);
    void join_short_branches();
    void place_hats(Branch& branch);

    std::vector<Branch> branches_;
    std::vector<double> nodes_, chords_;
    int size_ = 0;
};

}  // namespace stria::fine
