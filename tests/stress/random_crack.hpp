// Random meshes with random cracks on them, of the kinds that hurt: near nodes and along edges, past slivers, with very
// short and very long segments, and with mouths on slanted and curved sides.
#pragma once

#include <random>
#include <string>
#include <vector>

#include "common/fem/mesh.hpp"

namespace stria::test {

/// Uniform numbers that depend on the seed alone.
class Dice {
public:
    explicit Dice(unsigned seed) : random_(seed) {}
    double between(double low, double high) {
        return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
    }
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    bool one_in(int n) { return below(n) == 0; }
    /// 10 to a power between two.
    double decade(double low, double high);

private:
    std::mt19937 random_;
};

struct CrackedPlate {
    Mesh mesh;
    double h = 0.0;  // mm, of its elements
    std::string mesh_name;
    std::vector<Vec2> points;  // of the crack
    bool straight = true;
};

/// A unit square, plain, distorted or graded, or one with a slanted or a curved left side.
CrackedPlate random_crack(unsigned seed);

}  // namespace stria::test
