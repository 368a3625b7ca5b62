// What the zone remembers, written down and taken up again.
#include <ranges>

#include "common/error.hpp"
#include "common/index.hpp"
#include "fine/zone/zone_system.hpp"

namespace stria::fine {

coupling::ZoneSnapshot ZoneSystem::snapshot() const {
    coupling::ZoneSnapshot out;
    bulk_->remember(out);
    out.displacement = committed_.displacement;
    for (const Unknowns& increment : increments_.all()) out.increments.push_back(increment.displacement);
    out.held = opening_.held(patch_.mesh.unknowns);
    for (int k = 0; k < contact_->multipliers(); ++k) {
        const FaceOperators::Key& key = contact_->operators().keys()[at(k)];
        coupling::MultiplierSnapshot multiplier;
        multiplier.crack = key.crack;
        multiplier.place = key.x;
        multiplier.pressure = committed_.traction[k];
        multiplier.status = static_cast<std::int8_t>(contact_->committed_statuses()[at(k)]);
        for (const Unknowns& increment : increments_.all()) multiplier.increments.push_back(increment.traction[k]);
        if (const int shear = contact_->shear_of(k); shear >= 0) {
            multiplier.shear = committed_.traction[shear];
            for (const Unknowns& increment : increments_.all())
                multiplier.shear_increments.push_back(increment.traction[shear]);
        }
        out.multipliers.push_back(std::move(multiplier));
    }
    out.frozen_tips = frozen_.tips();
    return out;
}

void ZoneSystem::restore(const coupling::Patch& patch, const coupling::ZoneSnapshot& snapshot) {
    frozen_ = FrozenTips(snapshot.frozen_tips);
    make_contact(patch);
    const int multipliers = contact_->multipliers();
    require(std::ssize(snapshot.multipliers) == multipliers, "a snapshot has the multipliers of its zone");
    std::vector<FaceStatus> statuses;
    committed_ = {snapshot.displacement, Eigen::VectorXd(contact_->tractions())};
    std::vector<Unknowns> increments;
    for (const Eigen::VectorXd& displacement : snapshot.increments)
        increments.push_back({displacement, Eigen::VectorXd(contact_->tractions())});
    for (int k = 0; k < multipliers; ++k) {
        const coupling::MultiplierSnapshot& multiplier = snapshot.multipliers[at(k)];
        require(contact_->operators().keys()[at(k)].is_at(multiplier.crack, multiplier.place),
                "multipliers of a snapshot are in the order of the cracks");
        statuses.push_back(static_cast<FaceStatus>(multiplier.status));
        committed_.traction[k] = multiplier.pressure;
        for (std::size_t back = 0; back < increments.size(); ++back)
            increments[back].traction[k] = multiplier.increments.at(back);
        const int shear = contact_->shear_of(k);
        if (shear < 0) continue;
        committed_.traction[shear] = multiplier.shear;
        for (std::size_t back = 0; back < increments.size(); ++back)
            increments[back].traction[shear] = multiplier.shear_increments.at(back);
    }
    contact_->restore(std::move(statuses));
    increments_.clear();
    for (Unknowns& increment : increments | std::views::reverse) increments_.push(std::move(increment));
    opening_ = OpeningFaces(snapshot.held);
    const coupling::WorkCounts so_far = bulk_ ? bulk_->counts() : coupling::WorkCounts();
    bulk_ = std::make_unique<Bulk>(patch.mesh, make_law(), elastic_, rule(), snapshot);
    bulk_->count_on_from(so_far);
    begin_with(patch);
}

}  // namespace stria::fine
