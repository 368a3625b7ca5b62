#include "fine/zone/zone_memory.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <ranges>
#include <utility>

#include "common/error.hpp"
#include "common/geometry/segment.hpp"
#include "common/index.hpp"
#include "common/integration/moved_field.hpp"
#include "common/integration/parts_of_elements.hpp"
#include "coupling/moved_increments.hpp"

namespace stria::fine {

void freeze_what_is_left(FrozenTips& frozen, const Eigen::VectorXd& u, const EnrichedMesh& before,
                         const coupling::Patch& next) {
    for (int t = 0; t < std::ssize(before.tips); ++t) {
        const Tip& tip = before.tips[at(t)];
        const auto same = [&](const Tip& other) { return same_place(tip, other); };
        const bool stays = next.mesh.tip_functions > 0 && std::ranges::any_of(next.mesh.tips, same);
        if (!stays && std::ranges::none_of(next.mesh.left_tips, same)) frozen.freeze(before, t, u);
    }
    frozen.keep_closed(before, next.mesh, carry_over(before, u, next.mesh, next.displacement));
}

namespace {

/// Tractions on new faces as they were behind the old tip, linear between two multipliers there.
class MovedTractions {
public:
    MovedTractions(const TipMoves& moves, const ContactInterface& old, const ContactInterface& contact)
        : old_(old), contact_(contact), from_(at(contact.multipliers())) {
        const auto& keys = old.operators().keys();
        for (int k = 0; k < contact.multipliers(); ++k) {
            const FaceOperators::Key& own = contact.operators().keys()[at(k)];
            const Vec2 behind = own.x - moves.of_nearest_tip(own.x);
            double nearest = std::numeric_limits<double>::infinity();
            for (int j = 0; j < std::ssize(keys); ++j) {
                if (keys[at(j)].crack != own.crack) continue;
                const bool has_next = j + 1 < std::ssize(keys) && keys[at(j + 1)].crack == own.crack;
                const int second = has_next ? j + 1 : j;
                const Vec2 &a = keys[at(j)].x, &b = keys[at(second)].x;
                const double distance = distance_to_segment(behind, a, b);
                if (distance >= nearest) continue;
                nearest = distance;
                const double length = (b - a).squaredNorm();
                from_[at(k)] = {j, second, length > 0.0 ? std::clamp((behind - a).dot(b - a) / length, 0.0, 1.0) : 0.0};
            }
        }
    }

