// The ring forms of all tips of a structure.
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "coarse/fracture/ring_forms.hpp"
#include "coarse/structure/structure.hpp"

namespace stria::coarse {

/// Domain integrals, tip by tip and ring by ring.
using RingIntegrals = std::vector<std::vector<DomainIntegral>>;

class StructureRings {
public:
    /// `elements` must outlive their rings.
    explicit StructureRings(const CoarseElements& elements) : StructureRings(elements, forms_of(elements)) {}

    /// `forms`: of all tips, of these elements and maybe others of the same scene.
    StructureRings(const CoarseElements& elements, std::vector<RingForms> forms)
        : elements_(&elements), tips_(std::move(forms)) {}

    /// One per tip. `for_K`: as RingForms has it.
    [[nodiscard]] static std::vector<RingForms> forms_of(const CoarseElements& elements, const ElementSet& for_K = {});

    [[nodiscard]] const CoarseElements& elements() const { return *elements_; }
    [[nodiscard]] const RingForms& about(int tip) const { return tips_[at(tip)]; }

    /// The structure's share in the domain integrals, with the initial stress where there is one. `u`: displacement of
    /// the whole mesh, mm; that of near elements is read.
    [[nodiscard]] RingIntegrals integrals(const Eigen::VectorXd& u) const;
    /// The same of a structure that answers in proportion to its load factor (proportion.hpp): at the factor 1 it is
    /// looked at once. `found`: as Structure::near_of_unit_load has it.
    [[nodiscard]] RingIntegrals integrals_in_proportion(const Structure& structure, double load_factor,
                                                        std::int64_t& found);
    /// The same of a displacement alone.
    [[nodiscard]] RingIntegrals integrals_of_displacement(const Eigen::VectorXd& u) const;
    /// Hands out what it consists of.
    [[nodiscard]] std::vector<RingForms> take_forms() && { return std::move(tips_); }
    /// As many integrals, all NaN: nobody has looked.
    [[nodiscard]] RingIntegrals unknown() const;

private:
    const CoarseElements* elements_;
    std::vector<RingForms> tips_;
    std::optional<RingIntegrals> of_unit_load_;  // integrals_in_proportion()
};

}  // namespace stria::coarse
