// What a test asserts against a reference from outside, as a row of the table of docs/verification.md.
#pragma once

#include <string>
#include <utility>

namespace stria::test {

struct Comparison {
    std::string scene;          // what is computed
    std::string source;         // the publication, and its entry of docs/references.md where it has one
    std::string quantity = {};  // with its unit
    double reference = 0.0, ours = 0.0;
    double within = 0.0;  // the largest distance of the two that passes, as a share of `scale`
    std::string mesh = {};
    double scale = 0.0;  // the size of the reference, unless told otherwise
};

/// Fails the test where the two are farther apart than that. Adds a row to the file that the environment variable
/// STRIA_VERIFICATION names, if there is one: tools/verification_table.py makes the table of these.
void verify(const Comparison& comparison);

/// Calls verify() with `common` and what each row has for itself: (quantity, reference, ours).
[[nodiscard]] inline auto rows_of(Comparison common) {
    return [common = std::move(common)](const std::string& quantity, double reference, double ours) {
        Comparison row = common;
        row.quantity = quantity;
        row.reference = reference;
        row.ours = ours;
        verify(row);
    };
}

}  // namespace stria::test
