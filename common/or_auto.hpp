// A value of the case file, or the word "auto" for what the program makes of it.
#pragma once

#include <optional>

namespace stria {

template <class M> class OrAuto {
public:
    OrAuto() = default;                 // auto
    OrAuto(M value) : given_(value) {}  // NOLINT(google-explicit-constructor): a value stands for itself

    [[nodiscard]] bool is_auto() const { return !given_; }
    [[nodiscard]] M value() const { return given_.value(); }
    [[nodiscard]] M value_or(M other) const { return given_.value_or(other); }
    bool operator==(const OrAuto&) const = default;

private:
    std::optional<M> given_;
};

}  // namespace stria
