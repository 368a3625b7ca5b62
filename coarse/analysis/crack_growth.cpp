#include "coarse/analysis/crack_growth.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <utility>

#include "coarse/analysis/K_at_extremes.hpp"
#include "coarse/enrichment/retained_functions.hpp"
#include "coarse/enrichment/tip_reach.hpp"
#include "coarse/growth/crack_advance.hpp"
#include "coarse/growth/growth_law.hpp"
#include "coarse/growth/growth_texts.hpp"
#include "coarse/load/growth_schedule.hpp"
#include "common/case/case_questions.hpp"
#include "common/crack/crack_end.hpp"
#include "common/crack/crack_path.hpp"
#include "common/error.hpp"
#include "common/index.hpp"

namespace stria::coarse {

CrackGrowth::CrackGrowth(const Case& input, const Note& note, GrowthMemory memory)
    : growth_(*input.growth), note_(note), ended_(memory.ended), turns_late_(memory.turns_late),
      increment_(std::move(memory.increment)), rates_(input, std::move(memory.rates)),
      K_reached_(std::move(memory.K_reached)), before_(std::move(memory.before)), extremes_(std::move(memory.extremes)),
      turning_(std::move(memory.turning)), swing_(input, std::move(memory.swing)) {}

GrowthMemory CrackGrowth::memory() const {
    return {.ended = ended_,
            .increment = increment_.memory(),
            .rates = rates_.memory(),
            .K_reached = K_reached_,
            .before = before_,
            .extremes = extremes_,
            .turning = turning_,
            .turns_late = turns_late_,
            .swing = swing_.memory()};
}

void CrackGrowth::take(const Increment& reached, const Scene& present) {
    const LoadStep& step = reached.step;
    const LoadFactors factors{reached.load_factor, step.target.cases};
    std::vector<ModesOfTip> modes = modes_let_through(present, reached.nominal, factors, reached.tips);
    const std::vector<double> K = K_of_break(present, growth_.direction, modes);
    K_reached_.resize(reached.tips.size());
    for (std::size_t t = 0; t < K_reached_.size(); ++t) {
        K_reached_[t].of_break = std::max(K_reached_[t].of_break, K[t]);
        K_reached_[t].K_I = std::max(K_reached_[t].K_I, reached.K_at_end(t));
    }
    if (step.at_minimum) note_minimum(extremes_, factors, reached);
    if (step.ends_cycle) {
        if (growth_.at == GrowthAt::Minimum) lengthen(turning_.minimum, present, reached.nominal, extremes_.minimum);
        note_cycle(modes);
    }
    if (step.at_minimum) turning_.minimum = std::move(modes);
    if (step.at_maximum) note_maximum(extremes_, factors, reached);
}

// One cycle stands for all where they are alike.
void CrackGrowth::note_cycle(const std::vector<ModesOfTip>& maximum) {
    if (is_prescribed(growth_) || turning_.minimum.size() != maximum.size()) return;
    if (!rates_.are_means()) turning_.cycles.clear();
    turning_.cycles.insert(turning_.cycles.end(), maximum.begin(), maximum.end());
    turning_.cycles.insert(turning_.cycles.end(), turning_.minimum.begin(), turning_.minimum.end());
}

// A tip may break in any cycle, at a maximum, and not only where and when cracks grow. A mean rate wants its period.
bool CrackGrowth::is_due_at(const LoadStep& step) const {
    if (grows_at(growth_, step)) return true;
    return broken_tip() >= 0 && step.ends_cycle && (!rates_.are_means() || ends_period(growth_, step.cycle));
}

GrownScene CrackGrowth::next(const CrackedBody& body, const std::vector<CycleResult>& last) {
    if (!is_prescribed(growth_) && last.empty()) return {};  // no cycle has told a rate yet
    const std::vector<TipResult>& nominal = body.nominal();
    const Scene& present = body.scene();
    const std::vector<TipResult> guides = K_that_turns(body, extremes_);
    const std::set<std::size_t> started = start_by_turns(body, guides, last);
    GrownScene grown;
    if (!is_over(nominal, last)) {
        if (!rates_.are_of_a_whole_period()) return {};
        grown = along_first_of(body, ways(present, guides, last));
        if (grown.longer) note_turns(body, *grown.longer, last, started);
        if (grown.longer) note_functions(present.enriched, *grown.longer);
    }
    ended_ = !grown.longer;
    if (grown.longer) {
        before_ = reached(last);
        K_reached_.clear();
        turning_.cycles.clear();
    }
    return grown;
}

// From one element edge to another where faces end on edges; where they end is not known about another direction.
TipSteps CrackGrowth::steps_about(std::size_t fastest, const Scene& present, double turn,
                                  const std::vector<double>& elements) const {
    TipSteps steps{.tip = fastest, .least = elements[fastest]};
    if (present.enriched.tip_functions > 0) return steps;
    steps.element = elements[fastest];
    if (turn <= sharp_turn) steps.beyond = present.enriched.tips[fastest].beyond;
    return steps;
}

double CrackGrowth::increment_of_fastest(const std::vector<CycleResult>& last, const Scene& present, double turn,
                                         const std::vector<double>& elements) {
    const std::vector<Tip>& tips = present.enriched.tips;
    const std::vector<double> lengthening = rates_.lengthening(tips);
    if (is_prescribed(growth_)) return growth_.increment.value();
    const double by_law =
        growth_.increment.is_auto()
            ? increment_.next(growth_, last, rates_.present(), lengthening,
                              steps_about(fastest_of(rates_.shares(tips.size())), present, turn, elements))
            : cut_to_end(growth_.increment.value(), growth_, last, lengthening);
    return growth_.toughness ? cut_to_toughness(by_law, *growth_.toughness, reached(last), before_, lengthening)
                             : by_law;
}

std::vector<LengthAndK> CrackGrowth::reached(const std::vector<CycleResult>& last) const {
    std::vector<LengthAndK> tips;
    for (std::size_t t = 0; t < std::min(last.size(), K_reached_.size()); ++t)
        tips.push_back({last[t].a, K_reached_[t].of_break});
    return tips;
}

std::vector<CrackGrowth::Cracks> CrackGrowth::ways(const Scene& present, const std::vector<TipResult>& guides,
                                                   const std::vector<CycleResult>& last) {
    const std::vector<Tip>& tips = present.enriched.tips;
    const std::vector<double> shares = rates_.shares(tips.size());
    std::vector<double> elements;
    for (const Tip& tip : tips) elements.push_back(tip_element_edge(present.enriched, tip));
    const auto by = [&](double increment, GrowthDirection direction) {
        std::vector<TipAdvance> advances;
        for (std::size_t t = 0; t < guides.size(); ++t)
            advances.push_back({tips[t], guides[t].K_I, guides[t].K_II, shares[t] * increment, elements[t]});
        Cracks longer = longer_cracks(present.input.cracks, direction, advances);
        turn_where_faces_end(longer, present.enriched);
        return longer;
    };
    const double element = elements.empty() ? 0.0 : std::ranges::max(elements);
    const double turn = largest_turn(tips, by(element, growth_.direction));
    const double increment = increment_of_fastest(last, present, turn, elements);
    std::vector<Cracks> ways{by(increment, growth_.direction)};
    warn_of_sharp_turns(tips, ways.front(), elements);
    constexpr double small_turn = 0.01;  // of a tip with K_II = 0.005 K_I
    // What turns by next to nothing may go straight on for a while: out of an element edge that it runs along.
    if (largest_turn(tips, ways.front()) < small_turn) ways.push_back(by(increment, GrowthDirection::Straight));
    return ways;
}

void CrackGrowth::warn_of_sharp_turns(const std::vector<Tip>& tips, const Cracks& longer,
                                      const std::vector<double>& elements) const {
    for (std::size_t t = 0; t < tips.size(); ++t) {
        if (std::abs(turn_of(tips[t], longer)) <= sharp_turn) continue;
        const double grows = (end_of(longer[at(tips[t].crack)], tips[t]) - tips[t].position).norm();
        if (const auto warning = turns_sharply(t, grows, elements[t])) note_(*warning);
    }
}

// K before a sharp turn is that of another direction: in shear it is next to nothing, and what the mesh makes of that
// must not tell one tip from another.
std::set<std::size_t> CrackGrowth::start_by_turns(const CrackedBody& body, const std::vector<TipResult>& guides,
                                                  const std::vector<CycleResult>& last) {
    std::set<std::size_t> started;
    untold_turn_.reset();
    if (is_prescribed(growth_) || growth_.direction == GrowthDirection::Straight || last.empty()) return started;
    if (!rates_.are_of_a_whole_period()) return started;
    const Scene& present = body.scene();
    const std::vector<double> rates = rates_.present();
    for (std::size_t t = 0; t < std::min(rates.size(), guides.size()); ++t) {
        const double angle = hoop_stress_angle(guides[t].K_I, guides[t].K_II);
        if (std::abs(angle) <= sharp_turn) continue;
        const CrackSection& crack = present.input.cracks[at(present.enriched.tips[t].crack)];
        // Of cycles that differ no single one tells what follows.
        const double rate =
            rates_.end_with_the_cycle() ? std::nan("") : rate_behind_turn(growth_, crack, turning_, t, angle);
        if (std::isnan(rate)) untold_turn_ = {t, angle};
        if (!(rates[t] < rate)) continue;  // nor is it known
        started.insert(t);
        rates_.start(t, rate);
    }
    return started;
}

// Where the cycles that follow are other ones their rates are too. Rates are those of nominal K, before and behind.
void CrackGrowth::note_turns(const CrackedBody& body, const Scene& longer, const std::vector<CycleResult>& last,
                             const std::set<std::size_t>& started) {
    if (is_prescribed(growth_) || last.empty() || rates_.end_with_the_cycle()) return;
    const std::vector<TipResult> most = K_at_maximum(body, extremes_), least = K_at_minimum(body, extremes_);
    std::vector<SharpTurn> turns;
    for (std::size_t t = 0; t < last.size(); ++t) {
        const double angle = turn_of(body.scene().enriched.tips[t], longer.input.cracks);
        if (std::abs(angle) > sharp_turn && !started.contains(t))
            turns.push_back({t, leap_at_turn(growth_, last[t], {most[t], least[t]}, angle)});
    }
    rates_.leap(turns);
}

void CrackGrowth::note_functions(const EnrichedMesh& before, const Scene& longer) {
    const bool stand = longer.enriched.tip_functions > 0;
    if (stand != (before.tip_functions > 0)) note_(functions_change(stand));
    if (growth_.retain != Retain::All || !longer.materials.may_yield()) return;
    for (const int tip : tips_nearly_where_they_were(longer.enriched, before))
        if (said_to_freeze_.insert(tip).second) note_(functions_frozen(tip));
}

// What drives the tips has been measured.
void CrackGrowth::require_drive(const std::vector<CycleResult>& last) const {
    const std::vector<double> rates = rates_.present();
    const auto unread = std::ranges::find_if(rates, [](double rate) { return !std::isfinite(rate); });
    if (unread == rates.end()) return;
    const auto tip = unread - rates.begin();
    if (std::isinf(*unread)) throw NumericalFailure(rate_is_infinite(growth_.law, tip));
    if (growth_.law == GrowthLaw::Ctod)
        throw NumericalFailure(fmt::format("tip {}: no opening range at closure.distance behind it, which drives the "
                                           "growth: the crack is shorter than that",
                                           tip));
    if (!grows_by_opening_loads(growth_) || std::isnan(last[at(tip)].K_max))
        throw NumericalFailure(fmt::format("K drives the growth, and no ring about tip {} tells it: an edge, a load, a "
                                           "bend or another tip is too near; smaller elements there may, or behind a "
                                           "sharp turn a larger growth.increment",
                                           tip));
    throw NumericalFailure(fmt::format(
        "K_op drives the growth, and no equilibrium of {} tells it for tip {}; finer increments (load.steps) may",
        rates_.are_means() ? "a cycle since the growth before" : "the last cycle", tip));
}

int CrackGrowth::broken_tip() const {
    if (!growth_.toughness) return -1;
    const auto tip = std::ranges::find_if(K_reached_, [&](const auto& K) { return K.of_break >= *growth_.toughness; });
    return tip != K_reached_.end() ? static_cast<int>(tip - K_reached_.begin()) : -1;
}

bool CrackGrowth::is_over(const std::vector<TipResult>& nominal, const std::vector<CycleResult>& last) const {
    if (const int tip = broken_tip(); tip >= 0) {
        note_(breaks(tip, K_reached_[at(tip)].of_break, K_reached_[at(tip)].K_I));
        return true;
    }
    const auto longest =
        std::ranges::find_if(nominal, [&](const auto& t) { return is_as_long_as_asked(growth_, t.a); });
    if (longest != nominal.end()) {
        note_(fmt::format("tip {}: the crack is {:.6g} mm long (growth.until)", longest - nominal.begin(), longest->a));
        return true;
    }
    require_drive(last);
    if (last.empty() || rates_.drive_a_tip() || !rates_.are_of_a_whole_period()) return false;
    note_(is_arrested(rates_.end_with_the_cycle(), untold_turn_));
    return true;
}

// The first way that the mesh can hold, or the first bent a little later or earlier.
GrownScene CrackGrowth::along_first_of(const CrackedBody& body, const std::vector<Cracks>& ways) {
    std::string why;
    bool left_the_mesh = false;
    GrownScene grown;
    const auto is_held = [&](const Cracks& cracks) {
        try {
            grown = with_cracks(body, cracks);
            return true;
        } catch (const CaseError& error) {
            if (!why.empty()) return false;
            why = why_no_longer(error);
            left_the_mesh = dynamic_cast<const CrackOffMesh*>(&error) != nullptr;
            return false;
        }
    };
    if (std::ranges::any_of(ways, is_held)) {
        turns_late_ = false;
        return grown;
    }
    if (left_the_mesh && std::ranges::any_of(turned_at_ends_of_edges(ways.front(), body.scene().enriched), is_held)) {
        const double angle = largest_turn(body.scene().enriched.tips, ways.front());
        if (!std::exchange(turns_late_, true)) note_(turns_at_end_of_edge(angle, angle > sharp_turn));
        return grown;
    }
    if (left_the_mesh && std::ranges::any_of(bent_before_edges(ways.front(), body.scene().enriched), is_held)) {
        note_("a crack bends a little before its tip: at the tip the mesh cannot hold the bend");
        return grown;
    }
    left_the_mesh_ = left_the_mesh;
    note_(growth_ends(why, left_the_mesh));
    return {};
}

GrownScene CrackGrowth::with_cracks(const CrackedBody& body, const Cracks& cracks) const {
    const Scene& present = body.scene();
    Case input = present.input;
    input.cracks = cracks;
    GrownScene grown;
    grown.finer = body.finer_about_ends_of(input.cracks);
    const BodyMesh& mesh = grown.finer ? grown.finer->scene.mesh : present.mesh;
    constexpr int as_fine_as_it_is = 1;
    grown.longer = std::make_unique<Scene>(make_scene(input, mesh, as_fine_as_it_is));
    if (grown.longer->enriched.tips.size() == present.enriched.tips.size()) return grown;
    note_("the next advance takes a crack out of the body: growth ends here");
    return {};
}

}  // namespace stria::coarse
