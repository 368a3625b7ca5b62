#include "app/run/monolithic/monolithic.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "app/run/monolithic/loads.hpp"
#include "app/run/monolithic/matrix.hpp"
#include "coarse/elements/support_forces.hpp"
#include "coarse/equilibrium/condensed/condensed_equilibrium.hpp"
#include "coarse/equilibrium/factor_reuse.hpp"
#include "coarse/equilibrium/zone_residual.hpp"
#include "common/enrichment/part_of_mesh.hpp"
#include "common/index.hpp"
#include "common/linear/sparse_lu.hpp"

namespace stria {
namespace {

/// Unknowns: displacements of the whole mesh, then the contact multipliers, then the load factor.
class MonolithicEquilibrium : public coarse::Equilibrium {
public:
    MonolithicEquilibrium(const coarse::Structure& structure, fine::ZoneSystem& zone, const Eigen::VectorXd& committed,
                          const coarse::LoadFactors& factors)
        : structure_(structure), scene_(structure.scene()), zone_(zone), stiffness_(structure.elements().stiffness()),
          whole_(whole_unknowns(scene_.enriched, zone.patch().mesh)), loads_(structure, zone.patch(), whole_),
          committed_(committed), committed_factors_(factors), factors_(factors),
          increments_(remembered_increments(scene_.input.load.steps)) {
        for (int i = 0; i < std::ssize(whole_); ++i) committed_[whole_[at(i)]] = zone.displacement()[i];
        trial_ = committed_;
        held_.assign(at(scene_.enriched.unknowns), 0);
        for (const auto& p : scene_.prescribed) held_[at(p.unknown)] = 1;
        hold_unused();
    }

    void begin(const coarse::Target& target, const Predictor& predictor) override {
        const bool by_load = target.control == Control::Load;
        controlled_ = by_load ? coarse::LinearReading::load_factor(scene_.enriched.unknowns)
                              : coarse::LinearReading{scene_.displacement_weights, 0.0, 0.0};
        target_ = target.value;
        if (!predictor.goes_on) {
            trial_ = committed_;
            factors_.main = committed_factors_.main;
        }
        if (const Increment* earlier = increments_.find(predictor)) {
            trial_ += predictor.factor * earlier->displacement;
            factors_.main += predictor.factor * earlier->load_factor;
        }
        if (by_load) factors_.main = target_;
        factors_.cases = target.cases;
        impose_held();
        taken_.resize(0);
        reuse_ = coarse::FactorReuse(zone_.tolerance());
        zone_.predict(predictor);
        loading_ = {.load_factor = factors_.main, .cases = factors_.cases, .held = target.held};
        zone_.bear(loading_);
        zone_.set_boundary(on_boundary());
    }

    coarse::Residual linearise() override {
        zone_.linearise();
        const coupling::PatchResponse response = zone_.measure();
        yielding_ = response.digest.yielding_points;
        residual_ = loads_.under(factors_) - structure_.elements().internal_force(trial_);
        for (int i = 0; i < std::ssize(whole_); ++i) residual_[whole_[at(i)]] += zone_.load()[i];
        off_target_ = target_ - controlled_.at(trial_, factors_);
        coarse::Residual result;
        for (Eigen::Index i = 0; i < residual_.size(); ++i) {
            if (held_[at(i)] == 0) result.boundary = std::max(result.boundary, std::abs(residual_[i]));
        }
        result.nodal = result.boundary;
        result.scale = loads_.largest(factors_);
        result.target = std::abs(off_target_) / std::max({std::abs(target_), trial_.cwiseAbs().maxCoeff(), 1e-300});
        coarse::add_zone(result, response);
        result.keeps_factor = reuse_.below() > 0.0 && std::max(result.interior, result.contact) <= reuse_.below() &&
                              zone_.contact().statuses() == statuses_;
        reuse_.add(result);
        if (!result.keeps_factor) {
            tangent_ = MonolithicMatrix{scene_, stiffness_, zone_, whole_, held_, controlled_}.assembled();
            factor_.reset();
            statuses_ = zone_.contact().statuses();
        }
        const bool known = taken_.size() > 0 && controlled_.is_load_factor();
        result.along = known ? work_along_taken() : 0.0;
        result.along_before = known ? before_ : 0.0;
        return result;
    }