    [[nodiscard]] Eigen::VectorXd of(const Eigen::VectorXd& traction) const {
        Eigen::VectorXd moved = Eigen::VectorXd::Zero(contact_.tractions());
        for (int k = 0; k < contact_.multipliers(); ++k) {
            const auto& [first, second, part] = from_[at(k)];
            if (first < 0) continue;
            moved[k] = (1.0 - part) * traction[first] + part * traction[second];
            const int shear = contact_.shear_of(k), a = old_.shear_of(first), b = old_.shear_of(second);
            if (shear >= 0 && a >= 0 && b >= 0) moved[shear] = (1.0 - part) * traction[a] + part * traction[b];
        }
        return moved;
    }

private:
    struct Between {
        int first = -1, second = -1;  // multipliers of the old faces; -1: none
        double part = 0.0;            // of the second
    };
    const ContactInterface &old_, &contact_;
    std::vector<Between> from_;
};

/// Increments known about the old tips as guesses about the new ones. All faces of a crack are those of one rank.
void move_increments(ZoneMemory& memory, const ContactInterface& old_contact, const ContactInterface& contact,
                     const coupling::MovedIncrements& known) {
    const MovedTractions tractions(known.moves, old_contact, contact);
    std::vector<ZoneUnknowns> moved;
    for (Eigen::Index k = 0; k < known.displacement.cols(); ++k)
        moved.push_back({known.displacement.col(k), tractions.of(memory.increments.all().at(at(k)).traction)});
    memory.increments.clear();
    for (ZoneUnknowns& increment : moved | std::views::reverse) memory.increments.push(std::move(increment));
}

}  // namespace

void carry_unknowns(ZoneMemory& memory, const EnrichedMesh& before, const ContactInterface* old_contact,
                    const coupling::Patch& next, ContactInterface& contact) {
    ZoneUnknowns carried{next.displacement, Eigen::VectorXd::Zero(contact.tractions())};
    if (old_contact != nullptr) {
        const ZoneUnknowns& committed = memory.committed;
        carried.displacement =
            carry_over(before, committed.displacement, next.mesh,
                       on_parts(before, committed.displacement, next.mesh, next.part_of, next.displacement));
        const std::vector<int> old_place = contact.operators().places_in(old_contact->operators());
        std::vector<FaceStatus> statuses(at(contact.multipliers()), FaceStatus::Open);
        ContactInterface::Approach approach = contact.approach();
        const ContactInterface::Approach& old_approach = old_contact->approach();
        for (int k = 0; k < contact.multipliers(); ++k) {
            const int old = old_place[at(k)];
            if (old < 0) continue;
            contact.resting().set_changes(k, old_contact->resting().changes(old));
            statuses[at(k)] = old_contact->committed_statuses()[at(old)];  // faces that press may come to rest
            approach.widened[k] = old_approach.widened[old];
            approach.slid[k] = old_approach.slid[old];
            approach.until_met[k] = old_approach.until_met[old];
            carried.traction[k] = committed.traction[old];
            if (contact.shear_of(k) >= 0 && old_contact->shear_of(old) >= 0)
                carried.traction[contact.shear_of(k)] = committed.traction[old_contact->shear_of(old)];
        }
        contact.restore(std::move(statuses), std::move(approach));
    }
    memory.committed = std::move(carried);
}

void carry_increments(ZoneMemory& memory, const EnrichedMesh& before, const ContactInterface& old_contact,
                      const coupling::Patch& next, const ContactInterface& contact) {
    if (&contact == &old_contact && !next.shared) {
        const std::optional<TipMoves> moves = TipMoves::between(before, next.mesh);
        if (moves && moves->are_none()) return;
    }
    const auto of_one_rank = [&] {
        const auto& known = memory.increments.all();
        Eigen::MatrixXd increments(before.unknowns, std::ssize(known));
        for (std::size_t k = 0; k < known.size(); ++k)
            increments.col(static_cast<Eigen::Index>(k)) = known[k].displacement;
        return increments;
    };
    const coupling::MovedIncrements moved =
        next.shared ? next.moved : coupling::moved_increments(before, next.mesh, of_one_rank);
    move_increments(memory, old_contact, contact, moved);
}

Eigen::VectorXd slips_to_hold(const ContactInterface& before, const Eigen::VectorXd& committed,
                              const ContactInterface& next, const Eigen::VectorXd& now) {
    const Eigen::VectorXd held = before.settled_slips() - before.operators().slips(committed);
    const std::vector<int> old_place = next.operators().places_in(before.operators());
    Eigen::VectorXd slips = next.operators().slips(now);
    for (int k = 0; k < next.multipliers(); ++k)
        if (old_place[at(k)] >= 0) slips[k] += held[old_place[at(k)]];
    return slips;
}

Eigen::VectorXd settled_slips_in(const coupling::ZoneSnapshot& snapshot) {
    Eigen::VectorXd slips(std::ssize(snapshot.multipliers));
    for (Eigen::Index k = 0; k < slips.size(); ++k) slips[k] = snapshot.multipliers[at(k)].settled_slip;
    return slips;
}

void write(const ZoneMemory& memory, const ContactInterface& contact, coupling::ZoneSnapshot& out) {
    const auto& increments = memory.increments.all();
    out.displacement = memory.committed.displacement;
    for (const ZoneUnknowns& increment : increments) out.increments.push_back(increment.displacement);
    out.held = memory.opening.held(static_cast<int>(memory.committed.displacement.size()));
    for (int k = 0; k < contact.multipliers(); ++k) {
        const FaceOperators::Key& key = contact.operators().keys()[at(k)];
        coupling::MultiplierSnapshot multiplier;
        multiplier.crack = key.crack;
        multiplier.place = key.x;
        multiplier.pressure = memory.committed.traction[k];
        multiplier.status = static_cast<std::int8_t>(contact.committed_statuses()[at(k)]);
        multiplier.widened = contact.approach().widened[k];
        multiplier.slid = contact.approach().slid[k];
        multiplier.until_met = contact.approach().until_met[k];
        multiplier.settled_slip = contact.settled_slips()[k];
        multiplier.changes = contact.resting().changes(k);
        multiplier.resting = contact.resting().contains(k) ? 1 : 0;
        multiplier.rest_pressure = contact.resting().traction()[k];
        for (const ZoneUnknowns& increment : increments) multiplier.increments.push_back(increment.traction[k]);
        if (const int shear = contact.shear_of(k); shear >= 0) {
            multiplier.shear = memory.committed.traction[shear];
            multiplier.rest_shear = contact.resting().traction()[shear];
            for (const ZoneUnknowns& increment : increments)
                multiplier.shear_increments.push_back(increment.traction[shear]);
        }
        out.multipliers.push_back(std::move(multiplier));
    }
    out.frozen_tips = memory.frozen.tips();
}

namespace {

void take_up_rest(ContactInterface& contact, const coupling::ZoneSnapshot& snapshot) {
    std::vector<FaceStatus> statuses;
    MultiplierSet resting(contact.multipliers());
    Eigen::VectorXd traction = Eigen::VectorXd::Zero(contact.tractions());
    ContactInterface::Approach approach = contact.approach();
    for (int k = 0; k < contact.multipliers(); ++k) {
        const coupling::MultiplierSnapshot& multiplier = snapshot.multipliers[at(k)];
        approach.widened[k] = multiplier.widened;
        approach.slid[k] = multiplier.slid;
        approach.until_met[k] = multiplier.until_met;
        statuses.push_back(static_cast<FaceStatus>(multiplier.status));
        contact.resting().set_changes(k, multiplier.changes);
        if (multiplier.resting != 0) resting.insert(k);
        traction[k] = multiplier.rest_pressure;
        if (contact.shear_of(k) >= 0) traction[contact.shear_of(k)] = multiplier.rest_shear;
    }
    contact.restore(std::move(statuses), std::move(approach));
    contact.resting().rest(std::move(resting), traction);
}

}  // namespace

void take_up(ZoneMemory& memory, ContactInterface& contact, const EnrichedMesh& mesh,
             const coupling::ZoneSnapshot& snapshot) {
    require(std::ssize(snapshot.multipliers) == contact.multipliers(), "a snapshot has the multipliers of its zone");
    memory.committed = {snapshot.displacement, Eigen::VectorXd(contact.tractions())};
    std::vector<ZoneUnknowns> increments;
    for (const Eigen::VectorXd& displacement : snapshot.increments)
        increments.push_back({displacement, Eigen::VectorXd(contact.tractions())});
    for (int k = 0; k < contact.multipliers(); ++k) {
        const coupling::MultiplierSnapshot& multiplier = snapshot.multipliers[at(k)];
        require(contact.operators().keys()[at(k)].is_at(multiplier.crack, multiplier.place),
                "multipliers of a snapshot are in the order of the cracks");
        memory.committed.traction[k] = multiplier.pressure;
        for (std::size_t back = 0; back < increments.size(); ++back)
            increments[back].traction[k] = multiplier.increments.at(back);
        const int shear = contact.shear_of(k);
        if (shear < 0) continue;
        memory.committed.traction[shear] = multiplier.shear;
        for (std::size_t back = 0; back < increments.size(); ++back)
            increments[back].traction[shear] = multiplier.shear_increments.at(back);
    }
    memory.increments.clear();
    for (ZoneUnknowns& increment : increments | std::views::reverse) memory.increments.push(std::move(increment));
    memory.opening = OpeningFaces(snapshot.held, cracks_of_unknowns(mesh));
    take_up_rest(contact, snapshot);
}

}  // namespace stria::fine
