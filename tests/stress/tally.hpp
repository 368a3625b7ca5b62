// What random trials have found: the worst of each measure, what failed with its seed, and what was refused.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace stria::test {

class Tally {
public:
    /// A number that passes up to `limit`; NaN never does.
    void measure(const std::string& name, unsigned seed, double value, double limit);
    /// Something that must not happen.
    void fail(const std::string& name, unsigned seed, const std::string& text);
    /// A sentence to the user instead of an answer; numbers in it do not count.
    void refuse(const std::string& sentence, unsigned seed);

    void print() const;
    [[nodiscard]] bool clean() const { return failures_.empty(); }

private:
    struct Measure {
        std::vector<double> values;
        double worst = 0.0, limit = 0.0;
        unsigned worst_seed = 0;
    };
    struct Refusal {
        int count = 0;
        unsigned first_seed = 0;
    };
    std::map<std::string, Measure> measures_;
    std::map<std::string, Refusal> refusals_;
    std::vector<std::string> failures_;
};

}  // namespace stria::test