    double solve() override {
        const int n = scene_.enriched.unknowns, m = zone_.contact().tractions();
        Eigen::VectorXd right(n + m + 1);
        right << residual_, zone_.contact_right_hand_side(), off_target_;
        for (int i = 0; i < n; ++i) right[i] = held_[at(i)] != 0 ? 0.0 : right[i];
        if (!factor_) factor_.emplace(tangent_);
        correction_ = factor_->solve(right);
        const double move = correction_.head(n).cwiseAbs().maxCoeff();
        return move / std::max({trial_.cwiseAbs().maxCoeff(), move, 1e-300});
    }

    void apply() override {
        taken_ = correction_;
        before_ = work_along_taken();
        apply_further(1.0);
    }

    void apply_further(double part) override {
        const int n = scene_.enriched.unknowns, m = zone_.contact().tractions();
        const Eigen::VectorXd move = part * taken_;
        trial_ += move.head(n);
        factors_.main += move[n + m];
        impose_held();
        zone_.move(gather(move.head(n), whole_), move.segment(n, m));
        loading_.load_factor = factors_.main;
        zone_.bear(loading_);
        zone_.set_boundary(on_boundary());
    }

    void set_elastic(bool elastic) override {
        loading_.elastic = elastic;
        zone_.bear(loading_);
    }

    void put_aside() override {
        increments_.put_aside({trial_ - committed_, factors_.main - committed_factors_.main});
        zone_.put_aside();
    }

    coupling::StepReport commit(const coupling::Commit& what) override {
        increments_.push({trial_ - committed_, factors_.main - committed_factors_.main});
        committed_ = trial_;
        committed_factors_ = factors_;
        return zone_.commit(what);
    }

    void rollback() override {
        trial_ = committed_;
        factors_ = committed_factors_;
    }

    [[nodiscard]] coarse::EquilibriumState state() const override {
        coarse::EquilibriumState state;
        state.load_factor = committed_factors_.main;
        state.cases = committed_factors_.cases;
        state.whole = committed_;
        state.displacement = gather(committed_, structure_.gamma());
        for (const Increment& increment : increments_.all()) {
            state.whole_increments.push_back(increment.displacement);
            state.increments.push_back(gather(increment.displacement, structure_.gamma()));
            state.load_increments.push_back(increment.load_factor);
        }
        return state;
    }

    // Where a condensed run has left Gamma alone, structure and zone say what lies on either side of it. A zone may
    // have lost what the structure has kept: about a tip that has grown its part of the mesh need not come to lie on
    // itself where the whole mesh does (TipMoves). Inside it nothing is foretold then, as in a condensed run.
    void restore(const coarse::EquilibriumState& state) override {
        const auto& of_zone = zone_.increments();
        increments_.clear();
        for (std::size_t back = state.increments.size(); back-- > 0;) {
            Eigen::VectorXd whole;
            if (back < state.whole_increments.size()) {
                whole = state.whole_increments[back];
            } else {
                whole = structure_.expand(state.increments[back], state.load_increments[back]);
                if (back < of_zone.size()) whole(whole_) = of_zone[back].displacement;
            }
            increments_.push({std::move(whole), state.load_increments[back]});
        }
        trial_ = committed_ = state.whole.size() > 0 ? state.whole : committed_;
        committed_factors_ = factors_ = {state.load_factor, state.cases};
    }

    [[nodiscard]] coarse::LoadFactors factors() const override { return factors_; }
    [[nodiscard]] const std::vector<std::int32_t>& yielding_points() const override { return yielding_; }

    [[nodiscard]] Eigen::VectorXd structure_displacement() const override {
        Eigen::VectorXd u = trial_;
        for (int i = 0; i < std::ssize(whole_); ++i) {
            if (!std::ranges::binary_search(zone_.patch().boundary, i)) u[whole_[at(i)]] = 0.0;
        }
        return u;
    }

    [[nodiscard]] const Eigen::VectorXd& near_displacement() const override {
        return expanded_ = structure_displacement();
    }

