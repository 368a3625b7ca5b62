// A plate that a crack with contact cuts in two, for tests of its faces.
#pragma once

#include "fine/contact/contact_interface.hpp"
#include "tests/support/plates.hpp"

namespace stria::test {

using fine::ContactInterface;
using Jumps = ContactInterface::Jumps;

constexpr double contact_stiffness = 1000.0;

/// A crack through the whole plate, horizontal unless `right` differs from `left`.
struct Cut {
    explicit Cut(double left = 2.4, double right = 2.4, double notch = 0.0, double friction = 0.0)
        : from(0.0, left), to(8.0, right), input(plate_case({from, to})), mesh(plate_mesh(8, 5, input)) {
        input.cracks[0].notch = notch;
        input.cracks[0].contact->friction = friction;
    }
    [[nodiscard]] ContactInterface contact() const { return {mesh, {}, input.cracks, 2, contact_stiffness}; }
    [[nodiscard]] Eigen::VectorXd opened(const Field& above) const {
        return two_sided(mesh, from, to, above, [](const Vec2&) { return Vec2::Zero().eval(); });
    }

    Vec2 from, to;
    Case input;
    EnrichedMesh mesh;
};

}  // namespace stria::test
