// What a body is made of: material 0 is that of the case, k that of its k-th region. An element is of one material
// (EnrichedMesh::material_of). With it comes the stress that the body has before any load.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "common/index.hpp"
#include "common/material/elasticity.hpp"
#include "common/material/initial_stress.hpp"

namespace stria {

class Materials {
public:
    Materials() = default;
    explicit Materials(const Case& input) : initial_stress_(input) {
        add(input.material, input.model.plane);
        for (const RegionSection& region : input.regions) add(region.material, input.model.plane);
    }
    /// A body of one.
    Materials(const MaterialSection& only, PlaneState plane) { add(only, plane); }

    [[nodiscard]] int count() const { return static_cast<int>(sections_.size()); }
    [[nodiscard]] const MaterialSection& section(int material) const { return sections_[at(material)]; }
    [[nodiscard]] const Elasticity& elastic(int material) const { return elastic_[at(material)]; }
    [[nodiscard]] const MandelMatrix& stiffness(int material) const { return stiffness_[at(material)]; }

    [[nodiscard]] const InitialStress& initial_stress() const { return initial_stress_; }

    /// Both answer a stress alike as long as nothing flows.
    [[nodiscard]] bool are_alike(int one, int other) const {
        return one == other || (elastic(one) == elastic(other) && initial_stress_.is_alike_in(one, other));
    }

    /// Elastic strain in the plane, xx, yy, 0, sqrt(2) xy, that material `of` would have at x under the stress of an
    /// element of `material`, less the one that is there. Zero where both are alike.
    [[nodiscard]] Mandel mismatch(int of, int material, const Vec2& x, const Mandel& stress) const {
        if (are_alike(of, material)) return Mandel::Zero();
        Mandel as_of = stress, as_is = stress;
        if (initial_stress_.any()) {
            as_of -= initial_stress_.at(x, of);
            as_is -= initial_stress_.at(x, material);
        }
        return elastic(of).strain_in_plane(as_of) - elastic(material).strain_in_plane(as_is);
    }

    /// MPa; infinite where the material never yields.
    [[nodiscard]] double yield_stress(int material) const {
        return section(material).yield_stress.value_or(std::numeric_limits<double>::infinity());
    }
    /// The smallest of them.
    [[nodiscard]] double weakest_yield_stress() const { return weakest_; }
    [[nodiscard]] bool may_yield() const { return weakest_ < std::numeric_limits<double>::infinity(); }

    /// What of a stress counts against the weakest yield stress: all of it in that material, less in stronger ones,
    /// nothing where nothing yields. In a body that never yields all of it counts.
    [[nodiscard]] double stress_weight(int material) const {
        return may_yield() ? weakest_ / yield_stress(material) : 1.0;
    }

    /// MPa.
    [[nodiscard]] double largest_plane_modulus() const {
        return std::ranges::max(elastic_, {}, &Elasticity::plane_modulus).plane_modulus();
    }

private:
    void add(const MaterialSection& section, PlaneState plane) {
        sections_.push_back(section);
        elastic_.push_back(elasticity_of(section, plane));
        stiffness_.push_back(elastic_.back().stiffness());
        weakest_ = std::min(weakest_, yield_stress(count() - 1));
    }

    InitialStress initial_stress_;
    std::vector<MaterialSection> sections_;
    std::vector<Elasticity> elastic_;
    std::vector<MandelMatrix> stiffness_;
    double weakest_ = std::numeric_limits<double>::infinity();  // yield stress, MPa
};

}  // namespace stria