    [[nodiscard]] coarse::MachineReading machine_reading() const override {
        Eigen::VectorXd forces = coarse::forces_on_prescribed(structure_.elements(), trial_);
        Eigen::VectorXd other = -loads_.initial();
        for (int i = 0; i < std::ssize(whole_); ++i) other[whole_[at(i)]] -= zone_.load()[i];
        double imposed_force = 0.0;
        Eigen::VectorXd of_cases = Eigen::VectorXd::Zero(std::ssize(scene_.case_forces));
        Eigen::Index k = 0;
        for (const coarse::PrescribedUnknown& p : scene_.prescribed) {
            const double force = forces[k++] += other[p.unknown];
            imposed_force += p.value * force;
            for (Eigen::Index c = 0; c < of_cases.size(); ++c) of_cases[c] += p.in_case(c) * force;
        }
        const Eigen::VectorXd outer = coarse::loads_on_prescribed(scene_, loads_.under(factors_) - loads_.initial());
        return {scene_.displacement_weights.dot(structure_displacement()), scene_.pull.dot(forces - outer),
                imposed_force, of_cases};
    }

private:
    [[nodiscard]] double work_along_taken() const {
        double work = 0.0;
        for (Eigen::Index i = 0; i < residual_.size(); ++i)
            if (held_[at(i)] == 0) work += residual_[i] * taken_[i];
        return work;
    }

    void impose_held() { coarse::impose(scene_.prescribed, factors_, trial_); }

    [[nodiscard]] Eigen::VectorXd on_boundary() const {
        std::vector<int> unknowns;
        for (const int i : zone_.patch().boundary) unknowns.push_back(whole_[at(i)]);
        return gather(trial_, unknowns);
    }

    // Terms that no element sees have no stiffness: they stay zero.
    void hold_unused() {
        std::vector<char> used(held_.size(), 0);
        structure_.elements().for_each([&](const auto& op) {
            for (const int unknown : op.unknowns) used[at(unknown)] = 1;
        });
        for (const ElementOperator& op : zone_.bulk().operators())
            for (const int unknown : op.unknowns) used[at(whole_[at(unknown)])] = 1;
        std::ranges::transform(held_, used, held_.begin(),
                               [](char held, char is_used) { return is_used != 0 ? held : char{1}; });
    }

    const coarse::Structure& structure_;
    const coarse::Scene& scene_;
    fine::ZoneSystem& zone_;
    fine::ZoneLoading loading_;
    std::vector<std::int32_t> yielding_;  // points, per element of the zone
    SparseMatrix stiffness_;
    std::vector<int> whole_;                  // whole-mesh unknown of each zone unknown
    SparseMatrix tangent_;                    // of the last iterate that did not keep it
    std::optional<SparseLu> factor_;          // of it, once a correction is asked for
    std::vector<fine::FaceStatus> statuses_;  // there
    coarse::FactorReuse reuse_{0.0};
    coarse::LinearReading controlled_;
    double target_ = 0.0, off_target_ = 0.0;
    MonolithicLoads loads_;
    Eigen::VectorXd committed_, trial_, residual_, correction_, taken_;
    double before_ = 0.0;  // work of the residual along what is taken, before it was
    coarse::LoadFactors committed_factors_, factors_;
    struct Increment {
        Eigen::VectorXd displacement;
        double load_factor;
    };
    IncrementMemory<Increment> increments_;
    std::vector<char> held_;
    mutable Eigen::VectorXd expanded_;  // near_displacement()
};

}  // namespace

std::unique_ptr<coarse::Equilibrium> MonolithicFactory::make(const coarse::Structure& structure,
                                                             const coupling::Patch* patch,
                                                             const Eigen::VectorXd& committed,
                                                             const coarse::LoadFactors& factors) {
    if (patch == nullptr)
        return std::make_unique<coarse::CondensedEquilibrium>(structure, nullptr, input_, committed, factors);
    zone_.set_patch(*patch);
    return std::make_unique<MonolithicEquilibrium>(structure, zone_, committed, factors);
}

std::unique_ptr<coarse::Equilibrium> MonolithicFactory::resume(const coarse::Structure& structure,
                                                               const coupling::Patch* patch,
                                                               const Eigen::VectorXd& committed,
                                                               const coupling::ZoneSnapshot& zone) {
    if (patch == nullptr)
        return std::make_unique<coarse::CondensedEquilibrium>(structure, nullptr, input_, committed, 0.0);
    zone_.restore(*patch, zone);
    zone_.wake_all();
    return std::make_unique<MonolithicEquilibrium>(structure, zone_, committed, 0.0);
}

}  // namespace stria
