// Measures a cycle while it passes.
#pragma once

#include <vector>

#include "coarse/increment.hpp"

namespace stria::coarse {

class CycleMeter {
public:
    CycleMeter() = default;
    CycleMeter(OpeningDefinition definition, const ClosureMeter& closure, std::size_t tips);

    /// Every increment, the one that ends a cycle included.
    void add(const Increment& increment);

    /// The cycle that the last increment has ended, one result a tip.
    std::vector<CycleResult> finish();

private:
    struct Path {  // of the load, one way
        std::vector<double> load, mouth;
    };
    struct Tip {
        CycleResult cycle;
        std::vector<char> changed, was_open;  // per signal
        std::vector<OpeningLoads> signal;
        Path down, up;
    };
    struct Station {  // what the next cycle starts from
        double nominal_K, J, CTOD, CMOD, load_factor;
        double forward, forward_axis;  // of flow while the crack grew at its load
    };
    void begin(int cycle);
    void measure(Tip& tip, const Increment& increment, std::size_t t) const;
    [[nodiscard]] OpeningLoads of_signal(const Tip& tip, std::size_t signal) const;

    OpeningDefinition definition_ = OpeningDefinition::Contact;
    std::size_t signals_ = 0, contact_signals_ = 0;
    int cycle_ = 0;
    double last_target_ = 0.0;
    std::vector<Tip> tips_;
    std::vector<Station> last_;
    std::vector<double> length_;  // when the last cycle, or the ramp, ended
};

}  // namespace stria::coarse
