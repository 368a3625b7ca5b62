// What of a zone rests: elements and multipliers that answer linearly about the state in which they came to rest
// (docs/equations.md, rest). Who condenses them says how; this says what is due on them, and what they have stored.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "common/index_set.hpp"
#include "coupling/messages.hpp"
#include "fine/bulk/bulk.hpp"
#include "fine/contact/contact_interface.hpp"

namespace stria::fine {

struct Resting {
    ElementSet elements;
    MultiplierSet multipliers;
};

/// Ids, ascending.
struct Restless {
    std::vector<int> elements, multipliers;
};

/// Elements that may rest (Bulk), without loads of their own or new faces that forces hold (`held`, N/mm, on the mesh),
/// and away from the tips about which the force ahead is asked for; multipliers that may (ContactInterface).
[[nodiscard]] Resting may_rest(const Bulk& bulk, const ContactInterface& contact, const coupling::Patch& patch,
                               const Eigen::VectorXd& held);

/// Vectors are of all unknowns of the mesh and then of the tractions.
class ZoneAtRest {
public:
    ZoneAtRest() = default;
    /// `inside`: unknowns that follow the others. Bulk and faces know what rests, and from where on.
    ZoneAtRest(const Bulk& bulk, const ContactInterface& contact, UnknownSet inside);

    [[nodiscard]] const UnknownSet& inside() const { return inside_; }
    /// What is due where it came to rest.
    [[nodiscard]] const Eigen::VectorXd& load() const { return load_; }
    /// Largest nodal force of the bulk there, N/mm.
    [[nodiscard]] double force_scale() const { return of_bulk_.lpNorm<Eigen::Infinity>(); }

    /// What it does to the others in the trial state; empty: nothing rests, or it is not known.
    [[nodiscard]] const Eigen::VectorXd& response() const { return response_; }
    void forget_response() { response_.resize(0); }
    void respond(const Eigen::VectorXd& load) { response_ = load; }

    /// What its bulk has stored, N, since the unknowns have `moved`, at which it has this response.
    [[nodiscard]] double energy(const Eigen::VectorXd& moved) const;

private:
    UnknownSet inside_;
    Eigen::VectorXd of_bulk_;  // due on the mesh because of the bulk alone, N/mm
    Eigen::VectorXd load_, response_;
};

}  // namespace stria::fine
